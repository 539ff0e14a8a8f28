#include "surface/metric_rows.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// A texel on the border of two faces lies in both without any overlap: at most so far inside of
/// the one, by rounding, and so far inside of the other, which may be much smaller.
constexpr float kOnBorder = 1e-6F, kOnBorderOfSmaller = 1e-3F;

bool is_overlap(float inside, float inside_other)
{
    return std::min(inside, inside_other) > kOnBorder ||
           std::max(inside, inside_other) > kOnBorderOfSmaller;
}

/// Derivatives carry rounding of so many times the distance from the origin.
constexpr double kRounding = 1e-11;

bool has_area(const SurfacePoint& point)
{
    const double noise = kRounding * point.position.length();
    return (point.by_p % point.by_q).length() > noise * (point.by_p.length() + point.by_q.length());
}

/// False where the surface or its texture has no area.
bool measure(const FaceSurface& surface, const UvHit& hit, TexelMetric& texel)
{
    const SurfacePoint point = surface.at(hit.place);
    texel.position = point.position;
    texel.tangents = tangents(point, hit.uv);
    texel.normal = unit_normal(point);
    texel.area = (texel.tangents.by_s % texel.tangents.by_t).length();
    const double curvature = largest_curvature(point, texel.normal);
    texel.curvature = static_cast<float>(curvature);
    texel.mirrored = hit.uv.by_p % hit.uv.by_q < 0;
    return has_area(point) && texel.area > 0 && std::isfinite(texel.area) &&
           std::isfinite(curvature) &&
           std::isfinite(texel.tangents.by_s.length2() + texel.tangents.by_t.length2());
}

/// The place `step` further along u, to first order.
Vec2 beside(const UvHit& hit, double step)
{
    const double determinant = hit.uv.by_p % hit.uv.by_q;
    return hit.place + Vec2(hit.uv.by_q.y, -hit.uv.by_p.y) * (step / determinant);
}

/// Gives the texel to the face, unless it has one. Returns whether they overlap there.
bool take(const ReadyFace& face, const UvHit& hit, float inside, TexelMetric& texel,
          TexelCounts& counts)
{
    if (texel.face >= 0) {
        texel.overlapped = is_overlap(inside, texel.inside);
        counts.overlapped += texel.overlapped ? 1 : 0;
        return texel.overlapped;
    }
    TexelMetric found;
    found.face = face.index;
    found.inside = inside;
    if (!measure(face.surface, hit, found)) {
        ++counts.singular;
        return false;
    }
    texel = found;
    ++counts.covered;
    counts.mirrored += found.mirrored ? 1 : 0;
    return false;
}

/// The first and last of the integers in [low, high] that lie in [0, count).
struct IntegerRange {
    int first, last;

    IntegerRange(double low, double high, int count)
        : first(static_cast<int>(std::ceil(std::clamp(low, 0.0, 1.0 * count)))),
          last(static_cast<int>(std::floor(std::clamp(high, -1.0, count - 1.0))))
    {}
};

} // namespace

ReadyFace::ReadyFace(const LimitSurface& of, int face)
    : index(face), surface(of.face(face)), cells(uv_cells(surface))
{}

TexelRows::TexelRows(const TexelGrid& grid, int first, int count, TexelMetric* texels)
    : grid_(grid), first_(first), count_(count), texels_(texels)
{}

double TexelRows::u_of(double x) const { return grid_.tile_u + (x + 0.5) / grid_.width; }

double TexelRows::v_of(double row) const
{
    return grid_.tile_v + 1 - (first_ + row + 0.5) / grid_.height;
}

UvBox TexelRows::box() const
{
    return {Vec2(u_of(0), v_of(count_ - 1)), Vec2(u_of(grid_.width - 1), v_of(0))};
}

void TexelRows::clear() const
{
    std::fill_n(texels_, static_cast<size_t>(count_) * static_cast<size_t>(grid_.width),
                TexelMetric());
}

void TexelRows::draw(const std::vector<ReadyFace>& faces, int begin, int end,
                     TexelCounts& counts) const
{
    for (const ReadyFace& face : faces)
        for (const UvCell& cell : face.cells)
            draw_cell(face, cell, begin, end, counts);
}

void TexelRows::draw_cell(const ReadyFace& face, const UvCell& cell, int begin, int end,
                          TexelCounts& counts) const
{
    const UvSpan height = height_of(cell);
    const auto row_of = [&](double v) {
        return (grid_.tile_v + 1 - v) * grid_.height - 0.5 - first_;
    };
    const IntegerRange rows(row_of(height.high), row_of(height.low), end);
    for (int row = std::max(begin, rows.first); row <= rows.last; ++row)
        draw_span(face, cell, row, counts);
}

void TexelRows::draw_span(const ReadyFace& face, const UvCell& cell, int row,
                          TexelCounts& counts) const
{
    const double v = v_of(row);
    const UvSpan span = span_at(cell, v);
    const auto column_of = [&](double u) { return (u - grid_.tile_u) * grid_.width - 0.5; };
    const IntegerRange columns(column_of(span.low), column_of(span.high), grid_.width);
    const ParameterPiece& piece = face.surface.pieces()[static_cast<size_t>(cell.piece)];
    TexelMetric* line = texels_ + static_cast<size_t>(row) * static_cast<size_t>(grid_.width);
    const double step = 1.0 / grid_.width;
    std::optional<UvHit> hit;
    for (int x = columns.first; x <= columns.last; ++x) {
        TexelMetric& texel = line[x];
        // Drawn by a neighbouring cell, or nothing more to know.
        if (texel.face == face.index || texel.overlapped) {
            hit.reset();
            continue;
        }
        const Vec2 uv(u_of(x), v);
        if (hit)
            hit = find_uv(face.surface, piece, uv, beside(*hit, step));
        if (!hit)
            hit = find_uv(face.surface, piece, uv, cell.middle);
        if (!hit)
            continue;
        const auto inside = static_cast<float>(piece.border_distance(hit->place));
        if (take(face, *hit, inside, texel, counts))
            counts.note_overlap({x, first_ + row, texel.face, face.index});
    }
}

} // namespace scree
