#include "tables/brdf_grid.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double kQuarter = 1.57079632679489661923;

/// Range of an axis: angles of half/difference, lengths of the others.
double range(BrdfParametrization parametrization)
{
    return parametrization == BrdfParametrization::half_difference ? kQuarter : 1;
}

double reach(BrdfParametrization parametrization, double first, double azimuth)
{
    switch (parametrization) {
    case BrdfParametrization::half_difference:
        return kernel::scree_half_difference_reach(first, azimuth);
    case BrdfParametrization::orthographic:
        return kernel::scree_orthographic_reach(first, azimuth);
    case BrdfParametrization::hybrid:
        break;
    }
    return kernel::scree_hybrid_reach(first, azimuth);
}

double share(int i, int count) { return static_cast<double>(i) / (count - 1); }

/// Whether nodes lie at sines of angles.
bool has_sines(const BrdfGrid& grid)
{
    return grid.spacing == BrdfSpacing::angle &&
           grid.parametrization != BrdfParametrization::half_difference;
}

/// Axis to share of its range, and back.
double of_range(const BrdfGrid& grid, double even)
{
    return has_sines(grid) ? std::sin(kQuarter * even) : even;
}
double even_of(const BrdfGrid& grid, double of_range)
{
    const double share = std::min(of_range, 1.0);
    return has_sines(grid) ? std::asin(share) / kQuarter : share;
}

double first_of(const BrdfGrid& grid, int i)
{
    const double even = share(i, grid.size[0]);
    const double placed = grid.spacing == BrdfSpacing::even ? even : even * even;
    return range(grid.parametrization) * of_range(grid, placed);
}

std::array<double, 3> isotropic(const BrdfGrid& grid, const filter::Directions<double>& w)
{
    const auto c = filter::isotropic_coordinates(w);
    switch (grid.parametrization) {
    case BrdfParametrization::half_difference:
        return {c.theta_h, c.theta_d, c.phi_d};
    case BrdfParametrization::orthographic:
        return {c.h_bar, c.k_bar, c.azimuth};
    case BrdfParametrization::hybrid:
        break;
    }
    return {c.h_bar, c.k, c.azimuth};
}

} // namespace

size_t BrdfGrid::nodes() const
{
    size_t count = 1;
    for (const int n : size)
        count *= static_cast<size_t>(n);
    return count;
}

filter::Directions<double> BrdfGrid::directions(int first, int second, int azimuth) const
{
    const double a = first_of(*this, first), phi = kQuarter * share(azimuth, size[2]);
    const double end = reach(parametrization, a, phi);
    const double part = of_range(*this, share(second, size[1]));
    const double b = fitted ? part * end : std::min(part * range(parametrization), end);
    switch (parametrization) {
    case BrdfParametrization::half_difference:
        return filter::directions(filter::HalfDifference<double>{a, 0, b, phi});
    case BrdfParametrization::orthographic:
        return filter::directions(filter::Orthographic<double>{a, 0, b, phi});
    case BrdfParametrization::hybrid:
        break;
    }
    return filter::directions(filter::Hybrid<double>{a, 0, b, phi});
}

std::array<double, 3> BrdfGrid::place(const filter::Directions<double>& w) const
{
    const auto [a, b, phi] = isotropic(*this, w);
    const double most = range(parametrization);
    const double along = even_of(*this, a / most);
    // At the far end of h nothing is left of k: any share is right.
    const double end = fitted ? std::max(reach(parametrization, a, phi), 1e-12) : most;
    return {(spacing == BrdfSpacing::even ? along : std::sqrt(along)) * (size[0] - 1),
            even_of(*this, b / end) * (size[1] - 1), std::min(phi / kQuarter, 1.0) * (size[2] - 1)};
}

std::vector<TableAxis> BrdfGrid::axes() const
{
    const bool angles = parametrization == BrdfParametrization::half_difference;
    const bool flat = parametrization == BrdfParametrization::orthographic;
    std::vector<TableAxis> all = {{angles ? "theta_h" : "|h_bar|",
                                   angles ? "radians" : "1",
                                   angles ? "angle between half vector and normal"
                                          : "length of (wi + wo) / 2 in the surface's plane",
                                   {}},
                                  {angles ? "theta_d" : (flat ? "|k_bar|" : "|k|"),
                                   angles ? "radians" : "1",
                                   angles ? "angle between wi and the half vector"
                                          : (flat ? "length of (wi - wo) / 2 in the surface's plane"
                                                  : "length of (wi - wo) / 2"),
                                   {}},
                                  {angles ? "phi_d" : "azimuth",
                                   "radians",
                                   angles
                                       ? "azimuth of wi about the half vector, folded to [0, pi/2]"
                                       : "azimuth of k from that of h, folded to [0, pi/2]",
                                   {}}};
    if (fitted) {
        all[1].name += " / reach";
        all[1].unit = "1";
        all[1].meaning += ", per the largest one that two directions above the surface have";
    }
    for (int i = 0; i < size[0]; ++i)
        all[0].coordinates.push_back(first_of(*this, i));
    for (int i = 0; i < size[1]; ++i)
        all[1].coordinates.push_back(of_range(*this, share(i, size[1])) *
                                     (fitted ? 1 : range(parametrization)));
    for (int i = 0; i < size[2]; ++i)
        all[2].coordinates.push_back(share(i, size[2]) * kQuarter);
    return all;
}

std::string name_of(BrdfParametrization parametrization)
{
    switch (parametrization) {
    case BrdfParametrization::half_difference:
        return "half-difference";
    case BrdfParametrization::orthographic:
        return "orthographic";
    case BrdfParametrization::hybrid:
        break;
    }
    return "hybrid";
}

std::vector<double> look_up(const BrdfGrid& grid, const std::vector<float>& values, int channels,
                            const filter::Directions<double>& w)
{
    const std::array<double, 3> at = grid.place(w);
    std::array<int, 3> low{};
    std::array<double, 3> part{};
    for (size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(static_cast<int>(at[axis]), grid.size[axis] - 2);
        part[axis] = at[axis] - low[axis];
    }
    std::vector<double> sum(static_cast<size_t>(channels));
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        size_t node = 0;
        for (size_t axis = 3; axis-- > 0;) {
            const int step = (corner >> axis) & 1;
            weight *= step == 1 ? part[axis] : 1 - part[axis];
            node =
                node * static_cast<size_t>(grid.size[axis]) + static_cast<size_t>(low[axis] + step);
        }
        for (size_t c = 0; c < sum.size(); ++c)
            sum[c] += weight * static_cast<double>(values[node * sum.size() + c]);
    }
    return sum;
}

} // namespace scree
