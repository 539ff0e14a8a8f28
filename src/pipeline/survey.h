#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pipeline/map_edges.h"
#include "pipeline/options.h"
#include "pipeline/source.h"

namespace scree {

/// What must be known of a whole map before its first texel can be written; of tiles, of them all.
struct Survey {
    double h0 = 0; ///< weighted mean height, world units
    double h1 = 1; ///< its standard deviation; 1 where the map is flat
    double height_min = 0, height_max = 0;
    std::array<float, 3> mean_color{}; ///< weighted, scene-linear
    bool complete = true;              ///< every texel has data, with weight 1
    bool covered = true;               ///< every texel has data, with some weight
    long long no_data_texels = 0;
    MapEdges edges; ///< heights along the sides: what a periodic map, or its neighbour, needs
    bool has_holes = false; ///< heights that slopes are made of may be missing
    /// What goes on beyond the sides, where it is more than a wrap says.
    std::optional<Surroundings> around;
    Rejects rejects;
    double weight = 0;   ///< sum over the texels
    double variance = 0; ///< of the heights; h1 is its root, or 1
};

/// Strips in which a map is read: one row of tiles of level 0.
constexpr int kStripRows = 64;

/// The first, cheap pass over the input.
///
/// Means and variances are merged row by row (Chan et al.), in the order of the rows. Throws Error
/// when no texel has data.
Survey survey(Source& source, const BakeMonitor& monitor);

/// The same; without data its weight is 0, and the rest means nothing.
Survey survey_if_any(Source& source, const BakeMonitor& monitor);

[[noreturn]] void refuse_without_data(const Source& source);

/// Makes what several maps of one surface are normalised and filled with that of all of them: h0,
/// h1, range and mean color.
///
/// areas  what a texel of weight 1 stands for in each map, in one unit
void unite(const std::vector<Survey*>& surveys, const std::vector<double>& areas);

} // namespace scree
