// Rings around data, against the distance to the nearest texel with data by exhaustive search.
#include "pipeline/gutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace scree::test {
namespace {

struct Mask {
    int width, height;
    bool periodic_s, periodic_t;
    std::vector<bool> has_data;

    [[nodiscard]] size_t at(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

Mask random_mask(int width, int height, double share, unsigned seed)
{
    Mask mask{width, height, false, false, {}};
    std::mt19937 random(seed);
    std::bernoulli_distribution has_data(share);
    for (int i = 0; i < width * height; ++i)
        mask.has_data.push_back(has_data(random));
    return mask;
}

/// Steps to a neighbour, diagonals included, from (x, y) to the nearest texel with data.
int distance_to_data(const Mask& mask, int x, int y)
{
    auto along = [](int a, int b, int size, bool periodic) {
        const int straight = std::abs(a - b);
        return periodic ? std::min(straight, size - straight) : straight;
    };
    int nearest = 1000;
    for (int j = 0; j < mask.height; ++j)
        for (int i = 0; i < mask.width; ++i)
            if (mask.has_data[mask.at(i, j)])
                nearest = std::min(nearest, std::max(along(x, i, mask.width, mask.periodic_s),
                                                     along(y, j, mask.height, mask.periodic_t)));
    return nearest;
}

struct Grown {
    std::vector<Ring> rings;
    std::vector<uint8_t> sources;
};

/// Rings of a whole map at once.
Grown grow(const Mask& mask)
{
    Grown grown;
    for (const bool has_data : mask.has_data)
        grown.rings.push_back(has_data ? 0 : kBeyondGutter);
    grown.sources.resize(grown.rings.size());
    auto row = [&](int y) -> Ring* {
        if (mask.periodic_t)
            y = (y + mask.height) % mask.height;
        return y < 0 || y >= mask.height ? nullptr : &grown.rings[mask.at(0, y)];
    };
    for (Ring ring = 1; ring <= kGutterRings; ++ring)
        for (int y = 0; y < mask.height; ++y) {
            std::vector<GutterTexel> texels;
            grow_ring({row(y - 1), row(y), row(y + 1)}, mask.width, mask.periodic_s, ring, texels);
            for (const GutterTexel& texel : texels)
                grown.sources[mask.at(texel.x, y)] = texel.sources;
        }
    return grown;
}

/// The neighbours of (x, y) that are one step nearer to data.
uint8_t expected_sources(const Mask& mask, int x, int y, int distance)
{
    unsigned sources = 0;
    for (unsigned i = 0; i < kNeighbours.size(); ++i) {
        int column = x + kNeighbours[i].dx, row = y + kNeighbours[i].dy;
        if (mask.periodic_s)
            column = (column + mask.width) % mask.width;
        if (mask.periodic_t)
            row = (row + mask.height) % mask.height;
        if (column < 0 || column >= mask.width || row < 0 || row >= mask.height)
            continue;
        if (distance_to_data(mask, column, row) == distance - 1)
            sources |= 1U << i;
    }
    return static_cast<uint8_t>(sources);
}

TEST(Gutter, RingsAreDistancesToDataAndSourcesTheNeighboursOneStepNearer)
{
    const std::pair<int, int> sizes[] = {{1, 1}, {1, 6}, {6, 1},  {2, 2},  {3, 3},
                                         {4, 2}, {9, 7}, {17, 5}, {16, 16}};
    int in_gutter = 0, beyond = 0;
    unsigned seed = 1;
    for (const auto& [width, height] : sizes)
        for (const double share : {0.02, 0.1, 0.6})
            for (const int wraps : {0, 1, 2, 3}) {
                Mask mask = random_mask(width, height, share, seed++);
                mask.periodic_s = (wraps & 1) != 0;
                mask.periodic_t = (wraps & 2) != 0;
                const Grown grown = grow(mask);
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const int distance = distance_to_data(mask, x, y);
                        const bool is_in = distance >= 1 && distance <= kGutterRings;
                        ASSERT_EQ(grown.rings[mask.at(x, y)],
                                  distance <= kGutterRings ? distance : kBeyondGutter)
                            << width << "x" << height << " wraps " << wraps << " at " << x << ","
                            << y;
                        ASSERT_EQ(grown.sources[mask.at(x, y)],
                                  is_in ? expected_sources(mask, x, y, distance) : 0)
                            << width << "x" << height << " wraps " << wraps << " at " << x << ","
                            << y;
                        in_gutter += is_in ? 1 : 0;
                        beyond += distance > kGutterRings ? 1 : 0;
                    }
            }
    EXPECT_GT(in_gutter, 500);
    EXPECT_GT(beyond, 100);
}

} // namespace
} // namespace scree::test
