// Bakes for a mesh, read back from their files.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "math/error.h"
#include "pipeline/bake.h"
#include "support/random_image.h"
#include "surface/metric.h"
#include "texset/texture_lookup.h"

namespace scree::test {
namespace {

constexpr int kSize = 96; // two strips of rows

/// A parallelogram over the whole texture: P = corner + u along + v up, in the plane.
std::string parallelogram(const Vec3& along, const Vec3& up)
{
    const Vec3 corner(3, -2, 5);
    std::string text;
    for (const Vec3& p : {corner, corner + along, corner + along + up, corner + up})
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
                "\n";
    return text + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
}

class MeshBake : public ::testing::Test {
protected:
    void SetUp() override
    {
        write_image(temp_ / "h.exr", random_image(kSize, kSize, {"Y"}, 5));
        write_image(temp_ / "c.exr", random_image(kSize, kSize, {"R", "G", "B"}, 6));
    }

    BakeOptions options(const std::string& name) const
    {
        BakeOptions options;
        options.name = "test";
        options.height_file = temp_ / "h.exr";
        options.color_file = temp_ / "c.exr";
        options.height_scale = 0.01;
        options.pixel_type = PixelTypeChoice::float32;
        options.output = temp_ / name;
        return options;
    }

    Manifest bake_on(const std::string& obj, const std::string& name,
                     const std::function<void(BakeOptions&)>& change = {})
    {
        std::ofstream(temp_ / (name + ".obj")) << obj;
        BakeOptions o = options(name);
        o.mesh_file = temp_ / (name + ".obj");
        if (change)
            change(o);
        return bake(o, {});
    }

    std::vector<Image> levels(const std::string& name, const std::string& map) const
    {
        return read_levels(temp_ / name / ("test." + map + ".exr"));
    }

