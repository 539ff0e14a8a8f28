#pragma once

#include <functional>
#include <string>

#include "support/files.h"
#include "support/memory_source.h"

namespace scree::test {

/// Index of texel (x, y) in the grids of a map; beyond an edge the map repeats.
size_t index_of(const MemorySource& map, int x, int y);

/// Heights by texel, world units.
MemorySource heights_of(int width, int height, const std::function<double(int x, int y)>& h);

/// Slopes by texel, as of a normal map.
MemorySource slope_map_of(int width, int height,
                          const std::function<std::array<double, 2>(int x, int y)>& slope);

/// A V-groove along t: slopes -0.5 and +0.5 times `steepness` / 0.5, 16 texels a groove, its ridges
/// and its bottoms on texel centres, so that the bilinear surface has them exactly.
MemorySource v_groove(int width, int height, double steepness);

/// Columns for rows.
MemorySource transposed(const MemorySource& surface);

/// White noise, uniform in [0, 1): variance 1/12.
MemorySource white_noise(int width, int height, unsigned seed);

/// Waves in all directions, periodic: Gaussian heights of deviation 1.
///
/// size               texels along a side
/// shortest, longest  wavelengths, texels
MemorySource gaussian_waves(int size, double shortest, double longest, unsigned seed);

/// A built-in sample, square, with its colors.
MemorySource sample(const std::string& kind, int size);

/// Mean slope along s of a texel of a map that repeats: central differences, the rows above and
/// below with an eighth each (docs/statistics.md, the mean over the quarters).
double slope_of_texel(const MemorySource& surface, int x, int y);

/// The heights with a color of each texel: red, no green, no blue.
MemorySource painted(MemorySource surface,
                     const std::function<double(int x, int y, double h)>& red);

/// One channel Y.
Image height_image(const MemorySource& surface);
/// R G B, unit normals (-s, -t, 1) / length, in [-1, 1].
Image normal_image(const MemorySource& surface);

/// Mean red of the texels.
double mean_red(const MemorySource& map);

/// Mean of a function of the slopes of a normal map.
double mean_of_slopes(const MemorySource& surface,
                      const std::function<double(double s, double t)>& of);

/// Variance of its slopes along s.
double variance_of_slopes(const MemorySource& surface);

} // namespace scree::test
