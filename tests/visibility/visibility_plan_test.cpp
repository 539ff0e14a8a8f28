// Where the nodes of a table of visibility go.

#include "visibility/visibility_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::test {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

double tangent(double angle_deg) { return std::tan(angle_deg * kRadian); }

TEST(NodeAngles, StayOnSteepSurfaces)
{
    for (int nodes = 1; nodes <= kMaxNodes; ++nodes)
        for (const double slope : {0.9, 1.5, 20.0})
            EXPECT_EQ(moved_node_angles(best_node_angles(nodes), slope), best_node_angles(nodes));
}

// At a slope of 1 / 6 hiding begins at tan theta = 6. The third of four nodes, 0.671 of the way
// from 1.428 to 19.08 in log tan, is at 6 (19.08 / 6)^0.731; both to the next eighth of a degree.
TEST(NodeAngles, GoToWhereHidingBegins)
{
    const auto moved = moved_node_angles({55, 74, 84, 87}, 1.0 / 6);
    ASSERT_EQ(moved.size(), 4U);
    EXPECT_NEAR(moved[0], 80.538, 1.0 / 16);
    EXPECT_EQ(8 * moved[0], std::round(8 * moved[0]));
    const double place = std::log(9.514364 / 1.428148) / std::log(19.081137 / 1.428148);
    EXPECT_NEAR(moved[2], std::atan(6 * std::pow(19.081137 / 6, place)) / kRadian, 1.0 / 16);
    EXPECT_EQ(moved[3], 87);
}

TEST(NodeAngles, RiseOnAnySurface)
{
    for (int nodes = 1; nodes <= kMaxNodes; ++nodes)
        for (const double slope : {0.0, 1e-9, 0.01, 0.1, 0.2, 0.3, 0.4, 0.5}) {
            const auto best = best_node_angles(nodes), moved = moved_node_angles(best, slope);
            EXPECT_EQ(moved.back(), best.back());
            for (size_t i = 0; i < moved.size(); ++i) {
                EXPECT_GE(moved[i], best[i]) << nodes << " nodes, slope " << slope;
                if (i > 0) {
                    EXPECT_GT(moved[i], moved[i - 1] + 0.1) << nodes << " nodes, slope " << slope;
                }
            }
        }
    EXPECT_NEAR(moved_node_angles({70, 87}, 0)[0], std::atan(tangent(87) / 2) / kRadian, 1.0 / 16);
}

} // namespace
} // namespace scree::test
