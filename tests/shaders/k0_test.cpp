// scree_k0.h as GLSL and OSL read it, against C++.

#include <fstream>

#include "kernel/k0_cases.h"
#include "shaders/doc_example.h"
#include "shaders/gl_fixture.h"
#include "shaders/osl_fixture.h"

namespace scree::test {
namespace {

/// The table of cases, a case a row of texels.
Image table(const std::vector<K0Case>& cases)
{
    Image image{kK0Inputs / 4, static_cast<int>(cases.size()), {"R", "G", "B", "A"}, {}};
    for (const K0Case& row : cases)
        image.pixels.insert(image.pixels.end(), row.in.begin(), row.in.end());
    return image;
}

class K0Glsl : public Glsl {};

TEST_P(K0Glsl, AgreesWithCppOnTheWholeTable)
{
    const auto cases = k0_cases();
    const GLuint program = context().program(
        {"tests/shaders/screen.vert"},
        {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h", "src/kernel/scree_k0.h",
         "tests/kernel/k0_case_outputs.h", "tests/shaders/k0_cases.frag"});
    context().bind(program, {{"inputs", context().texture({table(cases)}, GlFilter::nearest)}});
    const Image image = context().draw(program, kK0Outputs / 4, static_cast<int>(cases.size()));
    std::vector<std::array<float, kK0Outputs>> answers(cases.size());
    for (size_t i = 0; i < cases.size(); ++i)
        for (int k = 0; k < kK0Outputs; ++k)
            answers[i][static_cast<size_t>(k)] = image.at(k / 4, static_cast<int>(i), k % 4);
    expect_k0_agreement(cases, answers, "GLSL " + glsl_version(GetParam()));
}

TEST_P(K0Glsl, TheExampleOfTheDocsCompiles)
{
    const TempFolder temp;
    const std::string example = doc_example("glsl", "k0.md");
    ASSERT_FALSE(example.empty());
    std::ofstream(temp / "example.frag")
        << example
        << "out vec4 result;\n"
           "void main()\n"
           "{\n"
           "    vec3 h = normalize(vec3(gl_FragCoord.xy, 9.0));\n"
           "    result = vec4(halo(h, vec2(0.0), vec3(0.09, 0.02, 0.05), 0.5, 0.1));\n"
           "}\n";
    EXPECT_NE(context().program({"tests/shaders/screen.vert"},
                                {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                                 "src/kernel/scree_k0.h", (temp / "example.frag").string()}),
              0U);
}

INSTANTIATE_TEST_SUITE_P(Kernel, K0Glsl, both_dialects(), dialect_name);

class K0Osl : public Osl {};

TEST_F(K0Osl, AgreesWithCppOnTheWholeTable)
{
    const auto cases = k0_cases();
    write_image(temp_ / "cases.exr", table(cases));
    compile("tests/shaders/k0_cases.osl");
    const RunResult result =
        shade(words("-g 1 " + std::to_string(cases.size()) +
                    " --param file cases.exr -o o0 o0.exr -o o1 o1.exr -o o2 o2.exr -o o3 o3.exr "
                    "k0_cases"));
    ASSERT_EQ(result.status, 0) << result.said;
    std::vector<std::array<float, kK0Outputs>> answers(cases.size());
    for (int i = 0; i < kK0Outputs; ++i) {
        const Image image = output("o" + std::to_string(i / 3));
        ASSERT_EQ(image.height, static_cast<int>(cases.size()));
        for (size_t k = 0; k < cases.size(); ++k)
            answers[k][static_cast<size_t>(i)] = image.at(0, static_cast<int>(k), i % 3);
    }
    expect_k0_agreement(cases, answers, "OSL");
}

TEST_F(K0Osl, TheExampleOfTheDocsMirrorsTheView)
{
    std::ofstream(temp_ / "mirrored.osl") << doc_example("c", "k0.md");
    const RunResult compiled =
        run(temp_.path(), {tools_.oslc.string(), "-I" SCREE_SOURCE "/src", "mirrored.osl"});
    ASSERT_EQ(compiled.status, 0) << compiled.said;
    const RunResult result = shade(words("-g 1 1 -o wi wi.exr mirrored"));
    ASSERT_EQ(result.status, 0) << result.said;
    const Image wi = output("wi");
    const float square = wi.at(0, 0, 0) * wi.at(0, 0, 0) + wi.at(0, 0, 1) * wi.at(0, 0, 1) +
                         wi.at(0, 0, 2) * wi.at(0, 0, 2);
    EXPECT_NEAR(square, 1, 1e-5F);
}

} // namespace
} // namespace scree::test
