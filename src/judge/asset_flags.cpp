#include "judge/asset_flags.h"

#include <fmt/format.h>

#include <cmath>

#include "judge/asset_measures.h"
#include "pipeline/options.h"

namespace scree {

namespace {

/// Slope 1 is 45 degrees; few materials are so steep over all, and most inputs that are have the
/// wrong scale.
constexpr double kSteep = 1;
/// Fewer texels in the whole map than two footprints of 32x32.
constexpr size_t kFewTexels = 2048;
/// Two normal laws of equal weight reach it when 3.8 deviations apart; evenly spread heights have
/// 3/4. Skewness, as in Sarle's coefficient, does not raise it, nor do the tails of a single mode.
constexpr double kTwoModes = 0.8;
/// Well off what the models can be, 8 (Gaussian) to 16 (K0): evenly spread slopes have 5.6.
constexpr double kFewSlopes = 6, kBeyondK0 = 20;
/// Normal slopes have 0.59.
constexpr double kCracks = 0.25;
/// A fifth of the variance of one goes with the other; Smith's masking takes them as independent.
constexpr double kSteeperWithHeight = 0.45;
/// Of deviations: a variance 6 times the other.
constexpr double kOneDirection = 2.5;
constexpr double kOnlyDirection = 1000;
/// As many as 8 bits have, and a third of the neighbours alike.
constexpr size_t kFewHeights = 256;
constexpr double kTerraces = 1.0 / 3;

constexpr double kDegreesPerRadian = 57.29577951308232;

using Flags = std::vector<std::string>;

void flag_size(const AssetMeasures& asset, Flags& flags)
{
    if (asset.texels < kFewTexels)
        flags.push_back(
            fmt::format("only {} texels have data: coarse levels sum up few of them, so "
                        "kurtosis and rank tables are those of chance; use a larger map",
                        asset.texels));
}

void flag_slopes(const AssetMeasures& asset, Flags& flags)
{
    if (asset.rms_slope > kSteep)
        flags.push_back(fmt::format("rms slope {:.3g} ({:.0f} degrees) is steep: light bounces "
                                    "between facets, which no texture here has; check "
                                    "--height-scale and --texel-size",
                                    asset.rms_slope,
                                    std::atan(asset.rms_slope) * kDegreesPerRadian));
    if (asset.kurtosis && *asset.kurtosis < kFewSlopes)
        flags.push_back(
            fmt::format("kurtosis {:.1f} of the slopes (footprints of {}x{} texels): "
                        "neither Gaussian (8) nor heavy-tailed (16), but facets of few "
                        "slopes; their highlights are apart, the set shows one wide one",
                        *asset.kurtosis, asset.footprint, asset.footprint));
    if (asset.kurtosis && *asset.kurtosis > kBeyondK0)
        flags.push_back(
            fmt::format("kurtosis {:.0f} of the slopes (footprints of {}x{} texels) is "
                        "beyond Gaussian (8) and K0 (16): rare steep places in a smooth "
                        "surface; the set shows the smooth part too rough",
                        *asset.kurtosis, asset.footprint, asset.footprint));
    if (asset.steep_share < kCracks)
        flags.push_back(
            fmt::format("90 % of the squared slope lies in {:.0f} % of the area (59 % of Gaussian "
                        "slopes): plateaus with steep edges hide less than their slopes tell; "
                        "masking, and color by height with it, errs in grazing views",
                        100 * asset.steep_share));
    if (asset.slope_ratio > kOneDirection) {
        const std::string across =
            asset.slope_ratio > kOnlyDirection
                ? "are all there is"
                : fmt::format("are {:.1f} times those across", asset.slope_ratio);
        flags.push_back(fmt::format("slopes at {:.0f} degrees from +s towards +t {}: what is "
                                    "averaged over azimuths fits no view; look at views along and "
                                    "across",
                                    asset.azimuth_deg, across));
    }
}

void flag_heights(const AssetMeasures& asset, Flags& flags)
{
    if (asset.modes && asset.modes->explained > kTwoModes) {
        const HeightModes& modes = *asset.modes;
        flags.push_back(fmt::format("heights have two modes: {:.0f} % of the area near {:.3g}, the "
                                    "rest near {:.3g}, explain {:.0f} % of their variance (64 % of "
                                    "Gaussian heights): colorheight and tables of color maps take "
                                    "heights as Gaussian; the rank table does not",
                                    100 * modes.low_share, modes.low, modes.high,
                                    100 * modes.explained));
    }
    if (std::abs(asset.height_steepness) > kSteeperWithHeight)
        flags.push_back(
            fmt::format("{} parts are the steeper ones (correlation {:+.2f}): masking "
                        "takes slopes and heights as independent; compare grazing views",
                        asset.height_steepness > 0 ? "high" : "low", asset.height_steepness));
    if (asset.steps && asset.steps->values > 1 && asset.steps->values <= kFewHeights &&
        asset.steps->level_share > kTerraces)
        flags.push_back(
            fmt::format("only {} different heights, and {:.0f} % of neighbouring texels "
                        "are level: terraces, whose edges make the slopes; use a height "
                        "map of 16 bits or float",
                        asset.steps->values, 100 * asset.steps->level_share));
}

} // namespace

std::vector<std::string> asset_flags(const Original& original, Reconstruction reconstruction)
{
    const AssetMeasures asset = measure_asset(original, reconstruction);
    Flags flags;
    flag_size(asset, flags);
    flag_slopes(asset, flags);
    flag_heights(asset, flags);
    return flags;
}

} // namespace scree
