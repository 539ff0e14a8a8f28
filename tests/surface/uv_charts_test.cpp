#include "surface/uv_charts.h"

#include <gtest/gtest.h>

#include "surface/meshes.h"

namespace scree::test {
namespace {

/// Two squares that share an edge in space; texture coordinates of each by hand.
std::string two_squares(const std::string& first, const std::string& second)
{
    return "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
           "vt 0 0\nvt 0.3 0\nvt 0.6 0\nvt 0 1\nvt 0.3 1\nvt 0.6 1\nvt 0.9 0\nvt 0.9 1\n" +
           first + second;
}

constexpr const char* kFirst = "f 1/1 2/2 5/5 4/4\n";

TEST(UvCharts, FacesAreJoinedByEdgesWithTheSameCoordinates)
{
    EXPECT_EQ(uv_charts(mesh_from(two_squares(kFirst, "f 2/2 3/3 6/6 5/5\n"))).count, 1);
    EXPECT_EQ(uv_charts(mesh_from(two_squares(kFirst, "f 2/3 3/7 6/8 5/6\n"))).count, 2);
    // One vertex with the same coordinates joins nothing.
    EXPECT_EQ(uv_charts(mesh_from(two_squares(kFirst, "f 2/2 3/7 6/8 5/6\n"))).count, 2);
    // Other numbers for the same coordinates do.
    EXPECT_EQ(uv_charts(mesh_from("vt 0.3 0\nvt 0.3 1\n" +
                                  two_squares("f 1/3 2/4 5/7 4/6\n", "f 2/1 3/5 6/8 5/2\n")))
                  .count,
              1);
}

TEST(UvCharts, MirroredOnesAreClockwise)
{
    const UvCharts one = uv_charts(mesh_from(two_squares(kFirst, "f 2/7 3/3 6/6 5/8\n")));
    EXPECT_EQ(one.count, 2);
    EXPECT_EQ(one.mirrored, 1);
    EXPECT_EQ(uv_charts(mesh_from(two_squares(kFirst, "f 2/2 3/3 6/6 5/5\n"))).mirrored, 0);
}

TEST(UvCharts, OfKnownMeshes)
{
    EXPECT_EQ(uv_charts(cube_mesh()).count, 6);
    EXPECT_EQ(uv_charts(octahedron()).count, 8);
    const Mesh torus = grid_mesh({12, 8, true, true}, wavy, plain_uv);
    EXPECT_EQ(uv_charts(torus).count, 1);
}

} // namespace
} // namespace scree::test
