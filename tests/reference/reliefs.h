#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "math/vec.h"
#include "reference/relief.h"

namespace scree::test {

constexpr double kPi = 3.14159265358979323846;

inline double radians(double degrees) { return degrees * kPi / 180; }

/// The unit vector at an angle from the normal, in an azimuth counted from +s towards +t.
inline Vec3 direction(double theta_degrees, double azimuth_degrees)
{
    const double theta = radians(theta_degrees), azimuth = radians(azimuth_degrees);
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth),
            std::cos(theta)};
}

/// Heights by a function of the texel's column and row.
template <class Height>
reference::Relief relief_of(int width, int height, const Height& height_at)
{
    reference::Relief relief;
    relief.width = width;
    relief.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            relief.heights.push_back(height_at(x, y));
    return relief;
}

/// Uniform numbers in [0, 1), the same on every machine.
class Uniform {
public:
    explicit Uniform(unsigned seed) : random_(seed) {}
    double operator()() { return static_cast<double>(random_()) * 0x1p-32; }

private:
    std::mt19937 random_;
};

/// White noise of heights in [0, 1), the same on every machine.
inline reference::Relief rough_relief(int width, int height, unsigned seed)
{
    Uniform uniform(seed);
    return relief_of(width, height, [&](int, int) { return uniform(); });
}

/// Takes data away, a tenth of it in each of the ways there are.
inline void punch_holes(reference::Relief& relief, unsigned seed)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Uniform uniform(seed);
    relief.weights.assign(relief.heights.size(), 1.0F);
    relief.colors.assign(relief.heights.size(), {0.25, 0.5, 1});
    for (size_t i = 0; i < relief.heights.size(); ++i) {
        const double way = uniform();
        if (way < 0.1)
            relief.heights[i] = nan;
        else if (way < 0.2)
            relief.weights[i] = 0;
        else if (way < 0.3)
            relief.colors[i][i % 3] = nan;
        else
            relief.weights[i] = static_cast<float>(0.25 + 0.75 * uniform());
    }
}

} // namespace scree::test
