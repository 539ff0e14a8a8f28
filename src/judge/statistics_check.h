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
    double largest = 0, rms = 0; ///< errors over the yardstick; infinite where a number is none
    int x = 0, y = 0;            ///< texel of the largest
    double yardstick = 1;        ///< what errors are relative to, in units of the figure
    double tolerance = 0;        ///< of `largest`
};

/// Compares every texel of every level with sums over the original surface.
///
/// What is compared is what a reader recovers: means, covariances, rank terms, tau, coverage.
/// Yardsticks are those of pipeline/storage_error.h, of the truth; that of a mean slope is the
/// largest of its level or the map's rms slope, that of a height in world units the map's
/// deviation. The mean and deviation of the height that the manifest has come first, as of level 0.
/// A product with another texture's mean is held against the true mean.
///
/// Tolerances: of half textures what the set was baked for (Manifest::half_tolerance); of float
/// ones 1e-5, tau 1e-4, or where the numbers stored are far above the yardstick one unit in their
/// last place (of slope covariances four), 1/8 of it at most (1/2). Rank tables coarser than 64x64
/// texels have 2/512 more. Not compared: tau where the covariance is thin to within 0.1 % of the
/// limit or nothing but rounding; of texels without data all but the coverage; the table of a color
/// map.
///
/// progress  is told the share done, in [0, 1]; it may throw to stop
/// Throws Error where the set cannot be read, or is not of the original's size.
std::vector<StatisticsFigure> check_statistics(SetReader& set, const Original& original,
                                               const BakeOptions& options,
                                               const std::function<void(double)>& progress);

} // namespace scree
