#include "surface/uv_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

/// Most cells along a side of a piece.
constexpr int kMostCells = 8;
/// A cell may bend by so much of its extent: Newton's method converges from its middle.
constexpr double kBend = 0.1;
/// Points on an edge must not fall between two cells by rounding.
constexpr double kRounding = 1e-9;

/// Middle of an edge minus the mean of its ends, twice: the second difference.
double bend(const Vec2& a, const Vec2& middle, const Vec2& b)
{
    return (a - middle * 2 + b).length();
}

class Cutter {
public:
    Cutter(const FaceSurface& face, int piece)
        : face_(face), piece_index_(piece), piece_(face.pieces()[static_cast<size_t>(piece)])
    {}

    void cut(std::vector<UvCell>& cells) const
    {
        const int count = cells_a_side();
        const double side = 1.0 / count;
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) {
                const Vec2 a(i * side, j * side), b((i + 1) * side, j * side),
                    c((i + 1) * side, (j + 1) * side), d(i * side, (j + 1) * side);
                if (!piece_.triangle) {
                    add(cells, {a, b, c, d});
                    continue;
                }
                if (i + j < count)
                    add(cells, {a, b, d, d});
                if (i + j + 1 < count)
                    add(cells, {b, c, d, d});
            }
    }

private:
    /// at  in parts of the piece
    [[nodiscard]] Vec2 place(const Vec2& at) const
    {
        return piece_.clamp(piece_.origin + at * piece_.size);
    }

    [[nodiscard]] Vec2 uv(const Vec2& at) const { return face_.uv_at(place(at)).uv; }

    /// As many as bring a cell's bend, which falls with its size, below kBend of its extent.
    [[nodiscard]] int cells_a_side() const
    {
        Vec2 node[3][3];
        const int last = 2;
        for (int j = 0; j <= last; ++j)
            for (int i = 0; i <= last; ++i)
                if (!piece_.triangle || i + j <= last)
                    node[j][i] = uv(Vec2(i, j) / 2);
        double most = std::max(bend(node[0][0], node[0][1], node[0][2]),
                               bend(node[0][0], node[1][0], node[2][0]));
        most = std::max(most, bend(node[0][2], node[1][1], node[2][0]));
        double extent =
            std::min((node[0][2] - node[0][0]).length(), (node[2][0] - node[0][0]).length());
        if (!piece_.triangle) {
            most = std::max({most, bend(node[0][0], node[1][1], node[2][2]),
                             bend(node[2][0], node[2][1], node[2][2]),
                             bend(node[0][2], node[1][2], node[2][2])});
            extent = std::min(
                {extent, (node[2][2] - node[2][0]).length(), (node[2][2] - node[0][2]).length()});
        }
        const double parts = most / (kBend * extent);
        return parts < kMostCells ? std::max(1, static_cast<int>(std::ceil(parts))) : kMostCells;
    }

    void add(std::vector<UvCell>& cells, const std::array<Vec2, 4>& corners) const
    {
        const bool triangle = piece_.triangle;
        UvCell cell;
        cell.piece = piece_index_;
        for (size_t i = 0; i < 4; ++i)
            cell.corners[i] = uv(corners[i]);
        const Vec2 middle = triangle ? (corners[0] + corners[1] + corners[2]) / 3
                                     : (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        cell.middle = place(middle);
        cell.margin = kRounding;
        if (!face_.has_linear_uvs())
            cell.margin += 2 * deviation(corners, cell);
        cells.push_back(cell);
    }

    /// Of middles from the means of corners.
    [[nodiscard]] double deviation(const std::array<Vec2, 4>& corners, const UvCell& cell) const
    {
        Vec2 mean(0, 0);
        double most = 0;
        const size_t count = piece_.triangle ? 3 : 4;
        for (size_t i = 0; i < count; ++i) {
            const size_t next = (i + 1) % count;
            mean += cell.corners[i] / static_cast<double>(count);
            most = std::max(most, bend(cell.corners[i], uv((corners[i] + corners[next]) / 2),
                                       cell.corners[next]) /
                                      2);
        }
        return std::max(most, (face_.uv_at(cell.middle).uv - mean).length());
    }

    const FaceSurface& face_;
    int piece_index_;
    const ParameterPiece& piece_;
};

/// Widens `span` by the part of the line a b with low <= v <= high.
void take_line(const Vec2& a, const Vec2& b, double low, double high, UvSpan& span)
{
    const Vec2 &below = a.y <= b.y ? a : b, &above = a.y <= b.y ? b : a;
    if (below.y > high || above.y < low)
        return;
    const double rise = above.y - below.y;
    const auto u_at = [&](double v) {
        return rise > 0 ? below.x + (above.x - below.x) * ((v - below.y) / rise) : above.x;
    };
    const double first = below.y < low ? u_at(low) : below.x;
    const double last = above.y > high ? u_at(high) : above.x;
    span.low = std::min({span.low, first, last});
    span.high = std::max({span.high, first, last});
}

} // namespace

std::vector<UvCell> uv_cells(const FaceSurface& face)
{
    std::vector<UvCell> cells;
    for (size_t i = 0; i < face.pieces().size(); ++i)
        Cutter(face, static_cast<int>(i)).cut(cells);
    return cells;
}

UvSpan span_at(const UvCell& cell, double v)
{
    // The convex hull of four points is that of all lines between them.
    constexpr double kFar = std::numeric_limits<double>::infinity();
    UvSpan span{kFar, -kFar};
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j)
            take_line(cell.corners[i], cell.corners[j], v - cell.margin, v + cell.margin, span);
    return {span.low - cell.margin, span.high + cell.margin};
}

UvSpan height_of(const UvCell& cell)
{
    const auto& [a, b, c, d] = cell.corners;
    return {std::min({a.y, b.y, c.y, d.y}) - cell.margin,
            std::max({a.y, b.y, c.y, d.y}) + cell.margin};
}

} // namespace scree
