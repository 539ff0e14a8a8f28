#include "figures/brdf_errors.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <random>

namespace scree::test {

namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kPairs = 6000; ///< of a region

double green(const Rgbf& color) { return static_cast<double>(color[1]); }

constexpr double kLeastCosine = 0.05; // 87 degrees

Imath::V3d even(std::mt19937& engine, double least_cosine)
{
    const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    const double z = least_cosine + (1 - least_cosine) * uniform(), phi = 2 * kPi * uniform();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

} // namespace

std::vector<BrdfRegion> brdf_regions()
{
    std::mt19937 engine(11);
    std::vector<BrdfRegion> all = {{"all", {}}, {"specular", {}}, {"Fresnel", {}}, {"grazing", {}}};
    const auto full = [&](size_t region) { return all[region].pairs.size() >= kPairs; };
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

RegionValues true_values(const BrdfMaterial& material, const std::vector<BrdfRegion>& regions)
{
    RegionValues all;
    for (const BrdfRegion& region : regions) {
        auto& values = all.emplace_back(region.pairs.size());
        tbb::parallel_for(size_t{0}, values.size(), [&](size_t i) {
            values[i] = green(material.brdf(region.pairs[i])) * region.pairs[i].wi.z;
        });
    }
    return all;
}

std::vector<double> interpolation_errors(const BrdfMaterial& material, const BrdfGrid& grid,
                                         const std::vector<BrdfRegion>& regions,
                                         const RegionValues& truth)
{
    const auto table = brdf_table(grid, material.brdf, [](double) {});
    std::vector<double> errors;
    for (size_t r = 0; r < regions.size(); ++r) {
        double wrong = 0, all = 0;
        for (size_t i = 0; i < truth[r].size(); ++i) {
            const auto& w = regions[r].pairs[i];
            const double off = look_up(grid, table, 3, w)[1] * w.wi.z - truth[r][i];
            wrong += off * off;
            all += truth[r][i] * truth[r][i];
        }
        errors.push_back(std::sqrt(wrong / all));
    }
    return errors;
}

} // namespace scree::test
