#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures/slope_gain.h"
#include "figures/slope_truth.h"

namespace scree::test {

/// What is measured of a way to tell visible slopes.
enum class Figure {
    mean,       ///< of the slopes, relative to the map's rms slope
    covariance, ///< of the slopes, relative to the rms trace of those that were baked
    /// Radiance against the same shading with the true mean and covariance, so what their error
    /// does; then against the reference's. Relative to its rms.
    diffuse_by_moments,
    diffuse,
    specular_by_moments, ///< of kBaseAlphas[0]
    specular,
    smooth_by_moments, ///< of kBaseAlphas[1]
    smooth,
    color, ///< gray, relative to the mean
    count
};
constexpr size_t kFigures = static_cast<size_t>(Figure::count);

/// Of each of kBaseAlphas.
constexpr std::array<Figure, 2> kSpecular = {Figure::specular, Figure::smooth};
constexpr std::array<Figure, 2> kSpecularByMoments = {Figure::specular_by_moments,
                                                      Figure::smooth_by_moments};

/// Squares of errors and of what they are relative to.
struct Score {
    double error = 0, truth = 0;

    void add(double weight, double of_error, double of_truth)
    {
        error += weight * of_error * of_error;
        truth += weight * of_truth * of_truth;
    }
    [[nodiscard]] bool measured() const { return truth > 0; }
    [[nodiscard]] double square() const { return error / truth; }
};

/// Scores by SlopeViews::angles_deg.
using ScoresOfAngles = std::array<Score, 6>;

/// A way to tell visible slopes, or to shade without them.
struct WayFigures {
    std::string name;
    std::array<ScoresOfAngles, kFigures> figures;

    [[nodiscard]] const ScoresOfAngles& operator[](Figure figure) const
    {
        return figures[static_cast<size_t>(figure)];
    }
    ScoresOfAngles& operator[](Figure figure) { return figures[static_cast<size_t>(figure)]; }
};

struct SlopeSizeFigures {
    std::string footprint;
    SlopeGain gain;
    double tau = 0; ///< mean
    std::vector<WayFigures> ways;
};

/// Footprints, azimuths and lights count by the area that is seen.
///
/// rms_slope  of the map
SlopeSizeFigures measure_slopes(const SlopesOfSize& size, const SlopeViews& views,
                                double rms_slope);

} // namespace scree::test
