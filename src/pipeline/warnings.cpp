#include "pipeline/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree {

namespace {

constexpr double kSteepest = 2, kFlattest = 1e-4;
constexpr double kWideMap = 100, kLeastSeen = 1e-3;

/// E[(dh/ds)^2] over Var(h) / dx^2 for white-noise heights.
double slope_gain(const std::string& reconstruction)
{
    if (reconstruction == "central")
        return 1.0 / 2;
    return reconstruction == "sobel" ? 3.0 / 16 : 4.0 / 3;
}

void add(std::vector<std::string>& warnings, const Rejects::Count& count, const char* what)
{
    if (count.texels > 0)
        warnings.push_back(fmt::format("{} texels {} count as no data; the first: {}", count.texels,
                                       what, count.first));
}

} // namespace

void warn(Manifest& manifest, std::vector<std::string> warnings)
{
    for (std::string& warning : warnings)
        manifest.warnings.push_back(std::move(warning));
}

std::vector<std::string> rejects_warnings(const Rejects& rejects, const BakeOptions& options)
{
    std::vector<std::string> warnings;
    if (options.no_data_height && rejects.marked.texels == 0)
        warnings.push_back(
            fmt::format("--no-data {:g}: no texel has this value; it is that of the "
                        "file, of integers the share of their range, [0, 1] or signed "
                        "[-1, 1]",
                        *options.no_data_height));
    add(warnings, rejects.not_finite, "that are not finite");
    add(warnings, rejects.turned_away, "whose normal does not face outward (nz <= 0)");
    add(warnings, rejects.marked, "marked by --no-data");
    return warnings;
}

std::vector<std::string> scale_warnings(const Manifest& manifest, const LevelSummary& coarsest,
                                        const BakeOptions& options)
{
    std::vector<std::string> warnings;
    if (!manifest.has_height || !coarsest.rms_slope)
        return warnings;
    const bool is_plane = !manifest.mesh;
    const bool size_given = options.texel_size || options.world_size;
    const char* remedy = !is_plane ? "check --height-scale: heights are in the mesh's units"
                         : size_given
                             ? "check --height-scale and the size given"
                             : "the map was taken to be one unit wide: set --texel-size or "
                               "--world-size, and --height-scale";
    if (*coarsest.rms_slope > kSteepest)
        warnings.push_back(fmt::format("rms slope {:.3g} is steeper than any material ({} at "
                                       "most); {}",
                                       *coarsest.rms_slope, kSteepest, remedy));
    else if (*coarsest.rms_slope < kFlattest)
        warnings.push_back(fmt::format("rms slope {:.3g} is flatter than any material ({} at "
                                       "least); {}",
                                       *coarsest.rms_slope, kFlattest, remedy));

    if (is_plane && manifest.integer_bits > 0 && manifest.integer_bits <= 8 &&
        *coarsest.slope_sigma > 0) {
        const double noise = manifest.quantum * manifest.quantum / 12;
        const double explained = slope_gain(manifest.reconstruction) * noise *
                                 (1 / (manifest.texel_width * manifest.texel_width) +
                                  1 / (manifest.texel_height * manifest.texel_height));
        const double share =
            std::min(1.0, explained / (*coarsest.slope_sigma * *coarsest.slope_sigma));
        warnings.push_back(fmt::format("{}-bit heights: quantisation alone explains {:.3g} % of "
                                       "the slope variance; use 16 bits or float if it matters",
                                       manifest.integer_bits, 100 * share));
    }
    return warnings;
}

std::vector<std::string> color_map_warnings(const Manifest& manifest, const LevelSummary& coarsest)
{
    if (!manifest.color_map)
        return {};
    const ColorMapRecord& map = *manifest.color_map;
    const double width = map.last - map.first;
    if (map.by != "height") {
        const auto rms = coarsest.rms_slope;
        if (!rms || *rms <= 0 || width < kWideMap * *rms)
            return {};
        return {fmt::format("the color map goes from slope {:g} to {:g}, the rms slope is {:.3g}: "
                            "hardly more than one color of it shows; give --map-range",
                            map.first, map.last, *rms)};
    }
    const double seen =
        std::min(map.last, manifest.height_max) - std::max(map.first, manifest.height_min);
    if (seen >= 0 && seen >= kLeastSeen * width)
        return {};
    return {
        fmt::format("the color map goes from {:g} to {:g}, the heights from {:g} to {:g}: hardly "
                    "more than one color of it shows; give --map-range, or check "
                    "--height-scale and --height-offset",
                    map.first, map.last, manifest.height_min, manifest.height_max)};
}

} // namespace scree
