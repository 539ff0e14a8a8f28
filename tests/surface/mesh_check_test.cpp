#include "surface/mesh_check.h"

#include <gtest/gtest.h>

#include "surface/meshes.h"

namespace scree::test {
namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nv 2 0 0\n"
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvt 0.5 0\n";

MeshWarnings check(const std::string& faces) { return check_mesh(mesh_from(kPoints + faces)); }

TEST(MeshCheck, AGoodMeshHasNoWarnings)
{
    const MeshWarnings found = check_mesh(cube_mesh());
    EXPECT_EQ(found.polygons, 0);
    EXPECT_EQ(found.degenerate_faces, 0);
    EXPECT_EQ(found.nonmanifold_edges, 0);
    EXPECT_EQ(found.unused_vertices, 0);
    EXPECT_EQ(found.zero_area_uv_faces, 0);
    EXPECT_EQ(found.mirrored_uv_faces, 0);
}

TEST(MeshCheck, EachKindIsCountedAlone)
{
    EXPECT_EQ(check("f 1/1 2/2 3/3 5/5 4/4\n").polygons, 1);
    EXPECT_EQ(check("f 1/1 2/2 3/3 4/4\n").polygons, 0);

    EXPECT_EQ(check("f 1/1 2/2 3/3 2/4\n").degenerate_faces, 1) << "a vertex twice";
    EXPECT_EQ(check("f 1/1 2/2 6/3\n").degenerate_faces, 1) << "on one line";
    EXPECT_EQ(check("f 1/1 2/2 3/3\n").degenerate_faces, 0);

    EXPECT_EQ(check("f 1/1 2/2 3/3\nf 1/1 2/2 5/5\n").nonmanifold_edges, 1) << "same direction";
    EXPECT_EQ(check("f 1/1 2/2 3/3\nf 2/2 1/1 5/5\n").nonmanifold_edges, 0);
    EXPECT_EQ(check("f 1/1 2/2 3/3\nf 2/2 1/1 5/5\nf 2/2 1/1 4/4\n").nonmanifold_edges, 1)
        << "three faces";

    EXPECT_EQ(check("f 1/1 2/2 3/3\n").unused_vertices, 3);

    EXPECT_EQ(check("f 1/1 2/6 3/2\n").zero_area_uv_faces, 1);
    EXPECT_EQ(check("f 1/1 2/1 3/1\n").zero_area_uv_faces, 1);
    EXPECT_EQ(check("f 1/1 2/6 3/2\n").mirrored_uv_faces, 0);

    EXPECT_EQ(check("f 1/1 2/4 3/3 4/2\n").mirrored_uv_faces, 1);
    EXPECT_EQ(check("f 1/1 2/2 3/3 4/4\n").mirrored_uv_faces, 0);
}

} // namespace
} // namespace scree::test
