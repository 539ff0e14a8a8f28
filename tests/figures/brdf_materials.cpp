#include "figures/brdf_materials.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "chart/asset.h"
#include "chart/temp_folder.h"
#include "pipeline/bake.h"
#include "reference/footprint.h"
#include "tables/effective_brdf.h"
#include "tables/schlick.h"
#include "tables/traced_brdf.h"

namespace scree::test {

namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
constexpr double kBaseAlpha = 0.2, kF0 = 0.04;

Rgbf grey(double value)
{
    const auto v = static_cast<float>(value);
    return {v, v, v};
}

/// Torrance-Sparrow with Beckmann's slopes and Smith's masking, of the kernel, without Fresnel.
double lobe(const Directions<double>& w, double alpha)
{
    return filter::specular(w.wo, w.wi, filter::Slopes<double>{}, alpha) / std::max(w.wi.z, 0.02);
}

/// Diffuse below, a smooth layer above.
Rgbf varnish(const Directions<double>& w)
{
    const double f = schlick(kF0, std::cos(filter::isotropic_coordinates(w).theta_d));
    return grey((1 - f) * 0.3 / kPi + f * lobe(w, 0.25));
}

/// Fibres: more half vectors far from the normal. After Ashikhmin et al. 2000, and its denominator
/// that stays finite at the horizon after Neubelt and Pettineo 2013.
Rgbf velvet(const Directions<double>& w)
{
    const double theta_h = filter::isotropic_coordinates(w).theta_h;
    const double cot = std::cos(theta_h) / std::max(std::sin(theta_h), 1e-9);
    const double density = (1 + 4 * std::exp(-cot * cot / 0.25)) / (kPi * (1 + 4 * 0.25));
    return grey(density / (4 * (w.wo.z + w.wi.z - w.wo.z * w.wi.z + 0.02)));
}

Rgbf retro(const Directions<double>& w)
{
    return grey((0.1 + std::pow(std::max(w.wo.dot(w.wi), 0.0), 20)) / kPi);
}

void bake_into(const std::filesystem::path& set, const Asset& asset)
{
    BakeOptions options = asset.options;
    options.output = set;
    options.maps = {Map::color, Map::slope, Map::height, Map::colorheight};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    bake(source, options, start);
}

BrdfSurface surface_of(Asset asset)
{
    const auto folder = std::make_shared<TempFolder>();
    const auto set = folder->path() / "set";
    bake_into(set, asset);
    const int last = reference::level_count(asset.relief.width, asset.relief.height) - 1;
    const auto surface = std::make_shared<reference::DisplacedSurface>(std::move(asset.relief));
    const auto baked = [folder, set, last](int side) {
        const int level = last - static_cast<int>(std::lround(std::log2(side)));
        // Texels are turned by themselves; a few take more turns.
        const EffectiveBrdfOptions options{static_cast<float>(kBaseAlpha), static_cast<float>(kF0),
                                           std::max(64 / side, 1)};
        const auto brdf = std::make_shared<EffectiveBrdf>(set, level, options);
        return [brdf](const Directions<double>& w) { return (*brdf)(w); };
    };
    const auto traced = [surface](int grid, uint64_t seed) {
        const auto brdf =
            std::make_shared<TracedBrdf>(*surface, TracedBrdfOptions{kBaseAlpha, kF0, grid, seed});
        return [surface, brdf](const Directions<double>& w) { return (*brdf)(w); };
    };
    return {asset.name, surface, baked, traced};
}

} // namespace

std::vector<BrdfMaterial> brdf_formulas()
{
    return {{"lobe, alpha 0.1", [](const auto& w) { return grey(lobe(w, 0.1)); }},
            {"lobe, alpha 0.3", [](const auto& w) { return grey(lobe(w, 0.3)); }},
            {"varnish (Fresnel)", varnish},
            {"velvet (grazing)", velvet},
            {"retro-reflector", retro}};
}

std::vector<BrdfSurface> brdf_surfaces(const std::string& data)
{
    std::vector<BrdfSurface> all;
    all.push_back(surface_of(sample_asset("bricks", 256)));
    if (data.empty()) {
        all.push_back(surface_of(sample_asset("fractal", 256)));
        return all;
    }
    BakeOptions rock;
    rock.name = "rock_05";
    rock.height_file = data + "/heights/material/rock_05/rock_05_bump_1k.png";
    rock.color_file = data + "/heights/material/rock_05/rock_05_diff_1k.png";
    rock.height_scale = 0.0033048; // rms slope 0.6
    all.push_back(surface_of(asset_of(rock)));
    return all;
}

} // namespace scree::test
