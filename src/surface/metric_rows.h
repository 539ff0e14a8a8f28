#pragma once

#include <optional>
#include <vector>

#include "surface/texel_metric.h"
#include "surface/uv_cells.h"
#include "surface/uv_search.h"

namespace scree {

/// A box in texture coordinates.
struct UvBox {
    Vec2 low, high;

    [[nodiscard]] bool meets(const Vec2& other_low, const Vec2& other_high) const
    {
        return other_low.x <= high.x && other_high.x >= low.x && other_low.y <= high.y &&
               other_high.y >= low.y;
    }
};

/// A face and where its texels are looked for.
struct ReadyFace {
    ReadyFace() = default;
    ReadyFace(const LimitSurface& of, int face);

    int index = -1;
    FaceSurface surface;
    std::vector<UvCell> cells;
};

/// The texels of a band of rows while faces are drawn into them, one after another by rising index.
class TexelRows {
public:
    /// texels  count x width, of rows [first, first + count) of the tile
    TexelRows(const TexelGrid& grid, int first, int count, TexelMetric* texels);

    [[nodiscard]] UvBox box() const;
    /// No texel has a face.
    void clear() const;
    /// Draws into rows [begin, end) of the band; other rows may be drawn at the same time.
    void draw(const std::vector<ReadyFace>& faces, int begin, int end, TexelCounts& counts) const;

private:
    void draw_cell(const ReadyFace& face, const UvCell& cell, int begin, int end,
                   TexelCounts& counts) const;
    void draw_span(const ReadyFace& face, const UvCell& cell, int row, TexelCounts& counts) const;
    [[nodiscard]] double u_of(double x) const;
    [[nodiscard]] double v_of(double row) const;

    TexelGrid grid_;
    int first_, count_;
    TexelMetric* texels_;
};

} // namespace scree
