// Sweeps of detail a few texels wide, whose color changes with its height, against rays.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "reference/gather.h"
#include "visibility/swept.h"

namespace scree {
namespace {

constexpr int kSize = 64;

// None along an axis: there two lines meet a texel at two places only.
const std::vector<double> kAzimuths = {11.25,  33.75, 45,     78.75, 123.75,
                                       168.75, 225,   236.25, 303.75};
const std::vector<double> kThetas = {45, 70, 80};

/// A map that repeats: what is high is white, the rest is black.
struct Detail {
    std::string name;
    double height;       ///< of what is high, texels
    double texel_height; ///< over the texels' width
    double off;          ///< colors, by sweeps, root mean square
    std::function<bool(int x, int y)> is_high;
};

/// What sweeps may be off by: the rays' noise, up to 0.0015, and the chords of the parabolas that
/// profiles are between their nodes, which more lines a texel do not mend (walls that stand aslant
/// 0.009, blocks 0.003). With a step for one texel, and nodes on rows only, they were off by
/// 0.0287, 0.0085, 0.0184, 0.0249, 0.0287 and 0.0117 of what is square here.
const Detail kDetails[] = {
    {"walls of 1", 1.2, 1, 0.002, [](int x, int) { return x % 4 == 0; }},
    {"walls of 2", 1.2, 1, 0.002, [](int x, int) { return x % 8 < 2; }},
    {"slanted walls of 1", 1.2, 1, 0.011, [](int x, int y) { return (2 * x + y) % 8 < 2; }},
    {"blocks of 4x4", 1.2, 1, 0.004, [](int x, int y) { return (x / 4 + y / 4) % 2 == 0; }},
    {"blocks of 2x2", 0.6, 1, 0.004, [](int x, int y) { return (x / 2 + y / 2) % 2 == 0; }},
    {"checkerboard", 0.3, 1, 0.002, [](int x, int y) { return (x + y) % 2 == 0; }},
    {"flat blocks of 4x4", 1.2, 0.6, 0.004, [](int x, int y) { return (x / 4 + y / 4) % 2 == 0; }},
};

reference::Relief relief_of(const Detail& detail)
{
    reference::Relief relief = test::relief_of(
        kSize, kSize, [&](int x, int y) { return detail.is_high(x, y) ? detail.height : 0; });
    relief.texel_height = detail.texel_height;
    for (const double h : relief.heights)
        relief.colors.push_back(h > 0 ? reference::Rgb{1, 1, 1} : reference::Rgb{0, 0, 0});
    return relief;
}

/// White of the map as a whole: azimuths x angles.
std::vector<double> white_to_rays(const reference::Relief& relief)
{
    reference::GatherPlan plan;
    plan.grid = 3 * kSize;
    for (const double azimuth : kAzimuths)
        for (const double theta : kThetas)
            plan.views.push_back(test::direction(theta, azimuth));
    const auto whole = reference::footprint_of(kSize, kSize, 6, 0, 0);
    const auto rays = reference::gather_all(reference::DisplacedSurface(relief), {whole}, plan);
    std::vector<double> white;
    for (const reference::Seen& seen : rays[0].all.seen)
        white.push_back(seen.color[0]);
    return white;
}

std::vector<double> white_to_sweeps(const reference::Relief& relief)
{
    HeightGrid::Shape shape = test::shape_of(kSize, kSize);
    shape.texel_height = relief.texel_height;
    const MemoryHeights grid = test::heights_of(
        shape, [&](int x, int y) { return relief.heights[test::index_of(x, y, kSize)]; });
    std::vector<double> shares;
    for (const double azimuth : kAzimuths)
        for (const auto& seen : test::swept(grid, test::whole_block(grid), azimuth, kThetas)) {
            double white = 0, all = 0;
            for (size_t i = 0; i < seen.size(); ++i) {
                all += static_cast<double>(seen[i]);
                white += relief.colors[i][0] * static_cast<double>(seen[i]);
            }
            shares.push_back(white / all);
        }
    return shares;
}

TEST(Sweep, SeesTheColorsOfSmallDetail)
{
    for (const Detail& detail : kDetails) {
        const reference::Relief relief = relief_of(detail);
        const std::vector<double> want = white_to_rays(relief), got = white_to_sweeps(relief);
        ASSERT_EQ(want.size(), got.size());
        double squares = 0;
        for (size_t i = 0; i < want.size(); ++i)
            squares += (got[i] - want[i]) * (got[i] - want[i]) / static_cast<double>(want.size());
        EXPECT_LT(std::sqrt(squares), detail.off) << detail.name;
    }
}

} // namespace
} // namespace scree
