// Sets of tiles on a mesh, read back from their files.

#include <cmath>
#include <fstream>

#include "math/error.h"
#include "pipeline/bake.h"
#include "pipeline/tiled_files.h"

namespace scree::test {
namespace {

class UdimMesh : public TiledFiles {
protected:
    void obj(const std::string& text) const { std::ofstream(temp_ / "mesh.obj") << text; }
};

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

TEST_F(UdimMesh, MeshesSayWhichBordersMeet)
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
TEST_F(UdimMesh, FacesMayCrossBorders)
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
TEST_F(UdimMesh, TilesOfAMeshShareOneNormalisation)
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

TEST_F(UdimMesh, TilesThatAMeshHasAndFilesHaveNot)
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
TEST_F(UdimMesh, AMapOnAClosedSurfaceMeetsItself)
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

// Four sheets, three of which meet: the fourth lies far off, and its corner is none of theirs.
TEST_F(UdimMesh, CornersMeetAsSidesDo)
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

} // namespace
} // namespace scree::test
