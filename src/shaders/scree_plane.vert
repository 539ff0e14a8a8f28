// A rectangle in the plane z = 0 without vertex buffers: four vertices, drawn as a triangle strip.

uniform vec4 rectangle;     // x0, y0, x1, y1 in world units
uniform mat4 world_to_clip;

out vec3 position; // world

void main()
{
    position = vec3((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
                    (gl_VertexID & 2) == 0 ? rectangle.y : rectangle.w, 0.0);
    gl_Position = world_to_clip * vec4(position, 1.0);
}
