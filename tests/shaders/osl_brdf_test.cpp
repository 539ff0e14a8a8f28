// BRDF coordinates as Open Shading Language runs them.

#include <cmath>
#include <fstream>

#include "shaders/brdf_agreement.h"
#include "shaders/doc_example.h"
#include "shaders/osl_fixture.h"
#include "tables/brdf_table.h"
#include "texset/table_file.h"

namespace scree::test {
namespace {

TEST_F(Osl, BrdfCoordinatesAgree)
{
    constexpr size_t kOfRun = 21; // numbers that a run writes
    const auto cases = brdf_cases();
    write_image(temp_ / "cases.exr", brdf_image(cases));
    compile("tests/shaders/brdf_cases.osl");
    std::vector<BrdfOutputs> answers(cases.size());
    for (size_t part = 0; part < 3; ++part) {
        const RunResult result =
            shade(words("-g 1 " + std::to_string(cases.size()) +
                        " --param file cases.exr --param part " + std::to_string(part) +
                        " -o o0 o0.exr -o o1 o1.exr -o o2 o2.exr -o o3 o3.exr -o o4 o4.exr"
                        " -o o5 o5.exr -o o6 o6.exr brdf_cases"));
        ASSERT_EQ(result.status, 0) << result.said;
        for (size_t i = 0; i < kOfRun && kOfRun * part + i < answers[0].size(); ++i) {
            const Image image = output("o" + std::to_string(i / 3));
            ASSERT_EQ(image.height, static_cast<int>(cases.size()));
            for (size_t n = 0; n < cases.size(); ++n)
                answers[n][kOfRun * part + i] =
                    image.at(0, static_cast<int>(n), static_cast<int>(i % 3));
        }
    }
    expect_brdf_agreement(cases, answers, "OSL");
}

std::string triple(const Imath::V3d& v)
{
    return std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z);
}

TEST_F(Osl, TheExampleOfBrdfTablesLooksUpWhatTheTableHolds)
{
    const BrdfGrid grid; // as the command makes it
    const auto smooth = [](const filter::Directions<double>& w) {
        return Rgbf{static_cast<float>(1 + w.wo.z * w.wi.z), static_cast<float>(w.wo.z + w.wi.z),
                    static_cast<float>(2 + w.wo.dot(w.wi))};
    };
    const auto values = brdf_table(grid, smooth, [](double) {});
    write_table(brdf_manifest(grid), values, temp_.path());
    std::ofstream(temp_ / "brdf.osl") << doc_example("c", "brdf-parametrizations.md");
    const RunResult compiled =
        run(temp_.path(), {tools_.oslc.string(), "-I" SCREE_SOURCE "/src", "brdf.osl"});
    ASSERT_EQ(compiled.status, 0) << compiled.said;
    for (const double light : {0.1, 0.6, 1.2}) {
        const filter::Directions<double> w{Imath::V3d(0.5, 0.3, 0.6).normalized(),
                                           {std::sin(light), 0, std::cos(light)}};
        const RunResult result =
            shade(words("-g 1 1 --param:type=vector wo " + triple(w.wo) +
                        " --param:type=vector wi " + triple(w.wi) + " -o found found.exr brdf"));
        ASSERT_EQ(result.status, 0) << result.said;
        const auto want = look_up(grid, values, 3, w);
        for (int c = 0; c < 3; ++c)
            // 2^-8 of a texel: how finely a texture unit tells places apart
            EXPECT_NEAR(output("found").at(0, 0, c), want[static_cast<size_t>(c)], 1e-3) << light;
    }
}

} // namespace
} // namespace scree::test
