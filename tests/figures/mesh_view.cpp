#include "figures/mesh_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/metric.h"

namespace scree::test {
namespace {

/// Calls back with every point of a grid over the pieces of every face.
template <class Look>
void for_points(const LimitSurface& surface, int points_a_side, const Look& look)
{
    for (int i = 0; i < surface.face_count(); ++i) {
        const FaceSurface face = surface.face(i);
        for (const ParameterPiece& piece : face.pieces())
            for (int q = 0; q < points_a_side; ++q)
                for (int p = 0; p + (piece.triangle ? q : 0) < points_a_side; ++p) {
                    const Vec2 inside(p + 0.5, q + 0.5);
                    look(face, piece.origin + inside * (piece.size / points_a_side));
                }
    }
}

struct Camera {
    Vec3 right, up, toward;
    Vec2 low, high;

    [[nodiscard]] Vec2 across(const Vec3& position) const
    {
        return {position ^ right, position ^ up};
    }
};

Camera fitted_camera(const LimitSurface& surface, const Vec3& toward)
{
    Camera camera;
    camera.toward = toward.normalized();
    camera.right = (Vec3(0, 1, 0) % camera.toward).normalized();
    camera.up = camera.toward % camera.right;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    camera.low = {kFar, kFar};
    camera.high = {-kFar, -kFar};
    for_points(surface, 8, [&](const FaceSurface& face, const Vec2& place) {
        const Vec2 at = camera.across(face.at(place).position);
        camera.low = {std::min(camera.low.x, at.x), std::min(camera.low.y, at.y)};
        camera.high = {std::max(camera.high.x, at.x), std::max(camera.high.y, at.y)};
    });
    return camera;
}

} // namespace

std::vector<SeenPoint> view_of_surface(const LimitSurface& surface, int size, const Vec3& toward)
{
    const Camera camera = fitted_camera(surface, toward);
    const Vec2 extent = camera.high - camera.low, middle = (camera.high + camera.low) * 0.5;
    const double scale = 0.96 * size / std::max(extent.x, extent.y);
    std::vector<SeenPoint> seen(static_cast<size_t>(size) * static_cast<size_t>(size));
    for (SeenPoint& point : seen)
        point.depth = -std::numeric_limits<double>::infinity();
    // Points closer than pixels: a face is a third of the picture at most.
    for_points(surface, size / 3, [&](const FaceSurface& face, const Vec2& place) {
        const SurfacePoint point = face.at(place);
        const Vec3 normal = unit_normal(point);
        if (!((normal ^ camera.toward) > 0))
            return;
        const Vec2 at = camera.across(point.position) - middle;
        const int x = static_cast<int>(0.5 * size + scale * at.x);
        const int y = static_cast<int>(0.5 * size - scale * at.y);
        const double depth = point.position ^ camera.toward;
        SeenPoint& here =
            seen[static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x)];
        if (depth <= here.depth)
            return;
        const UvPoint uv = face.uv_at(place);
        const TangentFrame frame = tangent_frame(tangents(point, uv));
        here = {depth, {uv.uv.x, 1 - uv.uv.y}, frame.x, frame.y, normal};
    });
    return seen;
}

} // namespace scree::test
