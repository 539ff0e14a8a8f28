// The kernel as GLSL reads it, against the kernel in C++.

#include <fstream>

#include "kernel/cases.h"
#include "shaders/agreement.h"
#include "shaders/doc_example.h"
#include "shaders/gl_fixture.h"

namespace scree::test {
namespace {

/// The table of cases, a case a row of pixels.
std::vector<Outputs<float>> evaluate_in_glsl(GlContext& context,
                                             const std::vector<KernelCase>& cases)
{
    static_assert(kInputs == 44 && kOutputs == 40, "kernel_cases.frag counts on them");
    Image inputs{kInputs / 4, static_cast<int>(cases.size()), {"R", "G", "B", "A"}, {}};
    for (const KernelCase& row : cases)
        inputs.pixels.insert(inputs.pixels.end(), row.in.begin(), row.in.end());
    const GLuint program =
        context.program({"tests/shaders/screen.vert"},
                        {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                         "tests/kernel/case_outputs.h", "tests/shaders/kernel_cases.frag"});
    context.bind(program, {{"inputs", context.texture({inputs}, GlFilter::nearest)}});
    const Image image = context.draw(program, (kOutputs + 3) / 4, inputs.height);
    std::vector<Outputs<float>> out(cases.size());
    for (size_t i = 0; i < cases.size(); ++i)
        for (int k = 0; k < kOutputs; ++k)
            out[i][static_cast<size_t>(k)] = image.at(k / 4, static_cast<int>(i), k % 4);
    return out;
}

TEST_P(Glsl, KernelAgreesWithCppOnTheWholeTable)
{
    const auto cases = kernel_cases();
    expect_agreement(cases, evaluate_in_glsl(context(), cases), "GLSL " + glsl_version(GetParam()));
}

TEST_P(Glsl, TheExampleOfTheDocsCompiles)
{
    const TempFolder temp;
    std::ofstream(temp / "example.frag") << doc_example("glsl");
    std::ofstream(temp / "example.vert") << "out vec2 st;\n"
                                            "out vec3 to_viewer;\n"
                                            "void main()\n"
                                            "{\n"
                                            "    st = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                                            "    to_viewer = vec3(0.0, 0.0, 1.0);\n"
                                            "    gl_Position = vec4(2.0 * st - 1.0, 0.0, 1.0);\n"
                                            "}\n";
    EXPECT_NE(context().program({(temp / "example.vert").string()},
                                {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                                 "src/shaders/scree_set.glsl", "src/shaders/scree_visible.glsl",
                                 (temp / "example.frag").string()}),
              0U);
}

INSTANTIATE_TEST_SUITE_P(Kernel, Glsl, both_dialects(), dialect_name);

} // namespace
} // namespace scree::test
