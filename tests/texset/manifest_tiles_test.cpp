// What a manifest says of tiles and of a mesh.

#include <gtest/gtest.h>

#include "math/error.h"
#include "texset/manifest.h"
#include "texset/manifest_json.h"

namespace scree::test {
namespace {

MeshRecord mesh_record(int seed)
{
    MeshRecord mesh;
    mesh.scheme = "loop";
    mesh.boundary = "edge-only";
    mesh.uv_interpolation = "corners-plus1";
    mesh.faces = 180;
    mesh.charts = 12;
    mesh.mirrored_charts = 5;
    mesh.covered = 7'000'000'000 + seed;
    mesh.overlapped = 8;
    mesh.mirrored = 9;
    mesh.singular = 10;
    mesh.area = 1.0 / 3;
    mesh.largest_displacement = 0.1;
    mesh.displaced_most = {11, 12};
    mesh.displaced_tile = seed;
    mesh.usual_displacement = 0.01;
    return mesh;
}

Manifest tiled_manifest()
{
    Manifest m;
    m.name = "rock";
    m.inputs = {{"height", "h.1001.exr", "ab", 8, 8, "Y", "half", "", 1001},
                {"height", "h.1012.exr", "cd", 4, 2, "Y", "half", "", 1012},
                {"mesh", "m.obj", "ef", 0, 0, "", "", "", 0}};
    m.width = 8;
    m.height = 8;
    m.texel_width = m.texel_height = 0.125;
    m.no_data_texels = 30;
    m.wrap_s = m.wrap_t = "clamp";
    m.mesh = mesh_record(1012);
    m.textures = {{Map::slope, "rock.<UDIM>.slope.exr", {"s"}, PixelType::half, {}, {}},
                  {Map::map, "rock.<UDIM>.map.exr", {"R"}, PixelType::float32, {}, {}}};
    TileRecord first;
    first.number = 1001;
    first.width = first.height = 8;
    first.texel_width = first.texel_height = 0.125;
    first.no_data_texels = 10;
    first.levels.resize(4);
    first.levels[0].width = 8;
    first.levels[0].rms_slope = 0.3;
    TileRecord second;
    second.number = 1012;
    second.width = 4;
    second.height = 2;
    second.texel_width = 0.25;
    second.texel_height = 0.5;
    second.no_data_texels = 20;
    second.mesh = mesh_record(0);
    second.levels.resize(3);
    m.tiles = {first, second};
    return m;
}

TEST(ManifestTiles, ComeBackFromTheirText)
{
    const Manifest m = tiled_manifest();
    const Manifest read = manifest_of(to_json(m));
    EXPECT_EQ(to_json(read), to_json(m));
    ASSERT_EQ(read.tiles.size(), 2U);
    const TileRecord& tile = read.tiles[1];
    EXPECT_EQ(tile.number, 1012);
    EXPECT_EQ(tile.width, 4);
    EXPECT_EQ(tile.height, 2);
    EXPECT_EQ(tile.texel_width, 0.25);
    EXPECT_EQ(tile.texel_height, 0.5);
    EXPECT_EQ(tile.no_data_texels, 20);
    EXPECT_EQ(tile.levels.size(), 3U);
    EXPECT_FALSE(read.tiles[0].mesh);
    EXPECT_EQ(read.tiles[0].levels[0].rms_slope, 0.3);
    EXPECT_EQ(read.inputs[1].tile, 1012);
    EXPECT_EQ(read.inputs[2].tile, 0);
    ASSERT_TRUE(read.mesh);
    EXPECT_EQ(read.mesh->scheme, "loop");
    EXPECT_EQ(read.mesh->boundary, "edge-only");
    EXPECT_EQ(read.mesh->uv_interpolation, "corners-plus1");
    EXPECT_EQ(read.mesh->charts, 12);
    EXPECT_EQ(read.mesh->mirrored_charts, 5);
    EXPECT_EQ(read.mesh->covered, 7'000'001'012);
    EXPECT_EQ(read.mesh->displaced_tile, 1012);
    EXPECT_EQ(read.mesh->usual_displacement, 0.01);
    EXPECT_EQ(read.tiles[1].mesh->displaced_tile, 0);
}

TEST(ManifestTiles, ATileIsASetOfItsOwn)
{
    const Manifest map = manifest_of_map(tiled_manifest(), 1012);
    EXPECT_TRUE(map.tiles.empty());
    EXPECT_EQ(map.width, 4);
    EXPECT_EQ(map.height, 2);
    EXPECT_EQ(map.texel_width, 0.25);
    EXPECT_EQ(map.texel_height, 0.5);
    EXPECT_EQ(map.no_data_texels, 20);
    EXPECT_EQ(map.levels.size(), 3U);
    EXPECT_EQ(map.textures[0].file, "rock.1012.slope.exr");
    EXPECT_EQ(map.textures[1].file, "rock.1012.map.exr");
    EXPECT_EQ(files_of(tiled_manifest().textures[0], tiled_manifest()),
              (std::vector<std::string>{"rock.1001.slope.exr", "rock.1012.slope.exr"}));
    ASSERT_EQ(map.inputs.size(), 2U);
    EXPECT_EQ(map.inputs[0].file, "h.1012.exr");
    EXPECT_EQ(map.inputs[1].file, "m.obj");
    EXPECT_EQ(map.mesh->covered, 7'000'000'000);
}

TEST(ManifestTiles, OneMustBeNamedAndBeThere)
{
    const auto message = [](const Manifest& m, int tile) -> std::string {
        try {
            (void)manifest_of_map(m, tile);
        } catch (const Error& e) {
            return e.what();
        }
        return {};
    };
    EXPECT_NE(message(tiled_manifest(), 0).find("1001, 1012"), std::string::npos);
    EXPECT_NE(message(tiled_manifest(), 1002).find("no tile 1002"), std::string::npos);
    Manifest one;
    one.name = "one";
    EXPECT_EQ(message(one, 0), "");
    EXPECT_NE(message(one, 1001).find("no tiles"), std::string::npos);
}

// Sets of meshes from before there were tiles.
TEST(ManifestTiles, FormatTwoIsRead)
{
    std::string text = to_json(tiled_manifest());
    const auto cut = [&text](const std::string& from, const std::string& to) {
        const size_t begin = text.find(from), end = text.find(to, begin);
        ASSERT_NE(end, std::string::npos);
        text.erase(begin, end - begin);
    };
    cut("\"tiles\"", "\"options\"");
    cut("\"scheme\"", "\"faces\"");
    cut("\"charts\"", "\"covered_texels\"");
    cut(",\n    \"usual_height", "\n  },");
    text.replace(text.find("\"format_version\": 3"), 19, "\"format_version\": 2");
    const Manifest read = manifest_of(text);
    EXPECT_TRUE(read.tiles.empty());
    EXPECT_EQ(read.mesh->faces, 180);
    EXPECT_EQ(read.mesh->charts, 0);
    EXPECT_EQ(read.mesh->usual_displacement, 0);
}

} // namespace
} // namespace scree::test
