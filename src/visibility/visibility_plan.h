#pragma once

#include <vector>

namespace scree {

constexpr int kMaxNodes = 6;
constexpr int kMaxHarmonics = 2;
constexpr int kMaxAzimuths = 64;

/// What a table of visibility holds of every texel: numbers at some angles from the normal (its
/// nodes), that tell what is seen from any azimuth, in one of two ways:
///   harmonics  of a node the mean over the azimuth, and terms of a Fourier series in it
///   axes       of a node what is the same from all sides, and what goes with the view along two
///              axes across each other, on either side (AxesFit): for walls, bricks and grooves
struct VisibilityPlan {
    std::vector<double> node_angles_deg; ///< rising, in (0, 90); 1 to kMaxNodes; none: no table
    int harmonics = 0;                   ///< 0 to kMaxHarmonics
    int azimuths = 8;                    ///< swept, equally spaced; more than 2 harmonics
    bool axes = false;                   ///< instead of harmonics; 5 azimuths at least
    double axis_deg = 0;                 ///< of the first axis, from +s towards +t

    /// Of a node. Harmonics: the mean, then cos phi, cos 2 phi, sin phi, sin 2 phi as far as there
    /// are any. Axes: from all sides, then against and along the first axis, and the second.
    [[nodiscard]] int terms() const { return axes ? 5 : 1 + 2 * harmonics; }
    /// As of ViewComponents.
    [[nodiscard]] int components() const
    {
        return static_cast<int>(node_angles_deg.size()) * terms();
    }
};

/// The angles that served best for a number of nodes, 1 to kMaxNodes, on steep surfaces; figures in
/// docs/visibility.md.
std::vector<double> best_node_angles(int nodes);

/// The same for any surface: flatter ones hide nothing before views are the more grazing.
///
/// The first goes to where a view is as steep as the surface, tan theta = 1 / steepness, never
/// back, and at most to half the tangent of the last, which stays; those between keep their places
/// between the two, in log tan theta. A single angle stays. Figures in docs/visibility.md. Eighths
/// of a degree.
///
/// steepness  of SlopeSurvey, >= 0
std::vector<double> moved_node_angles(std::vector<double> angles_deg, double steepness);

/// Azimuth number j of a plan, degrees: (j + 1/4) 360 / azimuths. For 8 none of them lies along an
/// axis of the map or a diagonal, where a line passes all texels at the same place.
inline double swept_azimuth_deg(const VisibilityPlan& plan, int j)
{
    return (j + 0.25) * 360 / plan.azimuths;
}

} // namespace scree
