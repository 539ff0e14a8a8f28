#include "pipeline/set_passes.h"

#include <memory>

#include "pipeline/describe.h"
#include "pipeline/gutter_rows.h"
#include "pipeline/level_report.h"
#include "pipeline/map_choice.h"
#include "pipeline/pixel_types.h"
#include "pipeline/strip.h"
#include "pipeline/write_pass.h"
#include "visibility/visible_bands.h"

namespace scree {

namespace {

TexelMoments texels_of(const Surface& surface, const MomentLayout& layout)
{
    return {layout,          surface.found,
            surface.options, surface.mapped ? &*surface.mapped : nullptr,
            surface.width(), surface.texel[0],
            surface.texel[1]};
}

/// What views see of a surface, for one pass over it.
class SeenRows {
public:
    SeenRows(const HeightGrid& heights, const TableSizes& tables,
             const std::vector<ViewAngles>& views)
        : components_({tables.visibility, tables.tried}, views), bands_(heights, components_)
    {}

    [[nodiscard]] VisibleBands* bands() { return components_.count() > 0 ? &bands_ : nullptr; }

private:
    ViewComponents components_;
    VisibleBands bands_;
};

} // namespace

void measure(const Surface& surface, const HeightGrid* heights, SetPlan& plan, Manifest& manifest)
{
    const BakeOptions& options = surface.options;
    const int width = surface.width(), height = surface.height();
    const MeasuredViews views(options.max_view_angle_deg);
    const int view_count = heights != nullptr ? static_cast<int>(views.angles.size()) : 0;
    const MomentLayout layout =
        moments_for(plan.maps, plan.tables, view_count, surface.source, options);
    LevelReport report(layout, width, height, surface.found.h1);
    std::vector<TexelVisitor*> visitors;
    auto visit = [&visitors](const std::vector<TexelVisitor*>& more) {
        visitors.insert(visitors.end(), more.begin(), more.end());
    };
    std::optional<PixelTypes> types;
    std::optional<ModelErrors> models;
    if (options.pixel_type == PixelTypeChoice::automatic)
        visit(types.emplace(manifest.textures, layout, surface.scale(), width, height).visitors());
    if (options.auto_maps || heights != nullptr)
        visit({&models.emplace(layout, surface.scale(), plan.map_table, plan.tables, views, width,
                               height)});
    if (options.auto_maps)
        visit(report.visitors());
    std::optional<SeenRows> seen;
    if (heights != nullptr)
        seen.emplace(*heights, plan.tables, views.angles);
    StripReader strips(surface.source, surface.found, options, seen ? seen->bands() : nullptr,
                       false);
    MomentPyramid pyramid(layout, width, height, visitors);
    measure_pass(strips, pyramid, texels_of(surface, layout), height, surface.monitor);

    if (types)
        types->choose(manifest.textures, options.half_tolerance);
    if (models)
        plan.models = models->measured();
    if (options.auto_maps)
        manifest.levels = report.summaries();
}

std::vector<LevelSummary> write_textures(const Surface& surface, SetPlan& plan,
                                         const HeightGrid* heights, const Manifest& manifest,
                                         const std::filesystem::path& folder)
{
    const MeasuredViews views(surface.options.max_view_angle_deg);
    const bool measures = heights != nullptr && !plan.models;
    const std::vector<ViewAngles> more = measures ? views.angles : std::vector<ViewAngles>();
    const MomentLayout layout = moments_for(plan.maps, plan.tables, static_cast<int>(more.size()),
                                            surface.source, surface.options);
    ValueScale scale = surface.scale();
    if (plan.models)
        for (const auto& fit : plan.models->exponents)
            scale.exponents.push_back(fit.value_or(ExponentFit()));
    LevelReport report(layout, surface.width(), surface.height(), surface.found.h1);
    std::vector<TextureOutput> outputs;
    std::vector<TextureRows*> textures;
    const bool is_reported = !manifest.levels.empty();
    std::vector<TexelVisitor*> visitors;
    if (!is_reported)
        visitors = report.visitors();
    for (const TextureRecord& texture : manifest.textures) {
        if (texture.map == Map::map)
            continue;
        TextureOutput output{
            texture.map,
            std::make_unique<MipFile>(folder / texture.file,
                                      MipLayout{surface.width(), surface.height(), texture.channels,
                                                texture.type, surface.options.compression,
                                                attributes_of(texture.map, manifest)}),
            nullptr};
        output.rows = std::make_unique<TextureRows>(texture.map, layout, scale, *output.file);
        textures.push_back(output.rows.get());
        outputs.push_back(std::move(output));
    }
    std::optional<GutterRows> gutter;
    if (!surface.found.covered)
        visitors.push_back(&gutter.emplace(surface.width(), surface.height(),
                                           surface.options.wrap_s, surface.options.wrap_t,
                                           textures));
    else
        visitors.insert(visitors.end(), textures.begin(), textures.end());
    std::optional<ModelErrors> models;
    if (measures)
        visitors.push_back(&models.emplace(layout, scale, plan.map_table, plan.tables, views,
                                           surface.width(), surface.height()));
    std::optional<SeenRows> seen;
    if (heights != nullptr)
        seen.emplace(*heights, plan.tables, more);
    StripReader strips(surface.source, surface.found, surface.options,
                       seen ? seen->bands() : nullptr, true);
    MomentPyramid pyramid(layout, surface.width(), surface.height(), visitors);
    write_pass(strips, pyramid, texels_of(surface, layout), outputs, surface.height(),
               surface.monitor);
    if (models)
        plan.models = models->measured();
    return is_reported ? manifest.levels : report.summaries();
}

} // namespace scree
