#pragma once

#include <array>
#include <vector>

namespace scree {

/// How large |height x curvature| gets over a surface (surface/metric.h, displacement_error()).
class Displacements {
public:
    Displacements();

    void clear();
    /// area  that it stands for
    void add(float displacement, float area, int x, int y);

    [[nodiscard]] double largest() const { return static_cast<double>(largest_); }
    [[nodiscard]] std::array<int, 2> place_of_largest() const { return place_; } ///< column, row

    /// What a share of the area, (0, 1], stays below: rounded up, by 1/16 of itself at most.
    [[nodiscard]] double quantile(double share) const;

private:
    std::vector<double> areas_; ///< by exponent and leading bits of the number
    float largest_ = 0;
    std::array<int, 2> place_{0, 0};
};

} // namespace scree
