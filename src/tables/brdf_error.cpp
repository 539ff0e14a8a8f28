#include "tables/brdf_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree {

namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
constexpr double kLeastCosine = 0.05; // 87 degrees

Imath::V3d even(std::mt19937& engine, double least_cosine)
{
    const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    const double z = least_cosine + (1 - least_cosine) * uniform(), phi = 2 * kPi * uniform();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// The pair that an isotropic and reciprocal BRDF without mirror images takes for this one: the
/// half vector's azimuth 0, the back vector's in [0, pi/2].
Directions<double> reduced(const Directions<double>& w)
{
    const auto c = filter::isotropic_coordinates(w);
    return filter::directions(filter::HalfDifference<double>{c.theta_h, 0, c.theta_d, c.phi_d});
}

Rgbf scaled(const Rgbf& color, double factor)
{
    const auto f = static_cast<float>(factor);
    return {color[0] * f, color[1] * f, color[2] * f};
}

} // namespace

std::vector<BrdfRegion> brdf_regions(size_t pairs)
{
    std::mt19937 engine(11);
    std::vector<BrdfRegion> all = {{"all", {}}, {"specular", {}}, {"Fresnel", {}}, {"grazing", {}}};
    const auto full = [&](size_t region) { return all[region].pairs.size() >= pairs; };
    const auto add = [&](size_t region, const Directions<double>& w) {
        if (!full(region))
            all[region].pairs.push_back(w);
    };
    while (!full(0) || !full(2) || !full(3)) {
        const Directions<double> w{even(engine, kLeastCosine), even(engine, kLeastCosine)};
        add(0, w);
        if (filter::isotropic_coordinates(w).theta_d > kPi / 3)
            add(2, w);
        if (std::min(w.wo.z, w.wi.z) < std::cos(75 * kPi / 180))
            add(3, w);
    }
    while (!full(1)) {
        const Imath::V3d h = even(engine, std::cos(20 * kPi / 180));
        const Imath::V3d wo = even(engine, kLeastCosine);
        const Imath::V3d wi = h * (2 * h.dot(wo)) - wo;
        if (wi.z > kLeastCosine)
            add(1, {wo, wi});
    }
    return all;
}

RegionValues region_values(const BrdfFunction& brdf, const std::vector<BrdfRegion>& regions,
                           const std::function<void(double)>& progress)
{
    constexpr size_t kBlock = 64;
    RegionValues all;
    for (const BrdfRegion& region : regions) {
        auto& values = all.emplace_back(region.pairs.size());
        for (size_t first = 0; first < values.size(); first += kBlock) {
            tbb::parallel_for(first, std::min(first + kBlock, values.size()), [&](size_t i) {
                values[i] = scaled(brdf(reduced(region.pairs[i])), region.pairs[i].wi.z);
            });
            const double share = static_cast<double>(first) / static_cast<double>(values.size());
            progress((static_cast<double>(all.size() - 1) + share) /
                     static_cast<double>(regions.size()));
        }
    }
    progress(1);
    return all;
}

RegionValues region_values(const BrdfGrid& grid, const std::vector<float>& table,
                           const std::vector<BrdfRegion>& regions)
{
    RegionValues all;
    for (const BrdfRegion& region : regions) {
        auto& values = all.emplace_back();
        values.reserve(region.pairs.size());
        for (const auto& w : region.pairs) {
            const auto found = look_up(grid, table, 3, w);
            values.push_back(scaled({static_cast<float>(found[0]), static_cast<float>(found[1]),
                                     static_cast<float>(found[2])},
                                    w.wi.z));
        }
    }
    return all;
}

std::vector<double> relative_errors(const RegionValues& got, const RegionValues& truth)
{
    std::vector<double> errors;
    for (size_t r = 0; r < truth.size(); ++r) {
        double wrong = 0, all = 0;
        for (size_t i = 0; i < truth[r].size(); ++i)
            for (size_t c = 0; c < 3; ++c) {
                const auto value = static_cast<double>(truth[r][i][c]);
                wrong += std::pow(static_cast<double>(got[r][i][c]) - value, 2);
                all += value * value;
            }
        errors.push_back(all > 0 ? std::sqrt(wrong / all) : 0);
    }
    return errors;
}

} // namespace scree
