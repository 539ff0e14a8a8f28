// Linear lights as GLSL and OSL read them, against the kernel in C++.

#include <cmath>
#include <fstream>

#include "shaders/doc_example.h"
#include "shaders/gl_fixture.h"
#include "shaders/linear_agreement.h"
#include "shaders/osl_fixture.h"
#include "tables/linear_light_table.h"
#include "texset/table_file.h"

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

TEST_P(GlslLinear, TheExampleOfTheTablesCompiles)
{
    const TempFolder temp;
    std::ofstream(temp / "example.frag")
        << doc_example("glsl", "tables.md")
        << "out vec4 result;\n"
           "void main()\n"
           "{\n"
           "    vec3 n = vec3(0.0, 0.0, 1.0), v = normalize(vec3(gl_FragCoord.xy, 9.0));\n"
           "    result = vec4(linear_light(vec3(-1.0, 0.2, 1.0), vec3(1.0, 0.2, 1.0), -n, n, v,\n"
           "                               0.02));\n"
           "}\n";
    EXPECT_NE(
        context().program({"tests/shaders/screen.vert"},
                          {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                           "src/kernel/scree_linear_light.h", (temp / "example.frag").string()}),
        0U);
}

TEST_F(Osl, TheExampleOfTheTablesLooksUpWhatTheTableHolds)
{
    constexpr LinearLightResolution kSize = {32, 64, 32};
    const auto table = linear_light_table(LinearLightCoordinates::cone, kSize, [](double) {});
    write_table(linear_light_manifest(table.coordinates, kSize), table.values, temp_.path());
    std::ofstream(temp_ / "stretch.osl") << doc_example("c", "tables.md");
    const RunResult compiled =
        run(temp_.path(), {tools_.oslc.string(), "-I" SCREE_SOURCE "/src", "stretch.osl"});
    ASSERT_EQ(compiled.status, 0) << compiled.said;
    for (const float na : {0.2F, 0.5F, 0.9F}) {
        const float q = 0.37F, nb = 0.3F, ne = std::sqrt(1 - na * na - nb * nb);
        const float radius = std::sqrt(nb * nb + q * ne * ne);
        const RunResult result =
            shade({"-g", "1", "1", "--param", "q", std::to_string(q), "--param", "na",
                   std::to_string(na), "--param", "nb", std::to_string(nb), "--param", "radius",
                   std::to_string(radius), "-o", "found", "stretch.exr", "stretch"});
        ASSERT_EQ(result.status, 0) << result.said;
        const double want = kernel::scree_linear_stretch(
            static_cast<double>(q), static_cast<double>(na), static_cast<double>(nb * nb),
            static_cast<double>(q * ne * ne), 20);
        EXPECT_NEAR(output("stretch").at(0, 0, 0), want, 2e-3 * want); // interpolation
    }
}

} // namespace
} // namespace scree::test
