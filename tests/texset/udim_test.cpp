#include "texset/udim.h"

#include <gtest/gtest.h>

#include <fstream>

#include "math/error.h"
#include "support/files.h"

namespace scree::test {
namespace {

TEST(Udim, NumbersCountTensToTheRightThenUp)
{
    EXPECT_EQ((UdimTile{0, 0}.number()), 1001);
    EXPECT_EQ((UdimTile{9, 0}.number()), 1010);
    EXPECT_EQ((UdimTile{0, 1}.number()), 1011);
    EXPECT_EQ((UdimTile{3, 27}.number()), 1274);
    for (int number = kFirstUdim; number <= kLastUdim; ++number) {
        const UdimTile tile = udim_tile(number);
        ASSERT_TRUE(has_number(tile));
        ASSERT_EQ(tile.number(), number);
    }
    EXPECT_FALSE(has_number({-1, 0}));
    EXPECT_FALSE(has_number({10, 0}));
    EXPECT_FALSE(has_number({0, -1}));
    EXPECT_FALSE(has_number({9, 899})); // 10000
    EXPECT_TRUE(has_number({8, 899}));
}

TEST(Udim, NamesOfTiles)
{
    EXPECT_TRUE(is_tiled("a/rock.<UDIM>.exr"));
    EXPECT_FALSE(is_tiled("a/rock.1001.exr"));
    EXPECT_EQ(file_of_tile("a/rock.<UDIM>.exr", 1011), "a/rock.1011.exr");
    EXPECT_EQ(file_of_tile("a/rock.exr", 1011), "a/rock.exr");
    EXPECT_EQ(stem_of("a/rock.<UDIM>.exr"), "rock");
    EXPECT_EQ(stem_of("rock_<UDIM>.exr"), "rock");
    EXPECT_EQ(stem_of("rock<UDIM>.disp.tif"), "rock.disp");
    EXPECT_EQ(stem_of("<UDIM>.rock.exr"), "rock");
    EXPECT_EQ(stem_of("<UDIM>.exr"), "");
    EXPECT_EQ(stem_of("rock.exr"), "rock");
    EXPECT_EQ(tile_list({1001, 1002, 1011}), "1001, 1002, 1011");
    EXPECT_EQ(tile_list({1001, 1002, 1011}, 2), "1001, 1002 and 1 more");
}

TEST(Udim, FindsTheFilesThatAreThere)
{
    const TempFolder folder;
    for (const char* name : {"r.1001.exr", "r.1012.exr", "r.1000.exr", "r.10011.exr", "r.1x01.exr",
                             "r.1002.exr.bak", "s.1003.exr", "r.9999.exr"})
        std::ofstream(folder / name) << "x";
    EXPECT_EQ(tiles_of(folder / "r.<UDIM>.exr"), (std::vector<int>{1001, 1012, 9999}));
    EXPECT_TRUE(tiles_of(folder / "q.<UDIM>.exr").empty());
    for (const char* bad :
         {"r.<UDIM>.<UDIM>.exr", "<UDIM>/r.exr", "<UDIM>/r.<UDIM>.exr", "nowhere/r.<UDIM>.exr"})
        EXPECT_THROW((void)tiles_of(folder / bad), Error) << bad;
}

} // namespace
} // namespace scree::test