    TempFolder temp_;
};

struct SlopeMoments {
    Vec2 mean;
    SlopeCovariance raw;
};

SlopeMoments moments_at(const Image& slope, int x, int y)
{
    const auto at = [&](int c) { return static_cast<double>(slope.at(x, y, c)); }; // s ss st t tt
    return {Vec2(at(0), at(3)), {at(1), at(2), at(4)}};
}

// The texture alone, one unit wide, against the same on parallelograms: J is the same everywhere,
// and slopes of all levels go through it. 1e-5 of the largest moment.
TEST_F(MeshBake, SlopesOfAffineTexturesGoThroughTheLaw)
{
    BakeOptions flat = options("flat");
    flat.texel_size = {{1.0 / kSize, 1.0 / kSize}};
    flat.wrap_s = flat.wrap_t = Wrap::clamp; // a parallelogram does not meet itself
    bake(flat, {});
    const auto before = levels("flat", "slope");
    int number = 0;
    for (const auto& [along, up] :
         {std::pair(Vec3(2, 0, 0), Vec3(0, 2, 0)), std::pair(Vec3(0, 0, 3), Vec3(0, 0.5, 0)),
          std::pair(Vec3(1, 1, 0), Vec3(-1, 1, 2)), std::pair(Vec3(1, 0, 0), Vec3(2, 0.5, 0)),
          std::pair(Vec3(-0.4, 0.1, 0), Vec3(0.3, 0.7, 0))}) {
        const std::string name = "mesh" + std::to_string(number++);
        bake_on(parallelogram(along, up), name);
        const auto after = levels(name, "slope");
        // By the angle between dP/ds and dP/dt = -up, not by metric.h.
        const double xs = along.length(), xt = -(along ^ up) / xs;
        const double yt = std::sqrt(up.length2() - xt * xt);
        const auto mapped = [&](const Vec2& g) {
            return Vec2(g.x / xs, (g.y - xt * g.x / xs) / yt);
        };
        ASSERT_EQ(after.size(), before.size());
        for (size_t l = 0; l < after.size(); ++l)
            for (int y = 0; y < after[l].height; ++y)
                for (int x = 0; x < after[l].width; ++x) {
                    const SlopeMoments was = moments_at(before[l], x, y),
                                       is = moments_at(after[l], x, y);
                    const Vec2 mean = mapped(was.mean);
                    // Columns of the raw moments, then rows.
                    const Vec2 first = mapped({was.raw.xx, was.raw.xy}),
                               second = mapped({was.raw.xy, was.raw.yy});
                    const Vec2 xx = mapped({first.x, second.x}), yy = mapped({first.y, second.y});
                    const double size = xx.x + yy.y;
                    ASSERT_NEAR(is.mean.x, mean.x, 1e-5 * std::sqrt(size)) << name << ' ' << l;
                    ASSERT_NEAR(is.mean.y, mean.y, 1e-5 * std::sqrt(size)) << name << ' ' << l;
                    ASSERT_NEAR(is.raw.xx, xx.x, 1e-5 * size) << name << ' ' << l;
                    ASSERT_NEAR(is.raw.xy, xx.y, 1e-5 * size) << name << ' ' << l;
                    ASSERT_NEAR(is.raw.yy, yy.y, 1e-5 * size) << name << ' ' << l;
                }
        // A linear map of the slopes keeps Mardia's kurtosis, level by level.
        const auto tails_before = levels("flat", "tail"), tails = levels(name, "tail");
        for (size_t l = 0; l < tails.size(); ++l)
            for (size_t i = 0; i < tails[l].pixels.size(); ++i)
                ASSERT_NEAR(tails[l].pixels[i], tails_before[l].pixels[i], 2e-4F)
                    << name << ' ' << l;
        // Colors and heights do not know of it.
        for (const char* map : {"color", "height", "colorheight"}) {
            const auto was = levels("flat", map), is = levels(name, map);
            for (size_t l = 0; l < is.size(); ++l)
                EXPECT_EQ(is[l].pixels, was[l].pixels) << map << ' ' << l;
        }
    }
}

// Mirrored: the texture from its back, so that s runs the other way on the surface.
TEST_F(MeshBake, MirroredTexturesHaveTheSlopesOfTheirOwnFrame)
{
    bake_on(parallelogram(Vec3(1, 0, 0), Vec3(0, 1, 0)), "plain");
    bake_on("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\n"
            "f 1/1 2/2 3/3 4/4\n",
            "mirrored");
    const auto plain = levels("plain", "slope"), mirrored = levels("mirrored", "slope");
    for (size_t l = 0; l < plain.size(); ++l)
        for (size_t i = 0; i < plain[l].pixels.size(); ++i)
            ASSERT_NEAR(mirrored[l].pixels[i], plain[l].pixels[i], 1e-5F) << l;
    EXPECT_EQ(read_manifest(temp_ / "mirrored").mesh->mirrored, kSize * kSize);
}

// Two squares side by side in the texture, one ten times as large on the surface; a third of the
// texture is in no chart.
TEST_F(MeshBake, TexelsCountByTheirAreaAndOutsideNotAtAll)
{
    Image color{kSize, kSize, {"R", "G", "B"}, {}};
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            color.pixels.insert(color.pixels.end(),
                                {x < kSize / 3 ? 1.0F : 0.0F,
                                 x >= kSize / 3 && x < 2 * kSize / 3 ? 1.0F : 0.0F, 1.0F});
    write_image(temp_ / "c.exr", color);
    const std::string third = "0.33333333333333", thirds = "0.66666666666667";
    const Manifest manifest =
        bake_on("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 15 0 0\nv 15 1 0\nv 5 1 0\n"
                "vt 0 0\nvt " +
                    third + " 0\nvt " + third + " 1\nvt 0 1\nvt " + thirds + " 0\nvt " + thirds +
                    " 1\nf 1/1 2/2 3/3 4/4\nf 5/2 6/5 7/6 8/3\n",
                "two");
    EXPECT_EQ(manifest.mesh->covered, kSize * kSize * 2 / 3);
    EXPECT_EQ(manifest.no_data_texels, kSize * kSize / 3);
    EXPECT_NEAR(manifest.mesh->area, 11, 1e-5);
    const Image top = levels("two", "color").back();
    EXPECT_NEAR(top.at(0, 0, 0), 1.0 / 11, 1e-6);
    EXPECT_NEAR(top.at(0, 0, 1), 10.0 / 11, 1e-6);
    EXPECT_NEAR(top.at(0, 0, 2), 1, 1e-6);
    const auto coverage = levels("two", "coverage");
    EXPECT_NEAR(coverage[0].at(1, 1, 0), 0.1, 1e-6);
    EXPECT_EQ(coverage[0].at(kSize / 2, 1, 0), 1);
    EXPECT_EQ(coverage[0].at(kSize - 2, 1, 0), 0);
    EXPECT_NEAR(coverage.back().at(0, 0, 0), 1.1 / 3, 1e-6);
}

// A cylinder of radius 2, upright: curvature 1/2, heights to 0.01. As a closed cage of 64 faces.
TEST_F(MeshBake, ReportsHowSmallDisplacementIs)
{
    std::string obj;
    constexpr int kFaces = 64;
    const double pi = std::acos(-1.0);
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i < kFaces; ++i)
            obj += "v " + std::to_string(2 * std::cos(2 * pi * i / kFaces)) + " " +
                   std::to_string(2 * std::sin(2 * pi * i / kFaces)) + " " +
                   std::to_string(ring * 3) + "\n";
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i <= kFaces; ++i)
            obj += "vt " + std::to_string(static_cast<double>(i) / kFaces) + " " +
                   std::to_string(ring) + "\n";
    for (int i = 0; i < kFaces; ++i) {
        const int next = (i + 1) % kFaces;
        const auto corner = [](int vertex, int uv) {
            return " " + std::to_string(vertex + 1) + "/" + std::to_string(uv + 1);
        };
        obj += "f" + corner(i, i) + corner(next, i + 1) +
               corner(kFaces + next, kFaces + 1 + i + 1) + corner(kFaces + i, kFaces + 1 + i) +
               "\n";
    }
    const Manifest small = bake_on(obj, "small");
    EXPECT_NEAR(small.mesh->area, 2 * pi * 2 * 3, 0.02 * 12 * pi);
    EXPECT_NEAR(small.mesh->largest_displacement, 0.01 / 2, 0.01 * 0.005);
    EXPECT_TRUE(small.warnings.empty());
    const auto [x, y] = small.mesh->displaced_most;
    const Image heights = read_levels(temp_ / "h.exr")[0];
    for (const float h : heights.pixels)
        EXPECT_LE(h, heights.at(x, y, 0) * 1.001F);
    const Manifest large = bake_on(obj, "large", [](BakeOptions& o) { o.height_scale = 1; });
    ASSERT_FALSE(large.warnings.empty());
    EXPECT_NE(large.warnings[0].find("height times curvature reaches 0.5"), std::string::npos)
        << large.warnings[0];
}

