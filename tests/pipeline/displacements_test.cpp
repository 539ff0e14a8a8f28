#include "pipeline/displacements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::test {
namespace {

TEST(Displacements, LargestAndItsPlace)
{
    Displacements found;
    EXPECT_EQ(found.largest(), 0);
    EXPECT_EQ(found.quantile(0.99), 0);
    found.add(0.25F, 1, 3, 4);
    found.add(0.75F, 1, 5, 6);
    found.add(0.75F, 1, 7, 8);
    found.add(std::numeric_limits<float>::quiet_NaN(), 1, 9, 9);
    EXPECT_EQ(found.largest(), 0.75);
    EXPECT_EQ(found.place_of_largest(), (std::array<int, 2>{5, 6}));
    EXPECT_EQ(found.quantile(1), 0.75);
    found.clear();
    EXPECT_EQ(found.largest(), 0);
}

// Of 1/n, 2/n, ... 1 with equal areas the share q stays below q.
TEST(Displacements, QuantilesAreRoundedUpByASixteenthAtMost)
{
    Displacements found;
    constexpr int kCount = 100000;
    for (int i = 1; i <= kCount; ++i)
        found.add(static_cast<float>(i) / kCount, 2, 0, 0);
    for (const double share : {0.001, 0.01, 0.3, 0.5, 0.9, 0.99}) {
        EXPECT_GE(found.quantile(share), share);
        EXPECT_LE(found.quantile(share), share * (17.0 / 16) + 1e-5) << share;
    }
}

TEST(Displacements, TexelsCountByTheirArea)
{
    Displacements found;
    found.add(1, 1, 0, 0);
    found.add(0.001F, 999, 0, 0);
    EXPECT_LT(found.quantile(0.99), 0.0011);
    found.add(2, 999, 0, 0);
    EXPECT_EQ(found.quantile(0.99), 2);
}

} // namespace
} // namespace scree::test
