#include "figures/brdf_materials.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "chart/asset.h"
#include "chart/temp_folder.h"
#include "pipeline/bake.h"
#include "reference/footprint.h"
#include "tables/effective_brdf.h"

namespace scree::test {

namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
constexpr int kTexelLevels = 2; ///< 4x4 texels: two levels above the last

Rgbf grey(double value)
{
    const auto v = static_cast<float>(value);
    return {v, v, v};
}

/// The half vector's azimuth 0, the back vector's in [0, pi/2]: takes what is left of the azimuth
/// of an averaged surface away.
Directions<double> reduced(const Directions<double>& w)
{
    const auto c = filter::isotropic_coordinates(w);
    return filter::directions(filter::HalfDifference<double>{c.theta_h, 0, c.theta_d, c.phi_d});
}

/// Torrance-Sparrow with Beckmann's slopes and Smith's masking, of the kernel, without Fresnel.
double lobe(const Directions<double>& w, double alpha)
{
    return filter::specular(w.wo, w.wi, filter::Slopes<double>{}, alpha) / std::max(w.wi.z, 0.02);
}

double schlick(const Directions<double>& w)
{
    const double cos_d = std::cos(filter::isotropic_coordinates(w).theta_d);
    return 0.04 + 0.96 * std::pow(1 - cos_d, 5);
}

/// Diffuse below, a smooth layer above.
Rgbf varnish(const Directions<double>& w)
{
    const double f = schlick(w);
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

BrdfMaterial baked(const Asset& asset)
{
    const TempFolder folder;
    BakeOptions options = asset.options;
    options.output = folder.path() / "set";
    options.maps = {Map::color, Map::slope, Map::height, Map::colorheight};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    bake(source, options, start);
    const int levels = reference::level_count(asset.relief.width, asset.relief.height);
    const auto brdf = std::make_shared<EffectiveBrdf>(options.output, levels - 1 - kTexelLevels,
                                                      EffectiveBrdfOptions{0.2F, 0.04F, 16});
    return {asset.name, [brdf](const Directions<double>& w) { return (*brdf)(reduced(w)); }};
}

} // namespace

std::vector<BrdfMaterial> brdf_materials(const std::string& data)
{
    std::vector<BrdfMaterial> all = {
        {"lobe, alpha 0.1", [](const auto& w) { return grey(lobe(w, 0.1)); }},
        {"lobe, alpha 0.3", [](const auto& w) { return grey(lobe(w, 0.3)); }},
        {"varnish (Fresnel)", varnish},
        {"velvet (grazing)", velvet},
        {"retro-reflector", retro}};
    all.push_back(baked(sample_asset("bricks", 256)));
    if (data.empty()) {
        all.push_back(baked(sample_asset("fractal", 256)));
        return all;
    }
    BakeOptions rock;
    rock.name = "rock_05";
    rock.height_file = data + "/heights/material/rock_05/rock_05_bump_1k.png";
    rock.color_file = data + "/heights/material/rock_05/rock_05_diff_1k.png";
    rock.height_scale = 0.0033048; // rms slope 0.6
    all.push_back(baked(asset_of(rock)));
    return all;
}

} // namespace scree::test
