#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/original.h"
#include "judge/set_reader.h"

namespace scree {

/// How far one figure of a texture is from brute force over one level.
struct StatisticsFigure {
    Map map = Map::slope;
    std::string name; ///< "mean slope", "slope covariance", "mean color", ...
    int level = 0;
    double largest = 0, rms = 0; ///< errors over the yardstick
    int x = 0, y = 0;            ///< texel of the largest
    double yardstick = 1;        ///< what errors are relative to, in units of the figure
    double tolerance = 0;        ///< of `largest`
};

/// Compares every texel of every level with sums over the original surface.
///
/// progress  is told the share done, in [0, 1]; it may throw to stop
/// Throws Error where the set cannot be read, or is not of the original's size.
std::vector<StatisticsFigure> check_statistics(SetReader& set, const Original& original,
                                               const BakeOptions& options,
                                               const std::function<void(double)>& progress);

} // namespace scree
