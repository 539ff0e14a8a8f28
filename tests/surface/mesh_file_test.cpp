// OBJ files written by hand: every number is in the text.

#include "surface/mesh_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "math/error.h"
#include "support/files.h"
#include "surface/limit_surface.h"
#include "surface/mesh_check.h"
#include "surface/meshes.h"

namespace scree::test {
namespace {

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                          "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST(MeshFile, PolygonsOfAllGroupsInOrder)
{
    const Mesh mesh = mesh_from("mtllib missing.mtl\no first\n" + kQuad +
                                "usemtl red\nf 1/1 2/2 3/3 4/4\ng second third\r\n"
                                "v 5e-1 +.5 -1.5E0 0.1 0.2 0.3\nvn 0 0 1\nvt 0.25 0.75 0\n"
                                "s off\nf 1/1/1 2/2/1 5/5/1\n# end\nf -1/-1 -2/-2 -4/-4 -5/-5 2/2");
    EXPECT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.vertices[4], Vec3(0.5, 0.5, -1.5));
    EXPECT_LT((mesh.uvs[4] - Vec2(0.25, 0.75)).length(), 1e-15)
        << "the library rounds digit by digit";
    EXPECT_EQ(mesh.face_sizes, (std::vector<int>{4, 3, 5}));
    EXPECT_EQ(mesh.face_vertices, (std::vector<int>{0, 1, 2, 3, 0, 1, 4, 4, 3, 1, 0, 1}));
    EXPECT_EQ(mesh.face_uvs, (std::vector<int>{0, 1, 2, 3, 0, 1, 4, 4, 3, 1, 0, 1}));
    EXPECT_FALSE(mesh.rules.boundary || mesh.rules.uv || mesh.rules.creases);
}

TEST(MeshFile, TagsOfSubdivision)
{
    const Mesh mesh = mesh_from(kQuad + "f 1/1 2/2 3/3 4/4\n"
                                        "t crease 4/1/0 0 1 1 2 2.5\n"
                                        "t crease 4/2/0 2 3 3 0 1.5 12\n"
                                        "t corner 2/1/0 0 2 -1\n"
                                        "t hole 1/0/0 0\n"
                                        "t interpolateboundary 1/0/0 2\n"
                                        "t facevaryinginterpolateboundary 1/0/0 3\n"
                                        "t creasemethod 0/0/1 chaikin\n"
                                        "t smoothtriangles 0/0/1 smooth\n");
    ASSERT_EQ(mesh.creases.size(), 4U);
    const double sharpness[] = {2.5, 2.5, 1.5, 12};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.creases[i].from, static_cast<int>(i));
        EXPECT_EQ(mesh.creases[i].to, static_cast<int>((i + 1) % 4));
        EXPECT_EQ(mesh.creases[i].sharpness, sharpness[i]);
    }
    ASSERT_EQ(mesh.corners.size(), 2U);
    EXPECT_EQ(mesh.corners[1].vertex, 2);
    EXPECT_EQ(mesh.corners[1].sharpness, 0) << "as OpenSubdiv: none below 0";
    EXPECT_EQ(mesh.holes, std::vector<int>{0});
    EXPECT_EQ(mesh.rules.boundary, BoundaryRule::edge_only);
    EXPECT_EQ(mesh.rules.uv, UvRule::corners_plus2);
    EXPECT_EQ(mesh.rules.creases, CreaseRule::chaikin);
    EXPECT_EQ(mesh.rules.triangles, TriangleRule::smooth);
}

TEST(MeshFile, UnknownTagsAreNamed)
{
    const TempFolder folder;
    std::ofstream(folder / "a.obj") << kQuad << "f 1/1 2/2 3/3 4/4\nt wobble 1/0/0 3\n"
                                    << "t wobble 0/0/0\n";
    EXPECT_EQ(read_mesh(folder / "a.obj").unknown_tags, std::vector<std::string>{"wobble"});
}

