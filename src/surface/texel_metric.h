#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "surface/limit_surface.h"
#include "surface/metric.h"

namespace scree {

/// The texels of one tile: centre (x + 0.5) / width to the right of u = tile_u, and
/// (y + 0.5) / height below v = tile_v + 1.
struct TexelGrid {
    int width = 1, height = 1;
    int tile_u = 0, tile_v = 0; ///< UDIM 1001 + tile_u + 10 tile_v
};

/// What a mesh says about one texel, at its centre.
struct TexelMetric {
    int face = -1;           ///< of the cage; -1 outside of all charts, where nothing below counts
    bool mirrored = false;   ///< the texture is seen from its back: clockwise UVs
    bool overlapped = false; ///< other faces lie here too; the first one counts
    float inside = 0; ///< distance to the border, in parts of the face (or of its corner's share)
    float curvature = 0; ///< largest absolute normal curvature, 1 / world unit
    Vec3 position{0, 0, 0};
    Tangents tangents;    ///< world units per texture unit
    Vec3 normal{0, 0, 1}; ///< unit, outside
    double area = 0;      ///< world area per texture area: the texel's weight
};

/// A texel where two faces lie, of all of those the two lowest.
struct UvOverlap {
    int x = 0, y = 0;
    int face = 0, other = 0; ///< of the cage
};

/// Texels of some rows.
struct TexelCounts {
    int64_t covered = 0;
    int64_t overlapped = 0, mirrored = 0; ///< of those
    int64_t singular =
        0; ///< left out: in a chart, but the surface or its texture has no area there
    std::optional<UvOverlap> first_overlap; ///< from the top, then from the left

    /// Keeps the earlier of two.
    void note_overlap(const UvOverlap& overlap);
    TexelCounts& operator+=(const TexelCounts& other);
};

/// Evaluates a surface at texels, some rows at a time, in parallel; the same bytes with any number
/// of threads. Holds 32 bytes a face; a call holds a few hundred faces more.
class TexelMetrics {
public:
    /// surface  must live longer
    explicit TexelMetrics(const LimitSurface& surface);

    /// Tiles (u, v) that faces reach into by more than 1e-5, sorted by v, then u. A face counts by
    /// its box, so a tile may be listed whose texels are all outside.
    [[nodiscard]] std::vector<std::pair<int, int>> tiles() const;

    /// Holes, faces at a boundary without rule, and what else OpenSubdiv has no surface of: they
    /// cover no texel.
    [[nodiscard]] int faces_without_surface() const;

    /// texels  gets count x width of rows [first, first + count); 64 rows and more share the
    ///         preparing of faces well
    TexelCounts rows(const TexelGrid& grid, int first, int count, TexelMetric* texels) const;

private:
    struct Box {
        Vec2 low, high;
        [[nodiscard]] bool is_empty() const { return low.x > high.x; }
    };

    const LimitSurface& surface_;
    std::vector<Box> boxes_; ///< of the faces' texture coordinates
};

} // namespace scree
