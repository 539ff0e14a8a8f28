#pragma once

#include <array>
#include <vector>

#include "figures/height_color_models.h"

namespace scree::test {

/// Sums of squares over lookups: of red, green, blue and luminance.
class Squares {
public:
    void add(const Color& a, const Color& b);
    void add(const Squares& other);
    double luminance_rms() const;
    double worst_rms() const; // of red, green and blue

private:
    std::array<double, 4> sum_{};
    double count_ = 0;
};

/// Of all models, over lookups and L.
struct Errors {
    Squares effect;              // truth against mean color
    std::vector<Squares> models; // model against truth

    void add(const Errors& other);
};

/// How a lookup reads the values.
enum Filter {
    kTrilinear,  // eight taps
    kHalf,       // eight taps of values rounded to half
    kUnfiltered, // one texel: what the model itself costs
    kFilters
};

constexpr size_t kLevels = 6; // lookups between levels 1, 2 .. 6 and the next

/// Errors by filter and level. At every level the same number of lookups, at random places.
using SurfaceErrors = std::array<std::array<Errors, kLevels>, kFilters>;

SurfaceErrors measure(const Surface& surface, const std::vector<Model>& models);

} // namespace scree::test
