#include "surface/uv_charts.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace scree {

namespace {

/// An edge of a face, from its lower vertex on.
struct UvEdge {
    std::array<int, 2> vertices;
    std::array<double, 4> uvs;
    int face;

    [[nodiscard]] bool joins(const UvEdge& other) const
    {
        return vertices == other.vertices && uvs == other.uvs;
    }
};

bool operator<(const UvEdge& a, const UvEdge& b)
{
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.uvs < b.uvs;
}

/// The face that stands for all that are joined to one.
int root_of(std::vector<int>& parents, int face)
{
    while (parents[static_cast<size_t>(face)] != face) {
        int& parent = parents[static_cast<size_t>(face)];
        parent = parents[static_cast<size_t>(parent)];
        face = parent;
    }
    return face;
}

} // namespace

UvCharts uv_charts(const Mesh& mesh)
{
    const size_t faces = mesh.face_sizes.size();
    std::vector<UvEdge> edges;
    edges.reserve(mesh.face_vertices.size());
    std::vector<double> areas(faces);
    size_t first = 0;
    for (size_t face = 0; face < faces; ++face) {
        const auto size = static_cast<size_t>(mesh.face_sizes[face]);
        for (size_t i = 0; i < size; ++i) {
            const size_t corner = first + i, next = first + (i + 1) % size;
            int a = mesh.face_vertices[corner], b = mesh.face_vertices[next];
            Vec2 at_a = mesh.uvs[static_cast<size_t>(mesh.face_uvs[corner])];
            Vec2 at_b = mesh.uvs[static_cast<size_t>(mesh.face_uvs[next])];
            areas[face] += (at_a % at_b) / 2;
            if (a > b) {
                std::swap(a, b);
                std::swap(at_a, at_b);
            }
            edges.push_back({{a, b}, {at_a.x, at_a.y, at_b.x, at_b.y}, static_cast<int>(face)});
        }
        first += size;
    }
    std::sort(edges.begin(), edges.end());
    std::vector<int> parents(faces);
    std::iota(parents.begin(), parents.end(), 0);
    for (size_t i = 1; i < edges.size(); ++i)
        if (edges[i - 1].joins(edges[i]))
            parents[static_cast<size_t>(root_of(parents, edges[i].face))] =
                root_of(parents, edges[i - 1].face);

    std::vector<double> chart_areas(faces);
    for (size_t face = 0; face < faces; ++face)
        chart_areas[static_cast<size_t>(root_of(parents, static_cast<int>(face)))] += areas[face];
    UvCharts charts;
    for (size_t face = 0; face < faces; ++face)
        if (parents[face] == static_cast<int>(face)) {
            ++charts.count;
            charts.mirrored += chart_areas[face] < 0 ? 1 : 0;
        }
    return charts;
}

} // namespace scree
