#include "pipeline/map_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/error.h"
#include "pipeline/map_lanes.h"
#include "pipeline/map_survey.h"

namespace scree {

namespace {

/// Keeps the larger error of each texture, and with it the type that serves both.
void unite_types(const std::vector<TextureRecord>& from, std::vector<TextureRecord>& to)
{
    for (size_t i = 0; i < to.size(); ++i) {
        if (!from[i].half_error)
            continue;
        const bool is_first = !to[i].half_error;
        to[i].half_error = std::max(to[i].half_error.value_or(0), *from[i].half_error);
        to[i].float_error = std::max(to[i].float_error.value_or(0), *from[i].float_error);
        to[i].type = is_first ? from[i].type : std::max(to[i].type, from[i].type);
    }
}

std::vector<Manifest> manifests_of(const BakedMaps& maps, const Manifest& set)
{
    std::vector<Manifest> manifests;
    manifests.reserve(maps.size());
    for (const auto& map : maps)
        manifests.push_back(manifest_of_map(set, map->number()));
    return manifests;
}

} // namespace

void measure_maps(const BakedMaps& maps, const HeightGrid* heights, SetPlan& plan,
                  Manifest& manifest)
{
    if (manifest.tiles.empty()) {
        measure(*maps.front()->surface, heights, plan, manifest);
        return;
    }
    std::vector<Manifest> measured = manifests_of(maps, manifest);
    for_each_map(widths_of(maps), [&](size_t map) {
        SetPlan own = plan;
        measure(*maps[map]->surface, nullptr, own, measured[map]);
        maps[map]->source().rest();
    });
    for (const Manifest& own : measured)
        unite_types(own.textures, manifest.textures);
}

void write_maps(const BakedMaps& maps, const HeightGrid* heights, SetPlan& plan, Manifest& manifest,
                const std::filesystem::path& folder)
{
    if (manifest.tiles.empty()) {
        manifest.levels = write_textures(*maps.front()->surface, plan, heights, manifest, folder);
        return;
    }
    const std::vector<Manifest> headers = manifests_of(maps, manifest);
    for_each_map(widths_of(maps), [&](size_t map) {
        try {
            SetPlan own = plan;
            manifest.tiles[map].levels =
                write_textures(*maps[map]->surface, own, nullptr, headers[map], folder);
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& e) {
            throw Error(fmt::format("tile {}: {}", maps[map]->number(), e.what()));
        }
        maps[map]->source().rest();
    });
}

LevelSummary united_level(const BakedMaps& maps, const Manifest& manifest, LevelEnd end)
{
    const auto of = [end](const std::vector<LevelSummary>& levels) {
        return end == LevelEnd::finest ? levels.front() : levels.back();
    };
    if (manifest.tiles.empty())
        return of(manifest.levels);
    LevelSummary whole = of(manifest.tiles.front().levels);
    if (!whole.rms_slope)
        return whole;
    double weight = 0, rms = 0, sigma = 0;
    const std::vector<double> areas = texel_areas(maps);
    for (size_t i = 0; i < maps.size(); ++i) {
        const LevelSummary level = of(manifest.tiles[i].levels);
        const double own = maps[i]->surface->found.weight * areas[i];
        weight += own;
        rms += own * *level.rms_slope * *level.rms_slope;
        sigma += own * *level.slope_sigma * *level.slope_sigma;
        for (size_t axis = 0; axis < 2; ++axis)
            (*whole.steepest)[axis] = std::max((*whole.steepest)[axis], (*level.steepest)[axis]);
    }
    whole.rms_slope = std::sqrt(rms / weight);
    whole.slope_sigma = std::sqrt(sigma / weight);
    return whole;
}

} // namespace scree
