// Sets of tiles, read back from their files.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>

#include "judge/set_reader.h"
#include "math/error.h"
#include "pipeline/bake.h"
#include "support/random_image.h"
#include "texset/texture_lookup.h"

namespace scree::test {
namespace {

constexpr int kSize = 96; // two strips of rows

/// Part of an image.
Image cut(const Image& from, int x0, int y0, int width, int height)
{
    Image part{width, height, from.channels, {}};
    for (int y = y0; y < y0 + height; ++y)
        for (int x = x0; x < x0 + width; ++x)
            for (size_t c = 0; c < from.channels.size(); ++c)
                part.pixels.push_back(from.at(x, y, static_cast<int>(c)));
    return part;
}

class UdimBake : public ::testing::Test {
protected:
    /// Writes a map of 2 x 2 tiles as one file and as tiles 1001, 1002, 1011 and 1012.
    void write(const std::string& name, const Image& whole) const
    {
        write_image(temp_ / (name + ".exr"), whole);
        for (int v = 0; v < 2; ++v)
            for (int u = 0; u < 2; ++u)
                write_image(temp_ / (name + "." + std::to_string(1001 + u + 10 * v) + ".exr"),
                            cut(whole, u * kSize, (1 - v) * kSize, kSize, kSize));
    }

    void SetUp() override
    {
        write("h", random_image(2 * kSize, 2 * kSize, {"Y"}, 5));
        write("c", random_image(2 * kSize, 2 * kSize, {"R", "G", "B"}, 6));
    }

    BakeOptions options(const std::string& files, const std::string& output) const
    {
        BakeOptions options;
        options.name = "test";
        options.height_file = temp_ / ("h" + files + ".exr");
        options.color_file = temp_ / ("c" + files + ".exr");
        options.height_scale = 0.01;
        options.texel_size = {{1.0 / kSize, 1.0 / kSize}};
        options.wrap_s = options.wrap_t = Wrap::clamp;
        options.pixel_type = PixelTypeChoice::float32;
        options.output = temp_ / output;
        return options;
    }
    BakeOptions tiles(const std::string& output) const { return options(".<UDIM>", output); }

    std::vector<Image> levels(const std::string& set, const std::string& map) const
    {
        return read_levels(temp_ / set / ("test." + map + ".exr"));
    }

    void obj(const std::string& text) const { std::ofstream(temp_ / "mesh.obj") << text; }