// A disc in the middle of the texture, around which heights and colors are wild: what a renderer
// looks up inside, at every level and between levels, is of the disc alone.
TEST_F(MeshBake, LookupsNearTheBorderOfAChartReadNothingFromOutside)
{
    constexpr int kCorners = 12;
    std::string disc;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / kCorners;
        disc += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) +
                " 0\nvt " + std::to_string(0.5 + 0.37 * std::cos(angle)) + " " +
                std::to_string(0.5 + 0.37 * std::sin(angle)) + "\n";
    }
    disc += "v 0 0 0\nvt 0.5 0.5\n";
    for (int i = 0; i < kCorners; ++i)
        disc += "f 13/13 " + std::to_string(i + 1) + "/" + std::to_string(i + 1) + " " +
                std::to_string((i + 1) % kCorners + 1) + "/" +
                std::to_string((i + 1) % kCorners + 1) + "\n";
    Image heights = random_image(kSize, kSize, {"Y"}, 3, -1000, 1000);
    Image colors = random_image(kSize, kSize, {"R", "G", "B"}, 4, 100, 1000);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const size_t texel = static_cast<size_t>(y * kSize + x);
            if (std::hypot(x + 0.5 - kSize / 2.0, y + 0.5 - kSize / 2.0) > 0.37 * kSize)
                continue;
            heights.pixels[texel] = static_cast<float>(3 * x - 2 * y) / kSize;
            for (size_t c = 0; c < 3; ++c)
                colors.pixels[3 * texel + c] = 0.5F;
        }
    write_image(temp_ / "h.exr", heights);
    write_image(temp_ / "c.exr", colors);
    // As smooth as the positions, texture coordinates are a scale of them everywhere.
    bake_on(disc, "disc", [](BakeOptions& o) { o.subdivision.rules.uv = UvRule::none; });
    const auto coverage = levels("disc", "coverage");
    const TextureLookup lookup(temp_ / "disc", read_manifest(temp_ / "disc"));
    // By the disc's own scale: a texture unit is 1 / 0.37 long.
    const float slope_s = 0.03F * 0.37F, slope_t = -0.02F * 0.37F;
    int looked = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            if (!(coverage[0].at(x, y, 0) > 0))
                continue;
            for (size_t l = 0; l < coverage.size(); ++l)
                for (const float size : {1.0F, 1.5F}) {
                    TexturePlace place;
                    place.s = (static_cast<float>(x) + 0.5F) / kSize;
                    place.t = (static_cast<float>(y) + 0.5F) / kSize;
                    place.ds_dx = size / static_cast<float>(coverage[l].width);
                    place.dt_dy = size / static_cast<float>(coverage[l].height);
                    float rgb[3], slope[5];
                    lookup.read(Map::color, place, 0, 3, rgb);
                    lookup.read(Map::slope, place, 0, 5, slope);
                    ASSERT_NEAR(rgb[1], 0.5F, 1e-5F) << x << ' ' << y << ' ' << l;
                    ASSERT_NEAR(slope[0], slope_s, 1e-5F) << x << ' ' << y << ' ' << l;
                    ASSERT_NEAR(slope[3], slope_t, 1e-5F) << x << ' ' << y << ' ' << l;
                    ++looked;
                }
        }
    ASSERT_GT(looked, 10'000);
}

