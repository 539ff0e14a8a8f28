#pragma once

#include <array>
#include <vector>

#include "texset/manifest.h"

namespace scree {

/// What is needed to fit the exponent of the linear model of color by height to colors that were
/// measured: sums over texels and views, in bins of Smith's Lambda.
///
/// The model is c + mu(L) k, mu that of scree_visible_height, k = cov(c, hn) / sigma of R, G, B.
/// Where t is the true color less c, its squared error is t.t - 2 mu t.k + mu^2 k.k, so three sums
/// a bin tell the error of every exponent that is a function of Lambda. A sample is shared between
/// the two bins about its Lambda, sixteenths of an octave from 2^-16 to 2^20.
class ExponentBins {
public:
    explicit ExponentBins(int elevations);

    /// lambda  >= 0;  shift  k;  truth  t;  weight  >= 0
    void add(int elevation, double lambda, const std::array<double, 3>& shift,
             const std::array<double, 3>& truth, double weight);
    void add(const ExponentBins& other);

    /// Weighted sums of squared errors of R, G, B, an elevation each.
    [[nodiscard]] std::vector<double> squares(const ExponentFit& fit) const;
    /// The same without any shift.
    [[nodiscard]] double squares_of_mean(int elevation) const;
    [[nodiscard]] double weight(int elevation) const;
    [[nodiscard]] int elevations() const { return static_cast<int>(bins_.size()); }

private:
    struct Bin {
        double weight = 0, truth = 0, product = 0, shift = 0; ///< w, w t.t, w t.k, w k.k
    };
    std::vector<std::vector<Bin>> bins_; ///< [elevation][Lambda]
};

/// The numbers that leave the least error over all elevations together, and at none of them more
/// than the mean color does (but for 0.2 % of `color`).
///
/// Gain in [0, 8], power in [0.1, 3], threshold in [0, 0.3]; a gain of 0 is the mean color. A grid,
/// then steps along one number at a time that are halved.
///
/// color  rms of the map's mean color
ExponentFit fit_exponent(const ExponentBins& bins, double color);

} // namespace scree
