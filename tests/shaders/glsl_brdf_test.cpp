// BRDF coordinates as GLSL reads them.

#include "shaders/brdf_agreement.h"
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

} // namespace
} // namespace scree::test
