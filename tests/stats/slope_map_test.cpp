#include "stats/slope_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace scree::test {
namespace {

struct Point {
    double s, t;
};

/// Mean, covariance and tails of points of equal weight, in the order of the planes.
std::array<double, 14> moments_of(const std::vector<Point>& points)
{
    Point mean{0, 0};
    const double n = static_cast<double>(points.size());
    for (const Point& p : points) {
        mean.s += p.s / n;
        mean.t += p.t / n;
    }
    std::array<double, 14> out{mean.s, mean.t};
    constexpr std::array<std::pair<int, int>, 12> kPowers = {{{2, 0},
                                                              {0, 2},
                                                              {1, 1},
                                                              {3, 0},
                                                              {2, 1},
                                                              {1, 2},
                                                              {0, 3},
                                                              {4, 0},
                                                              {3, 1},
                                                              {2, 2},
                                                              {1, 3},
                                                              {0, 4}}};
    for (const Point& p : points)
        for (size_t i = 0; i < kPowers.size(); ++i)
            out[2 + i] += std::pow(p.s - mean.s, kPowers[i].first) *
                          std::pow(p.t - mean.t, kPowers[i].second) / n;
    return out;
}

TEST(SlopeMap, MomentsAreThoseOfMappedSlopes)
{
    const MomentLayout layout(MomentSet{true, true});
    std::array<int, 14> planes{layout.slope_s, layout.slope_t, layout.slope_ss, layout.slope_tt,
                               layout.slope_st};
    for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
        planes[static_cast<size_t>(5 + i)] = layout.slope_tail + i;
    std::mt19937 engine(7);
    std::normal_distribution<double> law;
    constexpr int kTexels = 20;
    std::vector<double> data(static_cast<size_t>(layout.planes * kTexels));
    const MomentRow row{data.data(), kTexels};
    std::vector<SlopeMap> maps;
    std::vector<std::array<double, 14>> want;
    for (int x = 0; x < kTexels; ++x) {
        const SlopeMap map{static_cast<float>(law(engine)), static_cast<float>(law(engine)),
                           static_cast<float>(law(engine))};
        maps.push_back(map);
        std::vector<Point> points, mapped;
        for (int i = 0; i < 30; ++i) {
            const Point p{law(engine), std::pow(law(engine), 3)};
            points.push_back(p);
            mapped.push_back({static_cast<double>(map.a) * p.s,
                              static_cast<double>(map.b) * p.s + static_cast<double>(map.c) * p.t});
        }
        const auto before = moments_of(points);
        for (size_t i = 0; i < planes.size(); ++i)
            row.plane(planes[i])[x] = before[i];
        want.push_back(moments_of(mapped));
    }
    map_slopes(layout, maps.data(), kTexels, row);
    for (int x = 0; x < kTexels; ++x)
        for (size_t i = 0; i < planes.size(); ++i) {
            const double value = want[static_cast<size_t>(x)][i];
            EXPECT_NEAR(row.plane(planes[i])[x], value, 1e-10 * (1 + std::abs(value)))
                << x << ' ' << i;
        }
}

} // namespace
} // namespace scree::test
