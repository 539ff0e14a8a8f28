#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/reliefs.h"
#include "visibility/memory_heights.h"
#include "visibility/sweep.h"

namespace scree::test {

/// Where lines lie at place 0, beyond a texel's centre: (1 - u)^2 + u^2 = 2/3 there.
inline const double kLineOffset = (1 - 1 / std::sqrt(3.0)) / 2;

inline double cotangent(double theta_degrees) { return 1 / std::tan(radians(theta_degrees)); }

/// A periodic map with texels of size 1.
inline HeightGrid::Shape shape_of(int width, int height, Edge edge_s = Edge::periodic,
                                  Edge edge_t = Edge::periodic)
{
    HeightGrid::Shape shape;
    shape.width = width;
    shape.height = height;
    shape.edge_s = edge_s;
    shape.edge_t = edge_t;
    return shape;
}

/// Heights by a function of the texel's column and row.
template <class Height>
MemoryHeights heights_of(const HeightGrid::Shape& shape, const Height& height_at)
{
    std::vector<float> heights;
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            heights.push_back(static_cast<float>(height_at(x, y)));
    return {shape, heights};
}

/// White noise of heights in [0, range).
inline MemoryHeights rough_heights(const HeightGrid::Shape& shape, double range, unsigned seed)
{
    Uniform uniform(seed);
    return heights_of(shape, [&](int, int) { return range * uniform(); });
}

inline TexelBlock whole_block(const HeightGrid& grid)
{
    return {0, 0, grid.shape().width, grid.shape().height};
}

/// What is seen of a block, an elevation: row by row.
inline std::vector<std::vector<float>> swept(const HeightGrid& grid, const TexelBlock& block,
                                             double azimuth_degrees,
                                             const std::vector<double>& thetas_degrees,
                                             const SweepOptions& options = {})
{
    const auto texels = static_cast<size_t>(block.width) * static_cast<size_t>(block.height);
    std::vector<std::vector<float>> visible(thetas_degrees.size(), std::vector<float>(texels, -1));
    std::vector<double> cotangents;
    std::vector<float*> rows;
    for (size_t k = 0; k < thetas_degrees.size(); ++k) {
        cotangents.push_back(cotangent(thetas_degrees[k]));
        rows.push_back(visible[k].data());
    }
    sweep(grid, block, radians(azimuth_degrees), cotangents, rows.data(), options);
    return visible;
}

/// Azimuths all around, degrees.
inline std::vector<double> around(int count)
{
    std::vector<double> azimuths(static_cast<size_t>(count));
    for (size_t i = 0; i < azimuths.size(); ++i)
        azimuths[i] = 360.0 / count * static_cast<double>(i);
    return azimuths;
}

/// Of a texel in rows of `width`.
inline size_t index_of(int x, int y, int width)
{
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
}

inline double mean_of(const std::vector<float>& values)
{
    double sum = 0;
    for (const float v : values)
        sum += static_cast<double>(v);
    return sum / static_cast<double>(values.size());
}

} // namespace scree::test