TEST(MeshFile, EachBadMeshHasOneClearError)
{
    const std::string face = "f 1/1 2/2 3/3 4/4\n";
    const struct {
        std::string text, error;
    } cases[] = {
        {"", "a.obj: the file is empty"},
        {kQuad, "a.obj: no faces, expected a mesh of polygons"},
        {kQuad + "f 1 2 3 4\n",
         "a.obj: no texture coordinates (UVs), expected one at each corner of each face; unwrap "
         "the mesh and export it with UVs"},
        {kQuad + "f 1//1 2//1 3//1\nvn 0 0 1\n",
         "a.obj: no texture coordinates (UVs), expected one at each corner of each face; unwrap "
         "the mesh and export it with UVs"},
        {kQuad + face + "f 1/1 2 3/3\nf 1 2 3\n",
         "a.obj: 2 of 3 faces have corners without texture coordinates, the first is face 2; "
         "unwrap them or remove them"},
        {kQuad + "f 1/1 2/2 9/3\n",
         "a.obj: face 1 names vertex 9, but there are 4; is the file cut short?"},
        {kQuad + "f 1/1 2/2 -9/3\n",
         "a.obj: face 1 names vertex -4, but there are 4; is the file cut short?"},
        {kQuad + "f 1/1 2/2 3/7\n",
         "a.obj: face 1 names texture coordinate 7, but there are 4; is the file cut short?"},
        {kQuad + "f 1/1 0/2 3/3\n", "a.obj: not a valid OBJ file: Failed parse `f' line(e.g. zero "
                                    "value for face index. line 9.)"},
        {kQuad + "f 1/1 2/2\n", "a.obj: line 9: a face of 2 corners, expected 3 or more; remove "
                                "it, or is the file cut short?"},
        {kQuad + "v 1 nan 0\n" + face,
         "a.obj: line 9: a vertex with \"nan\", expected 3 finite numbers; repair it or export the "
         "mesh again"},
        {kQuad + "vt 0 inf\n" + face,
         "a.obj: line 9: a texture coordinate with \"inf\", expected 2 finite numbers; repair it "
         "or export the mesh again"},
        {kQuad + "vt 1e6 0\n" + face, "a.obj: texture coordinate (1000000, 0), expected within "
                                      "1000 of 0; unwrap the mesh again"},
        {"v 1,5 0 0\n" + kQuad + face,
         "a.obj: line 1: a vertex with \"1,5\", expected 3 finite numbers; repair it or export "
         "the mesh again"},
        {"v 1e999 0 0\n" + kQuad + face,
         "a.obj: line 1: a vertex with \"1e999\", expected 3 finite numbers; repair it or export "
         "the mesh again"},
        {kQuad + face + "v 0.25 0.5",
         "a.obj: line 10: a vertex of 2 numbers, expected 3; is the file cut short?"},
        {kQuad + face + "vt 0.25",
         "a.obj: line 10: a texture coordinate of 1 numbers, expected 2; is the file cut short?"},
        {kQuad + face + "t crease 2/1/0 0 1",
         "a.obj: line 10: tag crease: 2 values, expected 3; is the file cut short?"},
        {kQuad + face + "t crease two 0 1\n",
         "a.obj: line 10: tag crease: expected its counts as integers/reals/strings, each 0 to "
         "8192"},
        {kQuad + face + "t crease 3/1/0 0 1 2 1\n",
         "a.obj: tag crease: 3 vertices, expected pairs"},
        {kQuad + face + "t crease 2/1/0 0 4 1\n", "a.obj: tag crease: vertex 4, expected 0 to 3"},
        {kQuad + face + "t corner 3/2/0 0 1 2 1 1\n",
         "a.obj: tag corner: 2 sharpnesses, expected 1 or 3"},
        {kQuad + face + "t hole 1/0/0 1\n", "a.obj: tag hole: face 1, expected 0 to 0"},
        {kQuad + face + "t interpolateboundary 1/0/0 3\n",
         "a.obj: tag interpolateboundary: expected one number, 0 to 2"},
        {kQuad + face + "t creasemethod 0/0/1 round\n",
         "a.obj: tag creasemethod: expected \"normal\" or \"chaikin\""},
        {kQuad + face + "g other\nt corner 1/1/0 0 1\n",
         "a.obj: 1 of 1 subdivision tags (lines \"t ...\") stand after a group without faces; move "
         "them before its g or o line"},
        {kQuad + std::string("f 1/1 2/2\0 3/3\n", 15),
         "a.obj: line 9: is not text; expected OBJ as ASCII or UTF-8"},
    };
    for (const auto& [text, error] : cases)
        EXPECT_EQ(mesh_error(text), error) << text;
}

TEST(MeshFile, MissingFilesAndFolders)
{
    const TempFolder folder;
    EXPECT_THROW(read_mesh(folder / "missing.obj"), Error);
    EXPECT_THROW(read_mesh(folder.path()), Error);
}

TEST(MeshFile, AFileCutAnywhereIsReadOrRefused)
{
    const std::string whole = kQuad + "f 1/1 2/2 3/3 4/4\nf 1/1 4/4 3/3\nt corner 1/1/0 0 2.5\n";
    int read = 0;
    for (size_t length = 0; length <= whole.size(); ++length) {
        const std::string error = mesh_error(whole.substr(0, length));
        read += error.empty() ? 1 : 0;
        EXPECT_TRUE(!error.empty() || length > whole.find("f 1")) << length;
    }
    EXPECT_GE(read, 1);
}

/// Every file must end in a mesh or an error.
TEST(MeshFile, BrokenFilesOfOthers)
{
    const auto folder = data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no data folder";
    int refused = 0, files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "badinput" / "obj")) {
        ++files;
        try {
            const Mesh mesh = read_mesh(entry.path()).mesh;
            check_mesh(mesh);
        } catch (const Error& error) {
            ++refused;
            EXPECT_NE(std::string(error.what()).find(entry.path().string()), std::string::npos);
        }
    }
    EXPECT_GT(files, 0);
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace scree::test
