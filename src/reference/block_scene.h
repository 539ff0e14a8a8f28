#pragma once

#include <memory>
#include <optional>

#include "reference/grid_ray.h"

namespace scree::reference {

/// Rays against the cells of a grid: Embree finds the blocks of cells that a ray may touch, the
/// cells are marched and solved in double precision.
///
/// Embree works in float, so a block's box is wider than the block by more than the rounding of the
/// ray. Cells with a corner without data hide nothing. Thread safe once made.
class BlockScene {
public:
    /// grid  must outlive the scene
    /// Throws Error when Embree refuses.
    explicit BlockScene(const NodeGrid& grid);
    ~BlockScene();
    BlockScene(const BlockScene&) = delete;
    BlockScene& operator=(const BlockScene&) = delete;

    /// Whether the ray lies more than the grid's tolerance below the surface anywhere in its first
    /// `length` steps.
    [[nodiscard]] bool is_below(const GridRay& ray, double length) const;

    /// The first of these steps at which the ray meets the surface, from above or below: the two
    /// are within the grid's tolerance of each other, or change sides.
    [[nodiscard]] std::optional<double> first_meeting(const GridRay& ray, double length) const;

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

} // namespace scree::reference
