#pragma once

#include <array>

#include "reference/gather.h"

namespace scree::reference {

/// A weighted mean of slopes and the sums of squares about it.
class SlopeSums {
public:
    void add(double weight, const Vec2& slope);
    void add(const SlopeSums& other);

    [[nodiscard]] Vec2 mean() const { return mean_; }
    [[nodiscard]] std::array<double, 3> covariance() const; ///< ss, st, tt

private:
    void add(double weight, const Vec2& mean, const std::array<double, 3>& about);

    double weight_ = 0;
    Vec2 mean_{0, 0};
    std::array<double, 3> about_{}; ///< weight times squares about the mean
};

/// What Seen is made of: sums over samples, by weight of their texels.
struct SeenSums {
    double facing = 0, area = 0;
    Rgb color{};
    SlopeSums slopes;

    void add(const SeenSums& other);
    [[nodiscard]] Seen mean(double weight) const;
};

/// What Lit is made of.
struct LitSums {
    double open = 0;
    Rgb color{}, diffuse{};
    double white = 0, specular = 0;

    void add(const LitSums& other);

    /// area  the sum of what its view sees
    [[nodiscard]] Lit mean(double area) const;
};

/// The sums of all views and lights.
struct GatherSums {
    GatherSums(size_t views, size_t lights) : seen(views), lit(views * lights) {}

    double weight = 0;
    std::vector<SeenSums> seen;
    std::vector<LitSums> lit; ///< views x lights

    void add(const GatherSums& other);
    [[nodiscard]] Gathered mean() const;
};

} // namespace scree::reference
