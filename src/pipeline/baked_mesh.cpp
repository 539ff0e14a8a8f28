#include "pipeline/baked_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pipeline/mesh_options.h"
#include "surface/mesh_check.h"
#include "surface/mesh_file.h"
#include "surface/texel_metric.h"
#include "surface/uv_charts.h"
#include "texset/file_hash.h"
#include "texset/udim.h"

namespace scree {

namespace {

/// Sentences of what was counted.
class Findings {
public:
    Findings(std::string file, std::vector<std::string>& words)
        : file_(std::move(file)), words_(words)
    {}

    void say(int count, const char* one, const char* many, const char* consequence)
    {
        if (count > 0)
            words_.push_back(
                fmt::format("{}: {} {}{}", file_, count, count == 1 ? one : many, consequence));
    }

private:
    std::string file_;
    std::vector<std::string>& words_;
};

} // namespace

BakedMesh::BakedMesh(const BakeOptions& options) : file_(options.mesh_file)
{
    const MeshFile read = read_mesh(file_);
    for (const std::string& tag : read.unknown_tags)
        warnings_.push_back(
            fmt::format("{}: tag '{}' is not known and was left out", file_.string(), tag));
    const SubdivisionRules rules = rules_in_effect(options.subdivision.rules, read.mesh.rules);
    const UvCharts charts = uv_charts(read.mesh);
    record_.scheme = scheme_name(options.subdivision.scheme);
    record_.boundary = boundary_name(*rules.boundary);
    record_.uv_interpolation = uv_interpolation_name(*rules.uv);
    record_.faces = static_cast<int>(read.mesh.face_sizes.size());
    record_.charts = charts.count;
    record_.mirrored_charts = charts.mirrored;
    surface_ = std::make_unique<LimitSurface>(read.mesh, options.subdivision);
    metrics_ = std::make_unique<TexelMetrics>(*surface_);

    const MeshWarnings odd = check_mesh(read.mesh);
    Findings found(file_.string(), warnings_);
    found.say(odd.polygons, "face", "faces",
              " of more than four corners; subdivision makes "
              "quadrilaterals of them around a new vertex");
    found.say(odd.nonmanifold_edges, "edge", "edges",
              " of three or more faces, or of two that are turned against each other; the surface "
              "is creased there");
    found.say(odd.degenerate_faces, "face", "faces", " without area, or with a vertex twice");
    found.say(odd.zero_area_uv_faces, "face", "faces",
              " without area in the texture: nothing of it lies there");
    found.say(metrics_->faces_without_surface(), "face", "faces",
              " without a surface: holes, or beside a border where --boundary is none; they cover "
              "no texel");
    found.say(odd.unused_vertices, "vertex", "vertices", " of no face");
    found.say(tiles_without_number(), "tile", "tiles",
              " of the texture that faces reach into can have no UDIM number (u < 0, u >= 10 or v "
              "< 0): they are left out");
}

BakedMesh::~BakedMesh() = default;

std::vector<int> BakedMesh::tiles() const
{
    std::vector<int> numbers;
    for (const auto& [u, v] : metrics_->tiles())
        if (has_number({u, v}))
            numbers.push_back(UdimTile{u, v}.number());
    return numbers; // by v, then u: rising
}

int BakedMesh::tiles_without_number() const
{
    const auto tiles = metrics_->tiles();
    return static_cast<int>(std::count_if(tiles.begin(), tiles.end(), [](const auto& tile) {
        return !has_number({tile.first, tile.second});
    }));
}

InputRecord BakedMesh::input() const
{
    InputRecord record;
    record.role = "mesh";
    record.file = file_.filename().string();
    record.sha256 = sha256_of_file(file_);
    return record;
}

} // namespace scree
