// One row of the table of cases in each row of the target: the 40 numbers of case_outputs() in
// ten texels. Behind prelude_glsl.h, scree_filter.h and case_outputs.h.

uniform highp sampler2D inputs; // the 44 numbers of a case in eleven texels

out vec4 result;

void main()
{
    int row = int(gl_FragCoord.y);
    float i[44];
    for (int texel = 0; texel < 11; ++texel) {
        vec4 four = texelFetch(inputs, ivec2(texel, row), 0);
        for (int k = 0; k < 4; ++k)
            i[4 * texel + k] = four[k];
    }
    float o[40];
    case_outputs(i[0], i[1], i[2], i[3], i[4], i[5], i[6], i[7], i[8], i[9], i[10], i[11], i[12],
                 i[13], i[14], i[15], i[16], i[17], i[18], i[19], i[20], i[21], i[22], i[23], i[24],
                 i[25], i[26], i[27], i[28], i[29], i[30], i[31], i[32], i[33], i[34], i[35], i[36],
                 i[37], i[38], i[39], i[40], i[41], i[42], i[43], o[0], o[1], o[2], o[3], o[4], o[5], o[6], o[7], o[8], o[9],
                 o[10], o[11], o[12], o[13], o[14], o[15], o[16], o[17], o[18], o[19], o[20], o[21],
                 o[22], o[23], o[24], o[25], o[26], o[27], o[28], o[29], o[30], o[31], o[32], o[33],
                 o[34], o[35], o[36], o[37], o[38], o[39]);
    int first = 4 * int(gl_FragCoord.x);
    result = vec4(o[first], o[first + 1], o[first + 2], o[first + 3]);
}
