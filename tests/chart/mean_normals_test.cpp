#include "chart/mean_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree {
namespace {

using Slope = filter::Vec2<float>;

reference::Relief flat(int width, int height)
{
    reference::Relief relief;
    relief.width = width;
    relief.height = height;
    relief.heights.assign(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
    return relief;
}

constexpr double kHalf = 0.5e-3; ///< rounding to half floats, below 1

TEST(MeanNormals, OfAPlaneAreItsNormal)
{
    const MeanNormals normals(flat(4, 4), std::vector<Slope>(16, Slope(0.75F, -1)));
    const Vec3f n = normals.over(reference::footprint_of(4, 4, 2, 0, 0));
    const double length = std::sqrt(1 + 0.75 * 0.75 + 1);
    EXPECT_NEAR(n.x, -0.75 / length, kHalf);
    EXPECT_NEAR(n.y, 1 / length, kHalf);
    EXPECT_NEAR(n.z, 1 / length, kHalf);
}

TEST(MeanNormals, OfAGrooveAreShort)
{
    std::vector<Slope> slopes(16, Slope(0.5F, 0));
    for (size_t i = 1; i < slopes.size(); i += 2)
        slopes[i].x = -0.5F;
    const MeanNormals normals(flat(4, 4), slopes);
    const Vec3f n = normals.over(reference::footprint_of(4, 4, 1, 1, 0));
    EXPECT_NEAR(n.x, 0, kHalf);
    EXPECT_NEAR(n.z, 1 / std::sqrt(1.25), kHalf);
}

// Three texels become one at level 1: shares of a third. The heaviest has no data.
TEST(MeanNormals, CountByShareAndWeight)
{
    reference::Relief relief = flat(3, 1);
    relief.weights = {1, 3, 5};
    relief.heights[2] = std::numeric_limits<double>::quiet_NaN();
    const MeanNormals normals(relief, {Slope(0, 0), Slope(0.75F, 0), Slope(9, 9)});
    const Vec3f n = normals.over(reference::footprint_of(3, 1, 1, 0, 0));
    EXPECT_NEAR(n.x, 0.75 * -0.6, kHalf); // normals (0, 0, 1) and (-0.6, 0, 0.8)
    EXPECT_NEAR(n.y, 0, kHalf);
    EXPECT_NEAR(n.z, 0.25 + 0.75 * 0.8, kHalf);
}

} // namespace
} // namespace scree
