#include "surface/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace scree {

namespace {

constexpr double kNoArea = 1e-12;

/// Rounding makes areas of this size of faces without any.
bool is_zero(double area, double extent) { return !(std::abs(area) > kNoArea * extent * extent); }

/// The corners of one face.
struct FaceSpan {
    const int* vertices;
    const int* uvs;
    int size;

    [[nodiscard]] int next(int i) const { return i + 1 < size ? i + 1 : 0; }
};

bool has_repeated_vertex(const FaceSpan& face)
{
    for (int i = 1; i < face.size; ++i)
        if (std::find(face.vertices, face.vertices + i, face.vertices[i]) != face.vertices + i)
            return true;
    return false;
}

bool is_degenerate(const Mesh& mesh, const FaceSpan& face)
{
    if (has_repeated_vertex(face))
        return true;
    const auto corner = [&](int i) { return mesh.vertices[static_cast<size_t>(face.vertices[i])]; };
    // Half the length of the summed cross products is the area of a planar polygon.
    const Vec3 origin = corner(0);
    Vec3 twice(0, 0, 0);
    double extent = 0;
    for (int i = 0; i < face.size; ++i) {
        twice += (corner(i) - origin) % (corner(face.next(i)) - origin);
        extent = std::max(extent, (corner(i) - origin).length());
    }
    return is_zero(twice.length(), extent);
}

/// Twice the signed area in texture space; `extent` gets the longest distance from a corner.
double twice_uv_area(const Mesh& mesh, const FaceSpan& face, double& extent)
{
    const auto corner = [&](int i) { return mesh.uvs[static_cast<size_t>(face.uvs[i])]; };
    const Vec2 origin = corner(0);
    double twice = 0;
    extent = 0;
    for (int i = 0; i < face.size; ++i) {
        twice += (corner(i) - origin) % (corner(face.next(i)) - origin);
        extent = std::max(extent, (corner(i) - origin).length());
    }
    return twice;
}

/// An edge as a face runs through it: `low` and `high` vertex, and whether from low to high.
struct Run {
    int low, high;
    bool rising;
};

int count_nonmanifold(std::vector<Run> runs)
{
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    int count = 0;
    for (size_t first = 0; first < runs.size();) {
        size_t last = first;
        int rising = 0;
        for (; last < runs.size() && runs[last].low == runs[first].low &&
               runs[last].high == runs[first].high;
             ++last)
            rising += runs[last].rising ? 1 : 0;
        const auto faces = static_cast<int>(last - first);
        if (faces > 2 || (faces == 2 && rising != 1))
            ++count;
        first = last;
    }
    return count;
}

} // namespace

MeshWarnings check_mesh(const Mesh& mesh)
{
    MeshWarnings found;
    std::vector<Run> runs;
    std::vector<bool> used(mesh.vertices.size());
    size_t first = 0;
    for (const int size : mesh.face_sizes) {
        const FaceSpan face{&mesh.face_vertices[first], &mesh.face_uvs[first], size};
        found.polygons += size > 4 ? 1 : 0;
        found.degenerate_faces += is_degenerate(mesh, face) ? 1 : 0;
        double extent = 0;
        const double area = twice_uv_area(mesh, face, extent);
        if (is_zero(area, extent))
            ++found.zero_area_uv_faces;
        else if (area < 0)
            ++found.mirrored_uv_faces;
        for (int i = 0; i < size; ++i) {
            const int a = face.vertices[i], b = face.vertices[face.next(i)];
            used[static_cast<size_t>(a)] = true;
            if (a != b)
                runs.push_back({std::min(a, b), std::max(a, b), a < b});
        }
        first += static_cast<size_t>(size);
    }
    found.nonmanifold_edges = count_nonmanifold(std::move(runs));
    found.unused_vertices = static_cast<int>(std::count(used.begin(), used.end(), false));
    return found;
}

} // namespace scree
