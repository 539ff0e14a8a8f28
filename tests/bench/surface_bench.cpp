// Time of the metric of all texels of a mesh: scree_bench_surface MESH.obj|torus|plane [WIDTH]
// [all|smooth] [catmull_clark|loop]. A torus has 100 x 100 faces, and so has the plane.

#include <surface/limit_surface.h>
#include <surface/mesh_check.h>
#include <surface/mesh_file.h>
#include <surface/texel_metric.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using scree::Vec2;
using scree::Vec3;

constexpr int kFacesASide = 100;
constexpr int kRows = 64;

/// A grid of quadrilaterals with texture coordinates over the unit square, bent to a torus or not.
scree::Mesh grid_mesh(bool torus)
{
    scree::Mesh mesh;
    mesh.name = torus ? "torus" : "plane";
    const int nodes = kFacesASide + 1;
    const auto node = [&](int i, int j) { return j * nodes + i; };
    const auto vertex = [&](int i, int j) {
        return torus ? (j % kFacesASide) * kFacesASide + i % kFacesASide : node(i, j);
    };
    for (int j = 0; j < (torus ? kFacesASide : nodes); ++j)
        for (int i = 0; i < (torus ? kFacesASide : nodes); ++i) {
            const double u = 1.0 * i / kFacesASide, v = 1.0 * j / kFacesASide;
            const double a = 2 * M_PI * u, b = 2 * M_PI * v, r = 2 + std::cos(b);
            mesh.vertices.push_back(torus ? Vec3(r * std::cos(a), r * std::sin(a), std::sin(b))
                                          : Vec3(u, v, 0));
        }
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i)
            mesh.uvs.emplace_back(1.0 * i / kFacesASide, 1.0 * j / kFacesASide);
    for (int j = 0; j < kFacesASide; ++j)
        for (int i = 0; i < kFacesASide; ++i) {
            mesh.face_sizes.push_back(4);
            for (const auto& [x, y] : {std::pair(i, j), std::pair(i + 1, j),
                                       std::pair(i + 1, j + 1), std::pair(i, j + 1)}) {
                mesh.face_vertices.push_back(vertex(x, y));
                mesh.face_uvs.push_back(node(x, y));
            }
        }
    return mesh;
}

scree::Mesh mesh_of(const std::string& name)
{
    if (name == "torus" || name == "plane")
        return grid_mesh(name == "torus");
    return scree::read_mesh(name).mesh;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void run(const std::string& name, int width, const std::string& uvs, const std::string& scheme)
{
    const scree::Mesh mesh = mesh_of(name);
    const scree::MeshWarnings odd = scree::check_mesh(mesh);
    std::printf("%zu faces: %d polygons, %d degenerate, %d non-manifold edges, %d unused vertices, "
                "%d without UV area, %d mirrored\n",
                mesh.face_sizes.size(), odd.polygons, odd.degenerate_faces, odd.nonmanifold_edges,
                odd.unused_vertices, odd.zero_area_uv_faces, odd.mirrored_uv_faces);
    scree::SurfaceOptions options;
    options.scheme = scheme == "loop" ? scree::Scheme::loop : scree::Scheme::catmull_clark;
    options.rules.uv = uvs == "smooth" ? scree::UvRule::corners_plus1 : scree::UvRule::all;
    auto start = std::chrono::steady_clock::now();
    const scree::LimitSurface surface(mesh, options);
    const scree::TexelMetrics metrics(surface);
    std::printf("prepared in %.3f s\n", seconds_since(start));
    std::vector<scree::TexelMetric> texels(static_cast<size_t>(width) * kRows);
    for (const auto& [tile_u, tile_v] : metrics.tiles()) {
        start = std::chrono::steady_clock::now();
        const scree::TexelGrid grid{width, width, tile_u, tile_v};
        scree::TexelCounts counts;
        float curvature = 0;
        double area = 0;
        for (int first = 0; first < width; first += kRows) {
            const int count = std::min(kRows, width - first);
            counts += metrics.rows(grid, first, count, texels.data());
            for (size_t i = 0; i < static_cast<size_t>(width) * static_cast<size_t>(count); ++i)
                if (texels[i].face >= 0) {
                    curvature = std::max(curvature, texels[i].curvature);
                    area += texels[i].area;
                }
        }
        const double seconds = seconds_since(start);
        std::printf(
            "tile %d %d: %.3f s, %.0f ns a covered texel; %lld covered, %lld overlapped, "
            "%lld mirrored, %lld singular; area %.9g, largest curvature %.4g\n",
            tile_u, tile_v, seconds,
            1e9 * seconds / static_cast<double>(std::max<int64_t>(1, counts.covered)),
            static_cast<long long>(counts.covered), static_cast<long long>(counts.overlapped),
            static_cast<long long>(counts.mirrored), static_cast<long long>(counts.singular),
            area / (1.0 * width * width), static_cast<double>(curvature));
    }
}

} // namespace

int main(int count, char** words)
{
    try {
        const auto word = [&](int i, const char* otherwise) {
            return std::string(i < count ? words[i] : otherwise);
        };
        run(word(1, "torus"), std::stoi(word(2, "1024")), word(3, "all"), word(4, "catmull_clark"));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
