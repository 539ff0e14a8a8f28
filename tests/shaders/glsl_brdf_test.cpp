// BRDF coordinates as GLSL reads them.

#include <fstream>

#include "shaders/brdf_agreement.h"
#include "shaders/doc_example.h"
#include "shaders/gl_fixture.h"

namespace scree::test {
namespace {

TEST_P(Glsl, BrdfCoordinatesAgree)
{
    const auto cases = brdf_cases();
    const GLuint program =
        context().program({"tests/shaders/screen.vert"},
                          {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                           "src/kernel/scree_brdf_coordinates.h", "tests/kernel/brdf_outputs.h",
                           "tests/shaders/brdf_cases.frag"});
    context().bind(program,
                   {{"inputs", context().texture({brdf_image(cases)}, GlFilter::nearest)}});
    std::vector<BrdfOutputs> answers(cases.size());
    const int texels = static_cast<int>(answers[0].size()) / 4;
    const Image image = context().draw(program, texels, static_cast<int>(cases.size()));
    for (size_t n = 0; n < cases.size(); ++n)
        for (int k = 0; k < 4 * texels; ++k)
            answers[n][static_cast<size_t>(k)] = image.at(k / 4, static_cast<int>(n), k % 4);
    expect_brdf_agreement(cases, answers, "GLSL " + glsl_version(GetParam()));
}

TEST_P(Glsl, TheExampleOfBrdfTablesCompiles)
{
    const TempFolder temp;
    std::ofstream(temp / "example.frag")
        << doc_example("glsl", "brdf-parametrizations.md")
        << "out vec4 result;\n"
           "void main()\n"
           "{\n"
           "    vec3 w = normalize(vec3(gl_FragCoord.xy, 9.0));\n"
           "    result = vec4(reflected(vec3(0.0, 0.0, 1.0), w), 1.0);\n"
           "}\n";
    EXPECT_NE(context().program({"tests/shaders/screen.vert"},
                                {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                                 "src/kernel/scree_brdf_coordinates.h",
                                 (temp / "example.frag").string()}),
              0U);
}

} // namespace
} // namespace scree::test