// Between the longest and the shortest side of texels lie 1e4, between their areas 1e8.
TEST_F(MeshBake, HalvesLoseNoWeight)
{
    const Manifest manifest = bake_on(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 20000 0 0\nv 20000 10000 0\nv 10000 10000 0\n"
        "v 10000 0 0\nvt 0 0\nvt 0.5 0\nvt 0.5 1\nvt 0 1\nvt 1 0\nvt 1 1\n"
        "f 1/1 2/2 3/3 4/4\nf 8/2 5/5 6/6 7/3\n",
        "wide", [](BakeOptions& o) { o.pixel_type = PixelTypeChoice::automatic; });
    EXPECT_EQ(manifest.no_data_texels, 0);
    const Image coverage = levels("wide", "coverage")[0];
    EXPECT_NEAR(coverage.at(3, 3, 0), 1e-8F, 1e-14F);
    EXPECT_EQ(coverage.at(kSize - 3, 3, 0), 1);
}

TEST_F(MeshBake, SameBytesWithAnyNumberOfThreads)
{
    const std::string obj = parallelogram(Vec3(0.7, 0.1, 0), Vec3(0, 0.4, 0.3));
    bake_on(obj, "one", [](BakeOptions& o) { o.threads = 1; });
    bake_on(obj, "many", [](BakeOptions& o) { o.threads = 7; });
    for (const char* map : {"slope", "color", "tail"}) {
        const std::string file = "test." + std::string(map) + ".exr";
        EXPECT_EQ(read_bytes(temp_ / "one" / file), read_bytes(temp_ / "many" / file)) << map;
    }
}

TEST_F(MeshBake, WhatOnlyPlanesHaveIsRefused)
{
    const std::string obj = parallelogram(Vec3(1, 0, 0), Vec3(0, 1, 0));
    const std::pair<const char*, std::function<void(BakeOptions&)>> cases[] = {
        {"--texel-size",
         [](BakeOptions& o) {
             o.texel_size = {{1, 1}};
         }},
        {"--world-size",
         [](BakeOptions& o) {
             o.world_size = {{1, 1}};
         }},
        {"bumpslopes", [](BakeOptions& o) { o.layout = Layout::bumpslopes; }},
        {"planes only", [](BakeOptions& o) { o.auto_maps = true; }},
        {"planes only", [](BakeOptions& o) { o.visibility = Visibility::tables; }},
        {"planes only", [](BakeOptions& o) {
             o.maps = {Map::color, Map::visible};
         }}};
    for (const auto& [words, change] : cases) {
        try {
            bake_on(obj, "refused", change);
            ADD_FAILURE() << words;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find("--mesh"), std::string::npos) << e.what();
        }
        EXPECT_FALSE(std::filesystem::exists(temp_ / "refused"));
    }
    // Charts that no texel lies in.
    EXPECT_THROW(
        bake_on("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 5 5\nvt 6 5\nvt 6 6\nf 1/1 2/2 3/3\n", "off"),
        Error);
}

} // namespace
} // namespace scree::test
