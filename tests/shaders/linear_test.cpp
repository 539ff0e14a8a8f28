// Linear lights as GLSL and OSL read them, against the kernel in C++.

#include "shaders/gl_fixture.h"
#include "shaders/linear_agreement.h"
#include "shaders/osl_fixture.h"

namespace scree::test {
namespace {

constexpr int kOslOutputs = (kLinearOutputs + 2) / 3; ///< colors of three numbers

class GlslLinear : public Glsl {};

TEST_P(GlslLinear, LinearLightsAgreeWithCpp)
{
    const auto cases = linear_cases();
    const GLuint program =
        context().program({"tests/shaders/screen.vert"},
                          {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                           "src/kernel/scree_linear_light.h", "tests/kernel/linear_outputs.h",
                           "tests/shaders/linear_cases.frag"});
    context().bind(program,
                   {{"inputs", context().texture({linear_case_image(cases)}, GlFilter::nearest)}});
    const Image image = context().draw(program, kLinearOutputs / 4, static_cast<int>(cases.size()));
    std::vector<std::array<float, kLinearOutputs>> answers(cases.size());
    for (size_t row = 0; row < cases.size(); ++row)
        for (int i = 0; i < kLinearOutputs; ++i)
            answers[row][static_cast<size_t>(i)] = image.at(i / 4, static_cast<int>(row), i % 4);
    expect_linear_agreement(cases, answers, "GLSL " + glsl_version(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Kernel, GlslLinear, both_dialects(), dialect_name);

TEST_F(Osl, LinearLightsAgreeWithCpp)
{
    const auto cases = linear_cases();
    write_image(temp_ / "cases.exr", linear_case_image(cases));
    compile("tests/shaders/linear_cases.osl");
    std::vector<std::string> arguments = {"-g",      "1",    std::to_string(cases.size()),
                                          "--param", "file", "cases.exr"};
    for (int i = 0; i < kOslOutputs; ++i)
        for (const std::string& word :
             {std::string("-o"), "o" + std::to_string(i), "o" + std::to_string(i) + ".exr"})
            arguments.push_back(word);
    arguments.emplace_back("linear_cases");
    const RunResult result = shade(arguments);
    ASSERT_EQ(result.status, 0) << result.said;
    std::vector<std::array<float, kLinearOutputs>> answers(cases.size());
    for (int i = 0; i < kLinearOutputs; ++i) {
        const Image image = output("o" + std::to_string(i / 3));
        for (size_t row = 0; row < cases.size(); ++row)
            answers[row][static_cast<size_t>(i)] = image.at(0, static_cast<int>(row), i % 3);
    }
    expect_linear_agreement(cases, answers, "OSL");
}

} // namespace
} // namespace scree::test