    TempFolder temp_;
};

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

// Four sheets, three of which meet: the fourth lies far off, and its corner is none of theirs.
TEST_F(UdimBake, CornersMeetAsSidesDo)
{
    const auto sheet = [](double x, double y, double z) {
        std::string text;
        for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
            text += "v " + std::to_string(x + dx) + " " + std::to_string(y + dy) + " " +
                    std::to_string(z) + "\n";
        return text;
    };
    for (const bool meets : {true, false}) {
        std::string text =
            sheet(0, 0, 0) + sheet(1, 0, 0) + sheet(0, 1, 0) + sheet(1, 1, meets ? 0 : 50) +
            "vt 0 0\nvt 1 0\nvt 2 0\nvt 0 1\nvt 1 1\nvt 2 1\nvt 0 2\nvt 1 2\nvt 2 2\n";
        const int corner[4][4] = {{1, 2, 5, 4}, {2, 3, 6, 5}, {4, 5, 8, 7}, {5, 6, 9, 8}};
        for (int s = 0; s < 4; ++s) {
            text += "f";
            for (int k = 0; k < 4; ++k)
                text += " " + std::to_string(4 * s + k + 1) + "/" + std::to_string(corner[s][k]);
            text += "\n";
        }
        obj(text);
        // All is flat but tile 1012.
        for (const char* number : {"1001", "1002", "1011", "1012"})
            write_image(temp_ / ("h." + std::string(number) + ".exr"),
                        Image{kSize,
                              kSize,
                              {"Y"},
                              std::vector<float>(static_cast<size_t>(kSize) * kSize,
                                                 std::string(number) == "1012" ? 1.0F : 0.0F)});
        BakeOptions o = tiles("set");
        o.texel_size.reset();
        o.mesh_file = temp_ / "mesh.obj";
        bake(o, {});
        const Image slope = levels("set", "1001.slope")[0];
        EXPECT_EQ(slope.at(kSize - 1, 0, 0) != 0, meets);
        EXPECT_EQ(slope.at(kSize - 2, 0, 0), 0);
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

// Meshes over tiles.

/// A sheet of two squares over tiles 1001 and 1002; the second `gap` further to the right.
std::string two_sheets(double gap)
{
    const auto v = [](double x, double y) {
        return "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    };
    return v(0, 0) + v(1, 0) + v(1, 1) + v(0, 1) + v(1 + gap, 0) + v(2 + gap, 0) + v(2 + gap, 1) +
           v(1 + gap, 1) +
           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 2 1\nf 1/1 2/2 3/3 4/4\n"
           "f 5/2 6/5 7/6 8/3\n";
}

TEST_F(UdimBake, MeshesSayWhichBordersMeet)
{
    BakeOptions one = options("", "one");
    bake(one, {});
    const auto truth = levels("one", "slope")[0];
    for (const bool meet : {true, false}) {
        obj(two_sheets(meet ? 0 : 1));
        BakeOptions o = tiles("sheet");
        o.texel_size.reset();
        o.mesh_file = temp_ / "mesh.obj";
        const Manifest set = bake(o, {});
        ASSERT_EQ(set.tiles.size(), 2U); // no face reaches into 1011 and 1012
        EXPECT_NE(set.warnings.front().find("tiles 1011, 1012: no face"), std::string::npos);
        EXPECT_EQ(set.mesh->covered, 2 * kSize * kSize);
        EXPECT_EQ(set.mesh->charts, 2);
        EXPECT_NEAR(set.mesh->area, 2, 1e-6);
        EXPECT_EQ(set.tiles[1].mesh->covered, kSize * kSize);
        const Image left = levels("sheet", "1001.slope")[0];
        const Image right = levels("sheet", "1002.slope")[0];
        // Away from the rows at the top of the tiles, which the map goes on from.
        for (int y = 1; y < kSize; ++y)
            for (int c = 0; c < 5; ++c) {
                const double expected = static_cast<double>(truth.at(kSize - 1, kSize + y, c));
                const double beside = static_cast<double>(truth.at(kSize, kSize + y, c));
                if (meet) {
                    ASSERT_NEAR(left.at(kSize - 1, y, c), expected, 1e-5) << y << ' ' << c;
                    ASSERT_NEAR(right.at(0, y, c), beside, 1e-5) << y << ' ' << c;
                } else if (c == 0) {
                    ASSERT_GT(
                        std::abs(left.at(kSize - 1, y, c) - truth.at(kSize - 1, kSize + y, c)),
                        1e-4)
                        << y;
                }
                ASSERT_NEAR(left.at(kSize / 2, y, c), truth.at(kSize / 2, kSize + y, c), 1e-5);
            }
    }
}

// One face over both tiles is the same sheet.
TEST_F(UdimBake, FacesMayCrossBorders)
{
    const auto bake_on = [&](const std::string& text, const std::string& name) {
        obj(text);
        BakeOptions o = tiles(name);
        o.texel_size.reset();
        o.mesh_file = temp_ / "mesh.obj";
        bake(o, {});
        return levels(name, "1002.slope");
    };
    const auto two = bake_on(two_sheets(0), "two");
    const auto crossing = bake_on("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 1\n"
                                  "vt 0 1\nf 1/1 2/2 3/3 4/4\n",
                                  "crossing");
    for (size_t l = 0; l < two.size(); ++l)
        for (size_t i = 0; i < two[l].pixels.size(); ++i)
            ASSERT_NEAR(two[l].pixels[i], crossing[l].pixels[i], 1e-5F) << l;
}

// Weights are those of one surface: a tile of twice the length counts twice.
TEST_F(UdimBake, TilesOfAMeshShareOneNormalisation)
{
    const auto flat = [&](const std::string& name, float height) {
        write_image(temp_ / name, Image{4, 4, {"Y"}, std::vector<float>(16, height)});
    };
    flat("f.1001.exr", 0);
    flat("f.1002.exr", 3);
    obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 7 0 0\nv 7 1 0\nv 5 1 0\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 2 1\nf 1/1 2/2 3/3 4/4\nf 5/2 6/5 7/6 8/3\n");
    BakeOptions o = tiles("set");
    o.height_file = temp_ / "f.<UDIM>.exr";
    o.color_file.clear();
    o.texel_size.reset();
    o.height_scale = 1;
    o.mesh_file = temp_ / "mesh.obj";
    const Manifest set = bake(o, {});
    EXPECT_NEAR(set.h0, 2, 1e-6);
    EXPECT_NEAR(set.h1, std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(levels("set", "1001.coverage")[0].at(1, 1, 0), 0.5, 1e-6);
    EXPECT_NEAR(levels("set", "1002.coverage")[0].at(1, 1, 0), 1, 1e-6);
    EXPECT_NEAR(levels("set", "1001.height")[0].at(1, 1, 0), -2 / std::sqrt(2.0), 1e-6);
}

TEST_F(UdimBake, TilesThatAMeshHasAndFilesHaveNot)
{
    obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 1 0\nvt 4 0\nvt 4 1\nvt 1 1\n"
        "f 1/1 2/2 3/3 4/4\n");
    BakeOptions o = tiles("set");
    o.texel_size.reset();
    o.mesh_file = temp_ / "mesh.obj";
    const Manifest set = bake(o, {});
    ASSERT_EQ(set.tiles.size(), 1U);
    EXPECT_NE(set.warnings[0].find("tiles 1003, 1004: no "), std::string::npos) << set.warnings[0];
    // A single map is for 1001.
    BakeOptions single = options("", "single");
    single.texel_size.reset();
    single.mesh_file = o.mesh_file;
    try {
        bake(single, {});
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("reach into tiles 1002, 1003, 1004"),
                  std::string::npos)
            << e.what();
    }
}

// A cylinder closes on itself: the map's left border meets its right one, without being told.
TEST_F(UdimBake, AMapOnAClosedSurfaceMeetsItself)
{
    constexpr int kFaces = 24;
    std::string text;
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i < kFaces; ++i) {
            const double angle = 2 * std::acos(-1.0) * i / kFaces;
            text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) +
                    " " + std::to_string(ring) + "\n";
        }
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i <= kFaces; ++i)
            text += "vt " + std::to_string(static_cast<double>(i) / kFaces) + " " +
                    std::to_string(ring) + "\n";
    const auto face = [](int vertex, int uv) {
        return " " + std::to_string(vertex + 1) + "/" + std::to_string(uv + 1);
    };
    for (int i = 0; i < kFaces; ++i) {
        const int next = (i + 1) % kFaces;
        text += "f" + face(i, i) + face(next, i + 1) + face(kFaces + next, kFaces + i + 2) +
                face(kFaces + i, kFaces + i + 1) + "\n";
    }
    obj(text);
    BakeOptions around = options(".1001", "around");
    around.texel_size.reset();
    around.mesh_file = temp_ / "mesh.obj";
    around.wrap_s = around.wrap_t = Wrap::periodic;
    bake(around, {});
    BakeOptions plane = options(".1001", "plane");
    plane.wrap_s = Wrap::periodic; // and t ends
    bake(plane, {});
    const Image on_mesh = levels("around", "slope")[0], on_plane = levels("plane", "slope")[0];
    // The surface is even along t; along s its length varies by the cage's facets.
    for (int y = 0; y < kSize; ++y)
        for (const int x : {0, 1, kSize - 1}) {
            const double by_t = static_cast<double>(on_plane.at(x, y, 3));
            ASSERT_NEAR(on_mesh.at(x, y, 3), by_t, 1e-3 * std::max(1.0, std::abs(by_t)))
                << x << ' ' << y;
            const double by_s = static_cast<double>(on_plane.at(x, y, 0)) / (2 * std::acos(-1.0));
            ASSERT_NEAR(on_mesh.at(x, y, 0), by_s, 0.02 * std::max(0.1, std::abs(by_s)))
                << x << ' ' << y;
        }
}

} // namespace
} // namespace scree::test
