#include "pipeline/bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "pipeline/color_table.h"
#include "pipeline/describe.h"
#include "pipeline/file_source.h"
#include "pipeline/map_choice.h"
#include "pipeline/mesh_source.h"
#include "pipeline/model_choice.h"
#include "pipeline/set_passes.h"
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
    for (const TextureRecord& texture : manifest.textures)
        if (texture.map == Map::map)
            write_color_table(table.table, folder / texture.file,
                              attributes_of(Map::map, manifest));
}

void expect_output(const BakeOptions& options)
{
    if (options.output.empty())
        throw Error("no output folder; give -o DIR");
}

/// mesh  the source, where it is one; else null
Manifest bake_into(StagedFolder& folder, Source& source, const MeshSource* mesh,
                   const BakeOptions& options, Manifest manifest, const BakeMonitor& monitor)
{
    if (mesh != nullptr)
        manifest.mesh = mesh->record();
    std::optional<ColorMapInput> color_map;
    if (!options.colormap_file.empty()) {
        color_map = read_color_map_input(options);
        manifest.inputs.push_back(color_map->record);
        manifest.working_space = color_map->working_space;
        for (const auto& note : color_map->notes)
            manifest.warnings.push_back(note);
    }
    const Surface surface(source, options, monitor, color_map ? &*color_map : nullptr);
    describe(surface, manifest);
    SetPlan plan;
    plan.maps = choose_maps(source, options, surface.has_color(), surface.found.complete);
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
        measure(surface, heights, plan, manifest);
    if (options.auto_maps)
        choose(options, plan, manifest);
    const VisibilityPlan& visibility = plan.tables.visibility;
    if (visibility.components() > 0)
        manifest.visibility = record_of(visibility);
    manifest.levels = write_textures(surface, plan, heights, manifest, folder.path());
    if (plan.models)
        report_models(*plan.models, plan.maps, manifest.levels);
    if (has_table(manifest) && !by_height)
        table =
            color_table_by_slope(*surface.mapped, manifest.levels.front(), options.map_tolerance);
    if (has_table(manifest))
        write_table(*table, manifest, folder.path());

    if (mesh != nullptr) { // which knows now how far heights reach
        manifest.mesh = mesh->record();
        for (auto& warning : mesh->warnings())
            manifest.warnings.push_back(std::move(warning));
    }
    for (auto& warning : rejects_warnings(surface.found.rejects, options))
        manifest.warnings.push_back(std::move(warning));
    for (auto& warning : scale_warnings(manifest, options))
        manifest.warnings.push_back(std::move(warning));
    for (auto& warning : color_map_warnings(manifest))
        manifest.warnings.push_back(std::move(warning));
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
    return bake_into(folder, source, nullptr, options, std::move(manifest), monitor);
}

Manifest bake(const BakeOptions& options, const BakeMonitor& monitor)
{
    expect_sensible(options);
    if (options.height_file.empty())
        throw Error("no height map; give --height FILE (see scree bake --help)");
    expect_output(options);
    const ThreadLimit limit(options.threads);
    FileSource source(options);
    StagedFolder folder(options.output);
    source.spool_in(folder.path());
    Manifest manifest;
    manifest.name = options.name.empty() ? options.height_file.stem().string() : options.name;
    manifest.inputs = source.records();
    manifest.working_space = source.working_space();
    manifest.warnings = source.notes();
    manifest.quantum = source.quantum();
    manifest.integer_bits = source.integer_bits();
    if (options.mesh_file.empty())
        return bake_into(folder, source, nullptr, options, std::move(manifest), monitor);
    MeshSource mesh(source, options, folder.path(), monitor);
    manifest.inputs.push_back(mesh.input());
    return bake_into(folder, mesh, &mesh, options, std::move(manifest), monitor);
}

} // namespace scree
