// BRDF coordinates as Open Shading Language runs them.

#include "shaders/brdf_agreement.h"
#include "shaders/osl_fixture.h"

namespace scree::test {
namespace {

TEST_F(Osl, BrdfCoordinatesAgree)
{
    constexpr size_t kOfRun = 18; // numbers that a run writes
    const auto cases = brdf_cases();
    write_image(temp_ / "cases.exr", brdf_image(cases));
    compile("tests/shaders/brdf_cases.osl");
    std::vector<BrdfOutputs> answers(cases.size());
    for (size_t part = 0; part < 3; ++part) {
        const RunResult result =
            shade(words("-g 1 " + std::to_string(cases.size()) +
                        " --param file cases.exr --param part " + std::to_string(part) +
                        " -o o0 o0.exr -o o1 o1.exr -o o2 o2.exr -o o3 o3.exr -o o4 o4.exr"
                        " -o o5 o5.exr brdf_cases"));
        ASSERT_EQ(result.status, 0) << result.said;
        for (size_t i = 0; i < kOfRun; ++i) {
            const Image image = output("o" + std::to_string(i / 3));
            ASSERT_EQ(image.height, static_cast<int>(cases.size()));
            for (size_t n = 0; n < cases.size(); ++n)
                answers[n][kOfRun * part + i] =
                    image.at(0, static_cast<int>(n), static_cast<int>(i % 3));
        }
    }
    expect_brdf_agreement(cases, answers, "OSL");
}

} // namespace
} // namespace scree::test
