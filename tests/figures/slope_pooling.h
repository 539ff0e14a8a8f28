#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/slope_measure.h"

namespace scree::test {

/// A surface at a slope.
struct SurfaceSlopeFigures {
    std::string surface;
    double slope = 0;                    ///< rms length
    std::vector<SlopeSizeFigures> sizes; ///< of see_slopes()
};
using SurfacesSlopeFigures = std::vector<SurfaceSlopeFigures>;

/// Indices into SlopeViews::angles_deg.
using Angles = std::vector<size_t>;
const Angles kNodeAngles = {0, 1, 2, 3}, kAnglesBetween = {4, 5};

/// Indices into SurfaceSlopeFigures::sizes.
constexpr size_t kSize16 = 0, kSize64 = 1, kSizeMap = 2;

/// Rms over angles, all alike.
double rms(const ScoresOfAngles& scores, const Angles& angles);

/// The error of a way, none where that was not measured.
std::optional<double> error_of(const SlopeSizeFigures& size, const std::string& way, Figure figure,
                               const Angles& angles);

/// Over surfaces and slopes: rms and largest.
class Pooled {
public:
    void add(double error);
    [[nodiscard]] double rms() const;
    [[nodiscard]] std::string text() const; ///< "rms / largest", %; empty where none was added

private:
    double squares_ = 0, largest_ = 0;
    int count_ = 0;
};

/// What is pooled.
struct Column {
    std::string name;
    size_t size = 0;
    Figure figure = Figure::mean;
    Angles angles;
};

Pooled pooled(const SurfacesSlopeFigures& all, const std::string& way, const Column& column);

} // namespace scree::test
