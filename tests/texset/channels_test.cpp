// The channel table against what a reader of a file sees.

#include "texset/channels.h"

#include <gtest/gtest.h>

#include <set>

#include "math/error.h"
#include "support/files.h"
#include "texset/mip_file.h"

namespace scree::test {
namespace {

TEST(Channels, TheOrderInTheTableIsTheOrderAnOpenImageIOReaderSees)
{
    ASSERT_FALSE(map_table().empty());
    for (const MapInfo& info : map_table()) {
        TempFolder temp;
        const auto path = temp / "one.exr";
        {
            MipFile file(path, {1, 1, info.channels, PixelType::float32, Compression::none, {}});
            TileRow row;
            file.prepare(row, 0, 0);
            for (size_t c = 0; c < info.channels.size(); ++c) {
                int pixels = 0;
                const float value = static_cast<float>(c) + 1;
                uint8_t* line = file.line(row, 0, 0, static_cast<int>(c), pixels);
                ASSERT_EQ(pixels, 1);
                std::copy_n(reinterpret_cast<const uint8_t*>(&value), sizeof value, line);
            }
            file.write(row);
            file.close();
        }
        const auto levels = read_levels(path);
        ASSERT_EQ(levels.size(), 1U) << info.name;
        EXPECT_EQ(levels[0].channels, info.channels) << info.name;
        for (size_t c = 0; c < info.channels.size(); ++c)
            EXPECT_EQ(levels[0].at(0, 0, static_cast<int>(c)), static_cast<float>(c) + 1)
                << info.name << " " << info.channels[c];
    }
}

// The names design.md section 8 fixes for readers; bumpslopes as maketx 2.4 writes them.
TEST(Channels, NamesAreThoseOfTheDesign)
{
    using Names = std::set<std::string>;
    auto names = [](Map map) {
        const auto& channels = map_info(map).channels;
        return Names(channels.begin(), channels.end());
    };
    EXPECT_EQ(names(Map::slope), (Names{"s", "t", "ss", "tt", "st"}));
    EXPECT_EQ(names(Map::height), (Names{"h", "hh"}));
    EXPECT_EQ(names(Map::color), (Names{"R", "G", "B"}));
    EXPECT_EQ(names(Map::colorheight), (Names{"R", "G", "B"}));
    EXPECT_EQ(names(Map::colorslope), (Names{"Rs", "Gs", "Bs", "Rt", "Gt", "Bt"}));
    EXPECT_EQ(names(Map::tail), (Names{"tau"}));
    EXPECT_EQ(names(Map::map), (Names{"R", "G", "B"}));
    EXPECT_EQ(names(Map::rank),
              (Names{"R1", "G1", "B1", "R2", "G2", "B2", "R3", "G3", "B3", "R4", "G4", "B4"}));
    EXPECT_EQ(rank_channels(2), (std::vector<std::string>{"B1", "B2", "G1", "G2", "R1", "R2"}));
    EXPECT_EQ(map_info(Map::bumpslopes).channels,
              (std::vector<std::string>{"b0_h", "b1_dhds", "b2_dhdt", "b3_dhds2", "b4_dhdt2",
                                        "b5_dh2dsdt"}));
}

TEST(Channels, EveryMapHasAnEntryOfItsOwn)
{
    std::set<std::string> names;
    for (const MapInfo& info : map_table()) {
        EXPECT_EQ(&map_info(info.map), &info) << info.name;
        EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
        EXPECT_FALSE(info.meaning.empty()) << info.name;
    }
}

TEST(Channels, UsersNameTheMapsTheyMayChooseAndNoOther)
{
    EXPECT_EQ(map_named("slope"), Map::slope);
    EXPECT_EQ(map_named("colorslope"), Map::colorslope);
    EXPECT_EQ(map_names(),
              "slope,height,color,colorheight,exponent,colorslope,rank,visible,map,tail");
    for (const char* name : {"bumpslopes", "coverage", "normals", ""})
        try {
            map_named(name);
            ADD_FAILURE() << "'" << name << "' was taken";
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(map_names()), std::string::npos) << e.what();
        }
}

} // namespace
} // namespace scree::test
