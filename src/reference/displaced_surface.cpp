#include "reference/displaced_surface.h"

#include <cassert>
#include <utility>

#include "reference/block_scene.h"
#include "reference/patch.h"
#include "reference/tiling.h"

namespace scree::reference {
namespace {

/// Images of the relief that a ray may cross before it counts as free: only rays that are level
/// with the mean plane to 1e-6 or so come to it.
constexpr long kMostImages = 1000000;

constexpr double kFromCentre = 0.5; // grid coordinates minus texels

} // namespace

struct DisplacedSurface::Scene {
    Relief relief;
    NodeGrid grid;
    Tiling tiling;
    BlockScene blocks;

    explicit Scene(Relief of) : relief(std::move(of)), grid(relief), tiling(relief), blocks(grid) {}

    int column_of(double s) const
    {
        return std::clamp(static_cast<int>(std::floor(s)), 0, relief.width - 1);
    }
    int row_of(double t) const
    {
        return std::clamp(static_cast<int>(std::floor(t)), 0, relief.height - 1);
    }
    bool has_data(int column, int row) const { return !std::isnan(grid.row(row + 1)[column + 1]); }

    /// A ray whose step moves it by one texel or by the range of heights, whichever comes first:
    /// numbers near 1, whatever the units.
    GridRay ray(double x, double y, double z, const Vec3& w) const;

    /// World units in a step of ray(), for a unit vector w.
    double step_length(const Vec3& w) const;

    /// Follows a ray from inside through the images of the relief, part by part, until
    /// meets(part, length) returns true.
    ///
    /// returns the steps to the beginning of that part; nothing if there is none
    template <class Meets>
    std::optional<double> follow(GridRay ray, double length, const Meets& meets) const;
};

double DisplacedSurface::Scene::step_length(const Vec3& w) const
{
    const double rise = grid.range() > 0 ? std::abs(w.z) / grid.range() : 0;
    const double per_unit =
        std::max({std::abs(w.x) / relief.texel_width, std::abs(w.y) / relief.texel_height, rise});
    return per_unit > 0 ? 1 / per_unit : 1; // straight at a level surface: any will do
}

GridRay DisplacedSurface::Scene::ray(double x, double y, double z, const Vec3& w) const
{
    const double step = step_length(w);
    return {x, y, z, step * w.x / relief.texel_width, step * w.y / relief.texel_height, step * w.z};
}

template <class Meets>
std::optional<double> DisplacedSurface::Scene::follow(GridRay ray, double length,
                                                      const Meets& meets) const
{
    double done = 0;
    for (long image = 0; image < kMostImages; ++image) {
        const double leaves = tiling.leaves(ray);
        if (meets(ray, std::min(leaves, length - done)))
            return done;
        done += leaves;
        if (done >= length || !tiling.go_on(ray))
            break;
    }
    return {};
}

DisplacedSurface::DisplacedSurface(Relief relief)
{
    [[maybe_unused]] const size_t texels =
        static_cast<size_t>(relief.width) * static_cast<size_t>(relief.height);
    assert(relief.width > 0 && relief.height > 0 && relief.heights.size() == texels);
    assert(relief.colors.empty() || relief.colors.size() == texels);
    assert(relief.weights.empty() || relief.weights.size() == texels);
    assert(relief.texel_width > 0 && relief.texel_height > 0);
    scene_ = std::make_unique<Scene>(std::move(relief));
}

DisplacedSurface::~DisplacedSurface() = default;
DisplacedSurface::DisplacedSurface(DisplacedSurface&&) noexcept = default;
DisplacedSurface& DisplacedSurface::operator=(DisplacedSurface&&) noexcept = default;

const Relief& DisplacedSurface::relief() const { return scene_->relief; }
double DisplacedSurface::lowest() const { return scene_->grid.base(); }
double DisplacedSurface::highest() const { return scene_->grid.base() + scene_->grid.range(); }

SurfacePoint DisplacedSurface::at(double s, double t) const
{
    const Relief& relief = scene_->relief;
    const int column = scene_->column_of(s), row = scene_->row_of(t);
    SurfacePoint point;
    if (!scene_->has_data(column, row))
        return point;
    const PatchPoint patch = patch_at(scene_->grid, column, row, s + kFromCentre, t + kFromCentre);
    point.height = scene_->grid.base() + patch.height;
    point.slope = {patch.slope.x / relief.texel_width, patch.slope.y / relief.texel_height};
    const size_t texel =
        static_cast<size_t>(row) * static_cast<size_t>(relief.width) + static_cast<size_t>(column);
    point.color = relief.colors.empty() ? Rgb{1, 1, 1} : relief.colors[texel];
    point.weight = relief.weights.empty() ? 1 : static_cast<double>(relief.weights[texel]);
    return point;
}

bool DisplacedSurface::is_open(double s, double t, const Vec3& w) const
{
    const int column = scene_->column_of(s), row = scene_->row_of(t);
    if (!scene_->has_data(column, row))
        return false;
    const double x = s + kFromCentre, y = t + kFromCentre;
    const double z = patch_at(scene_->grid, column, row, x, y).height;
    if (z >= scene_->grid.range())
        return true;
    const GridRay ray = scene_->ray(x, y, z, w);
    const double rises_clear = (scene_->grid.range() - z) / ray.dz;
    return !scene_->follow(ray, rises_clear, [&](const GridRay& part, double length) {
        return scene_->blocks.is_below(part, length);
    });
}

std::optional<SurfaceHit> DisplacedSurface::hit(const Vec3& origin, const Vec3& direction) const
{
    const Relief& relief = scene_->relief;
    const NodeGrid& grid = scene_->grid;
    GridRay ray = scene_->ray(origin.x / relief.texel_width + kFromCentre,
                              origin.y / relief.texel_height + kFromCentre, origin.z - grid.base(),
                              direction);
    // There is nothing to meet but between the lowest and the highest.
    Span span{0, std::numeric_limits<double>::infinity()};
    span = RayAxis(ray.z, ray.dz).within(0, grid.range(), span);
    span = scene_->tiling.inside(ray, span);
    if (!(span.from <= span.to))
        return {};
    ray.advance(span.from);
    ray.z = std::clamp(ray.z, 0.0, grid.range());
    scene_->tiling.fold(ray);

    SurfaceHit hit;
    const auto before =
        scene_->follow(ray, span.to - span.from, [&](const GridRay& part, double length) {
            const auto met = scene_->blocks.first_meeting(part, length);
            if (met)
                hit = {part.x_at(*met) - kFromCentre, part.y_at(*met) - kFromCentre, *met};
            return met.has_value();
        });
    if (!before)
        return {};
    auto below = [](double place, int size) { // [0, size)
        return std::clamp(place, 0.0, std::nextafter(static_cast<double>(size), 0.0));
    };
    hit.s = below(hit.s, relief.width);
    hit.t = below(hit.t, relief.height);
    hit.distance = (span.from + *before + hit.distance) * scene_->step_length(direction);
    return hit;
}

} // namespace scree::reference
