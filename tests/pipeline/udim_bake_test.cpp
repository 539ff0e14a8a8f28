// Sets of tiles on a plane, read back from their files.

#include <atomic>
#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>

#include "judge/set_reader.h"
#include "math/error.h"
#include "pipeline/bake.h"
#include "pipeline/tiled_files.h"
#include "texset/texture_lookup.h"

namespace scree::test {
namespace {

using UdimBake = TiledFiles;

// The sobel and central slopes of a texel see 8 neighbours, bilinear ones as well.
TEST_F(UdimBake, TilesThatMeetAreBakedAsOneMap)
{
    for (const Reconstruction reconstruction :
         {Reconstruction::bilinear, Reconstruction::central, Reconstruction::sobel}) {
        BakeOptions one = options("", "one"), many = tiles("many");
        one.reconstruction = many.reconstruction = reconstruction;
        many.udim_wrap = true;
        const Manifest whole = bake(one, {}), set = bake(many, {});
        EXPECT_TRUE(set.warnings.empty()) << set.warnings.front();
        EXPECT_NEAR(set.h0, whole.h0, 1e-15);
        EXPECT_NEAR(set.h1, whole.h1, 1e-15);
        EXPECT_EQ(set.height_min, whole.height_min);
        EXPECT_EQ(set.height_max, whole.height_max);
        ASSERT_EQ(set.tiles.size(), 4U);
        EXPECT_TRUE(set.levels.empty());
        for (const TextureRecord& texture : set.textures) {
            const std::string map = map_info(texture.map).name;
            EXPECT_EQ(texture.file, "test.<UDIM>." + map + ".exr");
            const auto truth = levels("one", map);
            for (int tile = 0; tile < 4; ++tile) {
                const int u = tile % 2, v = tile / 2;
                const int number = set.tiles[static_cast<size_t>(tile)].number;
                EXPECT_EQ(number, 1001 + u + 10 * v);
                const auto baked = levels("many", std::to_string(number) + "." + map);
                // Both have the same texels as long as they divide by 2.
                for (size_t l = 0; l < 5; ++l) {
                    const int side = kSize >> l;
                    const Image part = cut(truth[l], u * side, (1 - v) * side, side, side);
                    ASSERT_EQ(baked[l].pixels.size(), part.pixels.size());
                    for (size_t i = 0; i < part.pixels.size(); ++i)
                        ASSERT_NEAR(baked[l].pixels[i], part.pixels[i],
                                    2e-6F * std::max(1.0F, std::abs(part.pixels[i])))
                            << map << ' ' << number << ' ' << l << ' ' << i;
                }
            }
        }
    }
}

TEST_F(UdimBake, TilesThatDoNotMeetAreBakedAsMapsOfTheirOwn)
{
    bake(tiles("many"), {});
    for (const int number : {1001, 1012}) {
        const std::string name = "." + std::to_string(number);
        bake(options(name, "one"), {});
        EXPECT_EQ(levels("many", name.substr(1) + ".slope")[0].pixels,
                  levels("one", "slope")[0].pixels);
    }
}

// A ramp, over tiles of two resolutions, and of a third of another height.
TEST_F(UdimBake, ARampGivesNoSeam)
{
    const auto ramp = [](int width, int height, int u, int v) {
        Image image{width, height, {"Y"}, {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                image.pixels.push_back(static_cast<float>(2 * (u + (x + 0.5) / width) -
                                                          3 * (v + 1 - (y + 0.5) / height)));
        return image;
    };
    write_image(temp_ / "r.1001.exr", ramp(64, 64, 0, 0));
    write_image(temp_ / "r.1002.exr", ramp(160, 160, 1, 0));
    write_image(temp_ / "r.1011.exr", ramp(32, 32, 0, 1));
    BakeOptions o = tiles("ramp");
    o.height_file = temp_ / "r.<UDIM>.exr";
    o.color_file.clear();
    o.height_scale = 0.5;
    o.texel_size.reset();
    o.udim_wrap = true;
    const Manifest set = bake(o, {});
    EXPECT_EQ(set.width, 160);
    for (const char* number : {"1001", "1002", "1011"})
        for (const Image& level : levels("ramp", std::string(number) + ".slope"))
            for (int y = 0; y < level.height; ++y)
                for (int x = 0; x < level.width; ++x) {
                    // s ss st t tt, t down
                    ASSERT_NEAR(level.at(x, y, 0), 1, 1e-4) << number << ' ' << x << ' ' << y;
                    ASSERT_NEAR(level.at(x, y, 3), 1.5, 1e-4) << number;
                    ASSERT_NEAR(level.at(x, y, 1), 1, 1e-4) << number;
                    ASSERT_NEAR(level.at(x, y, 4), 2.25, 2e-4) << number;
                }
}

// A step at the border: there a tile that ends differs from one that goes on.
TEST_F(UdimBake, AStepSeesTheTileBeyondTheBorder)
{
    Image wave{2 * kSize, 2 * kSize, {"Y"}, {}};
    for (int y = 0; y < 2 * kSize; ++y)
        for (int x = 0; x < 2 * kSize; ++x)
            wave.pixels.push_back(x < kSize ? 0.0F : 1.0F); // a step
    write("w", wave);
    const auto slope_at_border = [&](bool udim_wrap) {
        BakeOptions o = tiles("wave");
        o.height_file = temp_ / "w.<UDIM>.exr";
        o.color_file.clear();
        o.reconstruction = Reconstruction::central;
        o.udim_wrap = udim_wrap;
        bake(o, {});
        return levels("wave", "1001.slope")[0].at(kSize - 1, kSize / 2, 0);
    };
    EXPECT_NEAR(slope_at_border(true), 0.01 * kSize / 2, 1e-6);
    EXPECT_EQ(slope_at_border(false), 0);
}

TEST_F(UdimBake, MissingTilesAreReported)
{
    std::filesystem::remove(temp_ / "c.1002.exr");
    std::filesystem::remove(temp_ / "h.1011.exr");
    std::filesystem::copy_file(temp_ / "h.1001.exr", temp_ / "h.1004.exr");
    std::filesystem::copy_file(temp_ / "c.1001.exr", temp_ / "c.1004.exr");
    const Manifest set = bake(tiles("set"), {});
    std::vector<int> numbers;
    for (const TileRecord& tile : set.tiles)
        numbers.push_back(tile.number);
    EXPECT_EQ(numbers, (std::vector<int>{1001, 1004, 1012}));
    const std::string all =
        std::accumulate(set.warnings.begin(), set.warnings.end(), std::string());
    EXPECT_NE(all.find("tile 1002: no "), std::string::npos) << all;
    EXPECT_NE(all.find("c.<UDIM>.exr; left out"), std::string::npos) << all;
    EXPECT_NE(all.find("tile 1011: no "), std::string::npos) << all;
    EXPECT_NE(all.find("tile 1003: no "), std::string::npos) << all;
    EXPECT_EQ(all.find("tiles 1002, 1003"), std::string::npos) << all;
    EXPECT_FALSE(std::filesystem::exists(temp_ / "set" / "test.1002.slope.exr"));
    // The next bake replaces the whole set.
    std::filesystem::remove(temp_ / "h.1004.exr");
    bake(tiles("set"), {});
    EXPECT_FALSE(std::filesystem::exists(temp_ / "set" / "test.1004.slope.exr"));
    EXPECT_TRUE(std::filesystem::exists(temp_ / "set" / "test.1012.slope.exr"));
}

TEST_F(UdimBake, AFailedTileLeavesNothing)
{
    std::ofstream(temp_ / "h.1012.exr") << "no image";
    EXPECT_THROW(bake(tiles("set"), {}), Error);
    EXPECT_FALSE(std::filesystem::exists(temp_ / "set"));
}

TEST_F(UdimBake, ATileWithoutDataIsLeftOut)
{
    const Image nothing{
        kSize, kSize, {"Y"}, std::vector<float>(static_cast<size_t>(kSize) * kSize, std::nanf(""))};
    write_image(temp_ / "h.1002.exr", nothing);
    const Manifest set = bake(tiles("set"), {});
    EXPECT_EQ(set.tiles.size(), 3U);
    EXPECT_NE(set.warnings.front().find("tile 1002: "), std::string::npos) << set.warnings.front();
    for (const char* number : {"1001", "1011", "1012"})
        write_image(temp_ / ("h." + std::string(number) + ".exr"), nothing);
    EXPECT_THROW(bake(tiles("none"), {}), Error);
    EXPECT_FALSE(std::filesystem::exists(temp_ / "none"));
}

// Holes up to the border: the tile beyond it sees what one map would.
TEST_F(UdimBake, HolesAtABorderAreHolesForTheNeighbour)
{
    Image heights = random_image(2 * kSize, 2 * kSize, {"Y"}, 9);
    for (int y = 0; y < 2 * kSize; ++y)
        for (int x = 0; x < 2 * kSize; ++x)
            if ((x * 7 + y * 5) % 11 < 3)
                heights.pixels[static_cast<size_t>(y) * 2 * kSize + static_cast<size_t>(x)] =
                    std::nanf("");
    write("h", heights);
    for (const Wrap wrap : {Wrap::clamp, Wrap::black, Wrap::mirror})
        for (const Reconstruction reconstruction :
             {Reconstruction::bilinear, Reconstruction::central, Reconstruction::sobel}) {
            BakeOptions one = options("", "one"), many = tiles("many");
            for (BakeOptions* o : {&one, &many}) {
                o->wrap_s = o->wrap_t = wrap;
                o->reconstruction = reconstruction;
                o->maps = {Map::slope};
            }
            many.udim_wrap = true;
            bake(one, {});
            bake(many, {});
            const Image truth = levels("one", "slope")[0], known = levels("one", "coverage")[0];
            for (int tile = 0; tile < 4; ++tile) {
                const int u = tile % 2, v = tile / 2;
                const Image baked = levels("many", std::to_string(1001 + u + 10 * v) + ".slope")[0];
                const Image part = cut(truth, u * kSize, (1 - v) * kSize, kSize, kSize);
                const Image has = cut(known, u * kSize, (1 - v) * kSize, kSize, kSize);
                for (size_t i = 0; i < part.pixels.size(); ++i) {
                    if (!(has.pixels[i / 5] > 0))
                        continue;
                    ASSERT_NEAR(baked.pixels[i], part.pixels[i], 1e-5F)
                        << tile << ' ' << i / 5 % kSize << ' ' << i / 5 / kSize;
                }
            }
        }
}

TEST_F(UdimBake, WhatDoesNotGoWithTilesIsRefused)
{
    const std::pair<const char*, std::function<void(BakeOptions&)>> cases[] = {
        {"single maps only", [](BakeOptions& o) { o.auto_maps = true; }},
        {"single maps only", [](BakeOptions& o) { o.visibility = Visibility::tables; }},
        {"name the tiles of both", [&](BakeOptions& o) { o.color_file = temp_ / "c.exr"; }},
        {"--udim-wrap",
         [&](BakeOptions& o) {
             o = options("", "refused");
             o.udim_wrap = true;
         }},
        {"--wrap periodic",
         [](BakeOptions& o) {
             o.udim_wrap = true;
             o.wrap_t = Wrap::periodic;
         }},
        {"there is no tile", [&](BakeOptions& o) { o.height_file = temp_ / "x.<UDIM>.exr"; }},
        {"--world-size, that of a tile",
         [&](BakeOptions& o) {
             write_image(temp_ / "h.1002.exr", random_image(2 * kSize, 2 * kSize, {"Y"}, 1));
             o.color_file.clear();
         }},
        {"--world-size W H", [&](BakeOptions& o) {
             write_image(temp_ / "h.1002.exr", random_image(2 * kSize, kSize, {"Y"}, 1));
             o.color_file.clear();
             o.texel_size.reset();
         }}};
    for (const auto& [words, change] : cases) {
        BakeOptions o = tiles("refused");
        change(o);
        try {
            bake(o, {});
            ADD_FAILURE() << words;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
        }
        EXPECT_FALSE(std::filesystem::exists(temp_ / "refused"));
    }
}

TEST_F(UdimBake, OnePixelTypeForAllTiles)
{
    // Slopes of the one tile are far from 0 and hardly differ, which half storage loses.
    Image ramp = random_image(kSize, kSize, {"Y"}, 7, 0, 0.1F);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            ramp.pixels[static_cast<size_t>(y * kSize + x)] += 100 * static_cast<float>(x);
    for (const auto& [number, type] :
         {std::pair(1012, PixelType::float32), std::pair(0, PixelType::half)}) {
        if (number != 0)
            write_image(temp_ / "h.1012.exr", ramp);
        else
            write_image(temp_ / "h.1012.exr", random_image(kSize, kSize, {"Y"}, 8));
        BakeOptions o = tiles("types");
        o.pixel_type = PixelTypeChoice::automatic;
        const Manifest set = bake(o, {});
        EXPECT_EQ(set.textures.front().map, Map::slope);
        EXPECT_EQ(set.textures.front().type, type);
        EXPECT_EQ(*set.textures.front().half_error <= 0.01, type == PixelType::half);
    }
}

TEST_F(UdimBake, SameBytesWithAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 5}) {
        BakeOptions o = tiles("set" + std::to_string(threads));
        o.threads = threads;
        o.udim_wrap = true;
        bake(o, {});
    }
    for (const auto& entry : std::filesystem::directory_iterator(temp_ / "set1"))
        for (const char* other : {"set2", "set5"})
            EXPECT_EQ(read_bytes(entry.path()),
                      read_bytes(temp_ / other / entry.path().filename().string()))
                << entry.path();
}

TEST_F(UdimBake, ReadersTakeOneTileAtATime)
{
    bake(tiles("set"), {});
    EXPECT_THROW(SetReader(temp_ / "set"), Error);
    EXPECT_THROW(SetReader(temp_ / "set", 1003), Error);
    SetReader reader(temp_ / "set", 1011);
    EXPECT_EQ(reader.manifest().width, kSize);
    EXPECT_EQ(reader.manifest().inputs.size(), 2U);
    const Image color = levels("set", "1011.color")[0];
    EXPECT_EQ(reader.row(0, 7)[5].color[1], color.at(5, 7, 1));
    // A renderer gives its texture system the name with <UDIM> and coordinates beyond 1: v up.
    const Manifest set = read_manifest(temp_ / "set");
    const TextureLookup lookup(temp_ / "set", set);
    for (int v = 0; v < 2; ++v)
        for (int u = 0; u < 2; ++u) {
            const std::string number = std::to_string(1001 + u + 10 * v);
            const Image tile = levels("set", number + ".color")[0];
            TexturePlace place;
            place.s = static_cast<float>(u + (20.5) / kSize);
            place.t = static_cast<float>(v + (30.5) / kSize);
            std::array<float, 3> rgb{};
            lookup.read(Map::color, place, 0, 3, rgb.data());
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(rgb[static_cast<size_t>(c)], tile.at(20, 30, c), 1e-5) << number;
        }
}

// A stop while tiles are written is a stop, whatever they say of other ends.
TEST_F(UdimBake, StoppedWhileItWrites)
{
    std::atomic<bool> cancel{false};
    BakeMonitor monitor;
    monitor.cancel = &cancel;
    monitor.progress = [&](const char* phase, double done) {
        cancel = cancel || (std::string(phase) == "bake" && done > 0.3);
    };
    EXPECT_THROW(bake(tiles("set"), monitor), Cancelled);
    EXPECT_TRUE(cancel);
    EXPECT_FALSE(std::filesystem::exists(temp_ / "set"));
}

} // namespace
} // namespace scree::test
