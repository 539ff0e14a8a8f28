#include "chart/pareto.h"

#include <gtest/gtest.h>

#include <limits>

namespace scree {
namespace {

TEST(Pareto, KeepsWhatNoOtherBeats)
{
    const std::vector<CostAndError> ways = {{1, 9}, {2, 5}, {2, 6},   {3, 5},
                                            {4, 1}, {5, 1}, {0.5, 10}};
    EXPECT_EQ(pareto_front(ways), (std::vector<bool>{true, true, false, false, true, false, true}));
}

TEST(Pareto, EqualsStayTogether)
{
    EXPECT_EQ(pareto_front({{1, 2}, {1, 2}, {2, 2}}), (std::vector<bool>{true, true, false}));
}

TEST(Pareto, WaysWithoutANumberAreLeftOut)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(pareto_front({{nan, 0}, {0, nan}, {-infinite, -infinite}, {3, 3}}),
              (std::vector<bool>{false, false, false, true}));
    EXPECT_TRUE(pareto_front({}).empty());
}

} // namespace
} // namespace scree
