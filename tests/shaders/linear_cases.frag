// One row of the table of linear lights in each row of the target: the 20 numbers of
// linear_outputs() in five texels. Behind prelude_glsl.h, scree_filter.h, scree_linear_light.h and
// linear_outputs.h.

uniform highp sampler2D inputs; // the 18 numbers of a case and two zeros in five texels

out vec4 result;

void main()
{
    int row = int(gl_FragCoord.y);
    float i[20];
    for (int texel = 0; texel < 5; ++texel) {
        vec4 four = texelFetch(inputs, ivec2(texel, row), 0);
        for (int k = 0; k < 4; ++k)
            i[4 * texel + k] = four[k];
    }
    float o[20];
    linear_outputs(i[0], i[1], i[2], i[3], i[4], i[5], i[6], i[7], i[8], i[9], i[10], i[11], i[12],
                   i[13], i[14], i[15], i[16], i[17], o[0], o[1], o[2], o[3], o[4], o[5], o[6],
                   o[7], o[8], o[9], o[10], o[11], o[12], o[13], o[14], o[15], o[16], o[17], o[18],
                   o[19]);
    int first = 4 * int(gl_FragCoord.x);
    result = vec4(o[first], o[first + 1], o[first + 2], o[first + 3]);
}
