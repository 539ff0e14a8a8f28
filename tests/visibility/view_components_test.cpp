// Components of tables and views: a plane, where what is seen is known, and sums of sweeps.

#include "visibility/view_components.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "visibility/memory_heights.h"
#include "visibility/visible_bands.h"

namespace scree::test {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

std::vector<std::vector<float>> see(const HeightGrid& heights, const ViewComponents& components,
                                    const TexelBlock& block)
{
    std::vector<std::vector<float>> planes(
        static_cast<size_t>(components.count()),
        std::vector<float>(static_cast<size_t>(block.width) * static_cast<size_t>(block.height)));
    std::vector<float*> pointers;
    for (auto& plane : planes)
        pointers.push_back(plane.data());
    components.see(heights, block, pointers.data());
    return planes;
}

/// On a plane of slope (s, t) that ends, nothing hides anything: v - 1 = -tan(theta) (s, t) . d.
TEST(ViewComponents, OfAPlaneAreItsFirstHarmonicAlone)
{
    constexpr int kSize = 24;
    constexpr double kS = 0.03, kT = -0.02;
    HeightGrid::Shape shape;
    shape.width = shape.height = kSize;
    shape.edge_s = shape.edge_t = Edge::extend;
    std::vector<float> heights;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            heights.push_back(static_cast<float>(kS * x + kT * y));
    const MemoryHeights grid(shape, heights);
    const VisibilityPlan plan{{45, 80}, 2, 8};
    const ViewAngles view{70, 130};
    const ViewComponents components({plan}, {view});
    ASSERT_EQ(components.count(), 2 * 5 + 1);
    const auto planes = see(grid, components, {8, 8, 8, 8});
    for (size_t node = 0; node < 2; ++node) {
        const double tangent = std::tan(plan.node_angles_deg[node] * kRadian);
        const double expected[] = {0, -tangent * kS, 0, -tangent * kT, 0}; // 1, c1, c2, s1, s2
        for (size_t term = 0; term < 5; ++term)
            for (const float value : planes[5 * node + term])
                EXPECT_NEAR(static_cast<double>(value), expected[term], 2e-5 * tangent)
                    << "node " << node << " term " << term;
    }
    const double along =
        kS * std::cos(view.azimuth_deg * kRadian) + kT * std::sin(view.azimuth_deg * kRadian);
    for (const float value : planes.back())
        EXPECT_NEAR(static_cast<double>(value), -std::tan(view.angle_deg * kRadian) * along, 1e-4);
}

MemoryHeights rough(int width, int height)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<float> number(0, 0.6F);
    HeightGrid::Shape shape;
    shape.width = width;
    shape.height = height;
    std::vector<float> heights;
    for (int i = 0; i < width * height; ++i)
        heights.push_back(number(random));
    return {shape, heights};
}

TEST(ViewComponents, AreFourierSumsOfSweeps)
{
    const MemoryHeights grid = rough(40, 32);
    const TexelBlock block{4, 8, 16, 16};
    const VisibilityPlan plan{{65}, 1, 8};
    const auto planes = see(grid, ViewComponents({plan}, {}), block);
    std::vector<double> expected[3] = {std::vector<double>(256), std::vector<double>(256),
                                       std::vector<double>(256)};
    for (int j = 0; j < 8; ++j) {
        const double azimuth = (j + 0.25) * 45 * kRadian;
        std::vector<float> visible(256);
        float* pointer = visible.data();
        sweep(grid, block, azimuth, {1 / std::tan(65 * kRadian)}, &pointer);
        for (size_t i = 0; i < 256; ++i) {
            const double excess = static_cast<double>(visible[i]) - 1;
            expected[0][i] += excess / 8;
            expected[1][i] += excess * std::cos(azimuth) / 4;
            expected[2][i] += excess * std::sin(azimuth) / 4;
        }
    }
    for (size_t term = 0; term < 3; ++term)
        for (size_t i = 0; i < 256; ++i)
            ASSERT_NEAR(static_cast<double>(planes[term][i]), expected[term][i], 1e-5);
}

TEST(VisibleBands, HoldWhatTheirBlocksSee)
{
    const MemoryHeights grid = rough(530, 2 * kBandRows + 9); // more than a block wide
    const ViewComponents components({VisibilityPlan{{70}, 1, 4}}, {{40, 10}});
    VisibleBands bands(grid, components);
    for (const int y : {0, kBandRows - 1, kBandRows, 2 * kBandRows + 8}) {
        const auto band = bands.with_row(y);
        EXPECT_EQ(band, bands.with_row(y)) << "the last one is kept";
        const auto planes = see(grid, components, {0, y, 530, 1});
        for (int c = 0; c < components.count(); ++c)
            for (int x = 0; x < 530; ++x)
                ASSERT_EQ(*band->at(c, x, y),
                          planes[static_cast<size_t>(c)][static_cast<size_t>(x)])
                    << "component " << c << " at " << x << ", " << y;
    }
}

} // namespace
} // namespace scree::test
