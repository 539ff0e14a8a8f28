// One pair of directions and one set of coordinates in each row of the target: the 56 numbers of
// brdf_agreement.h in fourteen texels. Behind the preludes, the kernel and brdf_outputs.h.

uniform highp sampler2D inputs; // the 12 numbers of a case in three texels

out vec4 result;

void main()
{
    int row = int(gl_FragCoord.y);
    vec4 a = texelFetch(inputs, ivec2(0, row), 0);
    vec4 b = texelFetch(inputs, ivec2(1, row), 0);
    vec4 c = texelFetch(inputs, ivec2(2, row), 0);
    float o[56];
    brdf_coordinates(a.x, a.y, a.z, a.w, b.x, b.y, o[0], o[1], o[2], o[3], o[4], o[5], o[6], o[7],
                     o[8], o[9], o[10], o[11], o[12], o[13], o[14], o[15], o[16], o[17], o[18]);
    brdf_beyond(b.z, b.w, c.x, c.y, o[19], o[20], o[21], o[22], o[23], o[24], o[25], o[26], o[27],
                o[28], o[29], o[30], o[31], o[32], o[33]);
    scree_from_half_difference(o[0], o[1], o[2], o[3], o[34], o[35], o[36], o[37], o[38], o[39]);
    scree_from_orthographic(o[4], o[5], o[6], o[7], o[40], o[41], o[42], o[43], o[44], o[45]);
    scree_from_hybrid(o[8], o[9], o[10], o[11], o[46], o[47], o[48], o[49], o[50], o[51]);
    scree_hybrid_place(a.x, a.y, a.z, a.w, b.x, b.y, o[52], o[53], o[54]);
    o[55] = 0.0;
    int first = 4 * int(gl_FragCoord.x);
    result = vec4(o[first], o[first + 1], o[first + 2], o[first + 3]);
}
