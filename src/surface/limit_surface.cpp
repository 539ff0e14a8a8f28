#include "surface/limit_surface.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/bfr/surfaceFactoryCache.h>

#include <algorithm>
#include <mutex>
#include <shared_mutex>
#include <utility>

#include "surface/refiner.h"

namespace scree {

namespace Bfr = OpenSubdiv::Bfr;

namespace {

using Surface = Bfr::Surface<double>;
using Cache =
    Bfr::SurfaceFactoryCacheThreaded<std::shared_mutex, std::shared_lock<std::shared_mutex>,
                                     std::unique_lock<std::shared_mutex>>;

/// The most that the library takes, for smooth and for creased vertices. A face around one costs
/// 7 us to prepare, and no more to evaluate than at 2.
constexpr int kIsolation = 10;
/// At poles, where the cost of preparing a face grows with the square of the faces there: the
/// library's own default for smooth vertices.
constexpr int kIsolationAtPoles = 2;
/// More faces at a vertex, or corners of a face, make a pole.
constexpr int kMostAtVertex = 64;

Bfr::SurfaceFactory::Options factory_options(int smooth_isolation)
{
    Bfr::SurfaceFactory::Options options;
    options.SetDefaultFVarID(0);
    options.SetApproxLevelSmooth(smooth_isolation);
    options.SetApproxLevelSharp(kIsolation);
    return options;
}

/// Whether each face is at a pole.
std::vector<bool> faces_at_poles(const Mesh& mesh)
{
    std::vector<int> faces_of(mesh.vertices.size());
    for (const int vertex : mesh.face_vertices)
        ++faces_of[static_cast<size_t>(vertex)];
    std::vector<bool> at_pole;
    at_pole.reserve(mesh.face_sizes.size());
    auto corner = mesh.face_vertices.begin();
    for (const int size : mesh.face_sizes) {
        at_pole.push_back(size > kMostAtVertex ||
                          std::any_of(corner, corner + size, [&](int vertex) {
                              return faces_of[static_cast<size_t>(vertex)] > kMostAtVertex;
                          }));
        corner += size;
    }
    return at_pole;
}

std::vector<ParameterPiece> pieces_of(const Bfr::Parameterization& parameters)
{
    using Kind = Bfr::Parameterization;
    if (parameters.GetType() != Kind::QUAD_SUBFACES)
        return {{Vec2(0, 0), 1, parameters.GetType() == Kind::TRI}};
    std::vector<ParameterPiece> pieces;
    for (int i = 0; i < parameters.GetFaceSize(); ++i) {
        const double corner[2] = {0, 0};
        double origin[2] = {};
        parameters.ConvertSubFaceToCoord(i, corner, origin);
        pieces.push_back({Vec2(origin[0], origin[1]), 0.5, false});
    }
    return pieces;
}

} // namespace

Vec2 ParameterPiece::clamp(const Vec2& place) const
{
    Vec2 from(std::clamp(place.x - origin.x, 0.0, size), std::clamp(place.y - origin.y, 0.0, size));
    if (triangle && from.x + from.y > size) {
        const double along = std::clamp((from.x - from.y + size) / 2, 0.0, size);
        from = Vec2(along, size - along);
    }
    return origin + from;
}

double ParameterPiece::border_distance(const Vec2& place) const
{
    const Vec2 from = (place - origin) / size;
    const double near = std::min(from.x, from.y);
    return triangle ? std::min(near, 1 - from.x - from.y)
                    : std::min(near, 1 - std::max(from.x, from.y));
}

struct FaceSurface::Data {
    Surface positions, uvs;
    std::vector<double> position_points, uv_points; ///< 3 and 2 numbers each
};

FaceSurface::FaceSurface() = default;
FaceSurface::~FaceSurface() = default;
FaceSurface::FaceSurface(FaceSurface&&) noexcept = default;
FaceSurface& FaceSurface::operator=(FaceSurface&&) noexcept = default;

SurfacePoint FaceSurface::at(const Vec2& place) const
{
    SurfacePoint out;
    const double pq[2] = {place.x, place.y};
    data_->positions.Evaluate(pq, data_->position_points.data(), 3, out.position.getValue(),
                              out.by_p.getValue(), out.by_q.getValue(), out.by_pp.getValue(),
                              out.by_pq.getValue(), out.by_qq.getValue());
    return out;
}

UvPoint FaceSurface::uv_at(const Vec2& place) const
{
    UvPoint out;
    const double pq[2] = {place.x, place.y};
    data_->uvs.Evaluate(pq, data_->uv_points.data(), 2, out.uv.getValue(), out.by_p.getValue(),
                        out.by_q.getValue());
    return out;
}

bool FaceSurface::has_linear_uvs() const { return data_->uvs.IsLinear(); }

std::pair<Vec2, Vec2> FaceSurface::uv_bounds() const
{
    // All patches blend their points with weights that are not negative and add up to 1.
    const std::vector<double>& points = data_->uv_points;
    Vec2 low(points[0], points[1]), high = low;
    for (size_t i = 2; i < points.size(); i += 2) {
        low = Vec2(std::min(low.x, points[i]), std::min(low.y, points[i + 1]));
        high = Vec2(std::max(high.x, points[i]), std::max(high.y, points[i + 1]));
    }
    return {low, high};
}

struct LimitSurface::Data {
    Data(const Mesh& mesh, const SurfaceOptions& options)
        : uvs(uvs_by_vertex(mesh)), vertices(mesh.vertices),
          refiner(make_refiner(mesh, options, uvs)), factory(*refiner, factory_options(kIsolation)),
          pole_factory(*refiner, factory_options(kIsolationAtPoles)), at_pole(faces_at_poles(mesh))
    {}

    VertexUvs uvs;
    std::vector<Vec3> vertices;
    std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner;
    Bfr::RefinerSurfaceFactory<Cache> factory, pole_factory;
    std::vector<bool> at_pole;
};

LimitSurface::LimitSurface(const Mesh& mesh, const SurfaceOptions& options)
    : data_(std::make_unique<Data>(mesh, options))
{}

LimitSurface::~LimitSurface() = default;

int LimitSurface::face_count() const { return data_->factory.GetNumFaces(); }

FaceSurface LimitSurface::face(int index) const
{
    FaceSurface out;
    auto data = std::make_unique<FaceSurface::Data>();
    const auto& factory =
        data_->at_pole[static_cast<size_t>(index)] ? data_->pole_factory : data_->factory;
    if (!factory.InitSurfaces(index, &data->positions, &data->uvs))
        return out;
    data->position_points.resize(3 * static_cast<size_t>(data->positions.GetNumPatchPoints()));
    data->uv_points.resize(2 * static_cast<size_t>(data->uvs.GetNumPatchPoints()));
    data->positions.PreparePatchPoints(&data_->vertices[0].x, 3, data->position_points.data(), 3);
    data->uvs.PreparePatchPoints(&data_->uvs.values[0].x, 2, data->uv_points.data(), 2);
    out.pieces_ = pieces_of(data->positions.GetParameterization());
    out.data_ = std::move(data);
    return out;
}

} // namespace scree
