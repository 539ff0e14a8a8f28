#include "pipeline/bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "pipeline/color_table.h"
#include "pipeline/describe.h"
#include "pipeline/map_choice.h"
#include "pipeline/map_inputs.h"
#include "pipeline/map_passes.h"
#include "pipeline/map_survey.h"
#include "pipeline/model_choice.h"
#include "pipeline/spooled_heights.h"
#include "pipeline/thread_limit.h"
#include "pipeline/warnings.h"
#include "texset/staged_folder.h"
#include "visibility/slope_survey.h"

namespace scree {

namespace {

VisibilityRecord record_of(const VisibilityPlan& table)
{
    VisibilityRecord record{table.node_angles_deg, table.harmonics, table.azimuths, {}};
    if (table.axes)
        record.axis_deg = table.axis_deg;
    return record;
}

/// Chooses the models of color, and drops the textures that they do without.
void choose(const BakeOptions& options, SetPlan& plan, Manifest& manifest)
{
    manifest.model_choice = choose_models(*plan.models, plan.maps, options);
    plan.maps = maps_of(*manifest.model_choice, plan.maps, options);
    plan.tables = {
        rank_terms_of(*manifest.model_choice), table_of(*manifest.model_choice, *plan.models), {}};
    std::vector<TextureRecord> kept;
    for (TextureRecord& texture : manifest.textures) {
        if (std::find(plan.maps.begin(), plan.maps.end(), texture.map) == plan.maps.end())
            continue;
        texture.channels = channels_of(texture.map, plan.tables);
        kept.push_back(std::move(texture));
    }
    manifest.textures = std::move(kept);
}

/// Lays nodes and axes of the tables of visibility where they serve the heights best.
void fit_to(const HeightGrid& heights, const BakeOptions& options, TableSizes& tables)
{
    const SlopeSurvey slopes = survey_slopes(heights);
    for (VisibilityPlan* table : {&tables.visibility, &tables.tried}) {
        if (table->components() == 0)
            continue;
        if (options.move_nodes)
            table->node_angles_deg = moved_node_angles(table->node_angles_deg, slopes.steepness);
        if (table->axes)
            table->axis_deg = options.axis_deg.value_or(slopes.axis_deg);
    }
}

/// Whether maps are made of what a measurement finds.
bool has_fit(const std::vector<Map>& maps)
{
    return std::find(maps.begin(), maps.end(), Map::exponent) != maps.end();
}

/// Tells every level what the models leave of it.
void report_models(const MeasuredModels& models, const std::vector<Map>& maps,
                   std::vector<LevelSummary>& levels)
{
    for (size_t level = 0; level < levels.size(); ++level) {
        levels[level].model_errors = models.levels[level];
        if (has_fit(maps))
            levels[level].exponent = models.exponents[level];
    }
}

bool has_table(const Manifest& manifest)
{
    return std::any_of(manifest.textures.begin(), manifest.textures.end(),
                       [](const TextureRecord& texture) { return texture.map == Map::map; });
}

void write_table(const ColorTable& table, Manifest& manifest, const std::filesystem::path& folder)
{
    manifest.color_map->table = table.record;
    const Attributes attributes = attributes_of(Map::map, manifest);
    for (const TextureRecord& texture : manifest.textures)
        if (texture.map == Map::map)
            for (const std::string& file : files_of(texture, manifest))
                write_color_table(table.table, folder / file, attributes);
}

void expect_output(const BakeOptions& options)
{
    if (options.output.empty())
        throw Error("no output folder; give -o DIR");
}

/// The color map's table by slope, of the slopes that were found.
ColorTable table_by_slope(const BakedMaps& maps, const BakeOptions& options,
                          const Manifest& manifest)
{
    return color_table_by_slope(*maps.front()->surface->mapped,
                                united_level(maps, manifest, LevelEnd::finest),
                                options.map_tolerance);
}

std::optional<ColorMapInput> read_color_map(const BakeOptions& options, Manifest& manifest)
{
    if (options.colormap_file.empty())
        return std::nullopt;
    ColorMapInput color_map = read_color_map_input(options);
    manifest.inputs.push_back(color_map.record);
    manifest.working_space = color_map.working_space;
    warn(manifest, color_map.notes);
    return color_map;
}

/// Every texel of every map has data.
bool are_complete(const BakedMaps& maps)
{
    return std::all_of(maps.begin(), maps.end(),
                       [](const auto& map) { return map->surface->found.complete; });
}

void add_warnings(const BakedMaps& maps, const BakeOptions& options, Manifest& manifest)
{
    Rejects rejects;
    for (const auto& map : maps) {
        rejects += map->surface->found.rejects;
        if (map->mesh() == nullptr)
            continue;
        const std::string where = map->number() == 0 ? "" : fmt::format("tile {}: ", map->number());
        for (const std::string& warning : map->mesh()->warnings())
            warn(manifest, {where + warning});
    }
    const LevelSummary coarsest = united_level(maps, manifest, LevelEnd::coarsest);
    warn(manifest, rejects_warnings(rejects, options));
    warn(manifest, scale_warnings(manifest, coarsest, options));
    warn(manifest, color_map_warnings(manifest, coarsest));
}

Manifest bake_into(StagedFolder& folder, BakedMaps& maps, const BakeOptions& options,
                   Manifest manifest, const BakeMonitor& monitor)
{
    const std::optional<ColorMapInput> color_map = read_color_map(options, manifest);
    survey_maps(maps, options, monitor, manifest.warnings);
    const MapMonitors monitors(monitor, maps.size());
    for (size_t i = 0; i < maps.size(); ++i)
        maps[i]->surface =
            std::make_unique<Surface>(maps[i]->source(), maps[i]->options(), monitors.of(i),
                                      std::move(maps[i]->found), color_map ? &*color_map : nullptr);
    const Surface& surface = *maps.front()->surface;
    describe_mesh(maps, manifest);
    describe(maps, manifest);
    SetPlan plan;
    plan.maps = choose_maps(surface.source, options, surface.has_color(), are_complete(maps));
    plan.tables = tables_of(plan.maps, options);
    manifest.textures = textures_for(plan.maps, plan.tables, options, manifest.name);
    const bool by_height = options.map_by == MapBy::height;
    // By height it is one of the models to be measured; by slope it is made of the slopes found.
    std::optional<ColorTable> table;
    if (has_table(manifest) && by_height) {
        table = color_table_by_height(*surface.mapped, surface.found, options.map_tolerance);
        plan.map_table = &table->table;
    }
    std::optional<SpooledHeights> spooled;
    if (needs_views(plan.maps, options))
        spooled.emplace(surface, folder.path());
    const HeightGrid* heights = spooled ? &*spooled : nullptr;
    if (heights != nullptr)
        fit_to(*heights, options, plan.tables);
    if (options.auto_maps || options.pixel_type == PixelTypeChoice::automatic || has_fit(plan.maps))
        measure_maps(maps, heights, plan, manifest);
    if (options.auto_maps)
        choose(options, plan, manifest);
    const VisibilityPlan& visibility = plan.tables.visibility;
    if (visibility.components() > 0)
        manifest.visibility = record_of(visibility);
    write_maps(maps, heights, plan, manifest, folder.path());
    if (plan.models)
        report_models(*plan.models, plan.maps, manifest.levels);
    if (has_table(manifest) && !by_height)
        table = table_by_slope(maps, options, manifest);
    if (has_table(manifest))
        write_table(*table, manifest, folder.path());

    describe_mesh(maps, manifest); // which knows now how far heights reach
    add_warnings(maps, options, manifest);
    write_manifest(manifest, folder.path());
    monitor.report("bake", 1);
    folder.publish();
    return manifest;
}

} // namespace

Manifest bake(Source& source, const BakeOptions& options, Manifest manifest,
              const BakeMonitor& monitor)
{
    expect_sensible(options);
    expect_output(options);
    const ThreadLimit limit(options.threads);
    StagedFolder folder(options.output); // first, so that a bad -o fails before the work
    BakedMaps maps;
    maps.push_back(std::make_unique<BakedMap>(source, options));
    return bake_into(folder, maps, options, std::move(manifest), monitor);
}

Manifest bake(const BakeOptions& options, const BakeMonitor& monitor)
{
    expect_sensible(options);
    if (options.height_file.empty())
        throw Error("no height map; give --height FILE (see scree bake --help)");
    expect_output(options);
    const ThreadLimit limit(options.threads);
    std::optional<BakedMesh> mesh;
    if (!options.mesh_file.empty())
        mesh.emplace(options);
    Manifest manifest;
    std::optional<StagedFolder> folder; // outlives the maps, whose many files it needs closed to go
    BakedMaps maps = open_maps(options, mesh ? &*mesh : nullptr, manifest);
    folder.emplace(options.output);
    for (const auto& map : maps)
        map->files()->spool_in(folder->path());
    if (mesh)
        lay_on(*mesh, maps, folder->path(), manifest, monitor);
    return bake_into(*folder, maps, options, std::move(manifest), monitor);
}

} // namespace scree
