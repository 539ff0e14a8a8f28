// Which surfaces are too high to follow rays over.
#include "judge/ray_reach.h"

#include <gtest/gtest.h>

namespace scree::test {
namespace {

using reference::Beyond;

/// A map 8 world units wide and 2 high, level but for one texel.
std::string said_of(double peak, Beyond beyond_s, Beyond beyond_t)
{
    reference::Relief relief;
    relief.width = 16;
    relief.height = 8;
    relief.texel_width = 0.5;
    relief.texel_height = 0.25;
    relief.heights.assign(128, 10);
    relief.heights[37] = peak;
    relief.beyond_s = beyond_s;
    relief.beyond_t = beyond_t;
    return too_high_for_rays(reference::DisplacedSurface(std::move(relief)));
}

TEST(RayReach, HeightsMayRangeOverAHundredWidthsOfAMapThatGoesOn)
{
    for (const Beyond on : {Beyond::repeats, Beyond::mirrors}) {
        EXPECT_EQ(said_of(10 + 799, on, Beyond::extends), "");
        EXPECT_NE(said_of(10 + 801, on, Beyond::extends), "");
        EXPECT_NE(said_of(10 - 801, on, Beyond::extends), "");
        EXPECT_EQ(said_of(10 + 199, Beyond::extends, on), "");
        EXPECT_NE(said_of(10 + 201, Beyond::extends, on), "");
        EXPECT_NE(said_of(10 + 201, on, on), "") << "the narrower way counts";
    }
}

TEST(RayReach, RaysLeaveAMapThatEndsHoweverHighItIs)
{
    for (const Beyond end : {Beyond::extends, Beyond::ends})
        EXPECT_EQ(said_of(1e9, end, end), "");
}

TEST(RayReach, ItIsSaidWhichWayAndWhatToDo)
{
    const std::string said = said_of(10 + 1000, Beyond::ends, Beyond::mirrors);
    // Beyond the end the height is 0.
    EXPECT_NE(said.find("1.01e+03, 505 times the width of the map along t"), std::string::npos)
        << said;
    EXPECT_NE(said.find("--height-scale"), std::string::npos) << said;
}

} // namespace
} // namespace scree::test
