#include "pipeline/tile_borders.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// A place between the texels of an edge.
struct Between {
    size_t first, second;
    double part; ///< of the second

    /// The middle of texel `i` of `count`, among `other_count` texels; beyond the outermost ones
    /// as between them and the next.
    Between(size_t i, size_t count, size_t other_count)
    {
        const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(count) *
                                 static_cast<double>(other_count) -
                             0.5;
        const auto steps = static_cast<double>(other_count - 1);
        first = static_cast<size_t>(std::clamp(place, 0.0, std::max(steps - 1, 0.0)));
        second = std::min(first + 1, other_count - 1);
        part = count == other_count ? 0 : place - static_cast<double>(first);
        if (count == other_count)
            first = i;
    }

    template <class T>
    [[nodiscard]] T of(const std::vector<T>& values) const
    {
        if (part == 0) // the other may be NaN
            return values[first];
        return values[first] * (1 - part) + values[second] * part;
    }
};

/// Whether the surface goes on from a texel of one edge to a place of the other.
bool meets(const MapEdge& own, size_t i, const MapEdge& other, const Between& there)
{
    if (own.place.empty())
        return true;
    // Between the other's places lies an arc, the straight line beside it.
    const double spacing = (other.place[there.first] - other.place[there.second]).length();
    const double bulge = there.part == 0 ? 0 : spacing / 4;
    const double reach = (own.reach[i] + there.of(other.reach)) / 2 + bulge;
    return (own.place[i] - there.of(other.place)).length() < reach; // never with NaN
}

/// The heights one texel beyond an edge.
///
/// texel, other_texel  sizes across the border, in units of both
std::vector<double> beyond(const MapEdge& own, double texel, const MapEdge& other,
                           double other_texel)
{
    const size_t count = own.height.size();
    std::vector<double> heights(count, kNothingBeyond);
    for (size_t i = 0; i < count; ++i) {
        const Between there(i, count, other.height.size());
        if (!meets(own, i, other, there))
            continue;
        const double height = there.of(other.height);
        heights[i] = texel == other_texel ? height
                                          : own.height[i] + (height - own.height[i]) *
                                                                (2 * texel / (texel + other_texel));
    }
    return heights;
}

/// The map beside one, or where it wraps itself, or null.
const BorderedMap* neighbour(const BorderedMap& map, const std::vector<BorderedMap>& maps, int du,
                             int dv, bool wraps_s, bool wraps_t)
{
    const auto at = [&](int u, int v) {
        const auto found = std::find_if(maps.begin(), maps.end(), [&](const BorderedMap& other) {
            return other.tile.u == u && other.tile.v == v;
        });
        return found == maps.end() ? nullptr : &*found;
    };
    const UdimTile& own = map.tile;
    if (const BorderedMap* there = at(own.u + du, own.v + dv))
        return there;
    const bool wraps = (du == 0 || wraps_s) && (dv == 0 || wraps_t);
    return wraps ? &map : nullptr;
}

} // namespace

Surroundings surroundings_of(const BorderedMap& map, const std::vector<BorderedMap>& maps,
                             bool wraps_s, bool wraps_t)
{
    const auto rows = static_cast<size_t>(map.height), columns = static_cast<size_t>(map.width);
    const auto beside = [&](int du, int dv) {
        return neighbour(map, maps, du, dv, wraps_s, wraps_t);
    };
    const auto side = [&](Side own, int du, int dv) {
        const BorderedMap* there = beside(du, dv);
        if (there == nullptr)
            return std::vector<double>(du != 0 ? rows : columns, kNothingBeyond);
        const double texel = du != 0 ? 1.0 / map.width : 1.0 / map.height;
        const double other_texel = du != 0 ? 1.0 / there->width : 1.0 / there->height;
        return beyond(map.edges[own], texel, there->edges[opposite(own)], other_texel);
    };
    // A corner is the diagonal neighbour's, if the way there, across the map above or below, meets.
    const auto corner = [&](int du, int dv, double across_t) {
        const BorderedMap* there = beside(du, dv);
        const BorderedMap* between = beside(0, dv);
        if (there == nullptr || between == nullptr || std::isinf(across_t))
            return kNothingBeyond;
        for (const BorderedMap* other : {there, between})
            if (other->width != map.width || other->height != map.height)
                return kNothingBeyond;
        const Side toward = du < 0 ? kLeft : kRight;
        const MapEdge& from = between->edges[toward];
        const MapEdge& to = there->edges[opposite(toward)];
        const size_t row = dv > 0 ? rows - 1 : 0;
        return meets(from, row, to, Between(row, rows, rows)) ? to.height[row] : kNothingBeyond;
    };

    Surroundings around;
    around.left = side(kLeft, -1, 0);
    around.right = side(kRight, 1, 0);
    const std::vector<double> above = side(kTop, 0, 1), below = side(kBottom, 0, -1);
    const auto row_of = [&](const std::vector<double>& heights, int dv) {
        std::vector<double> row(columns + 2);
        row.front() = corner(-1, dv, heights.front());
        std::copy(heights.begin(), heights.end(), row.begin() + 1);
        row.back() = corner(1, dv, heights.back());
        return row;
    };
    around.above = row_of(above, 1);
    around.below = row_of(below, -1);
    return around;
}

} // namespace scree
