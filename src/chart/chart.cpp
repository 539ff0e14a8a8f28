#include "chart/chart.h"

#include <fmt/format.h>

#include "chart/footprints.h"
#include "chart/measured_color.h"
#include "chart/pareto.h"
#include "chart/truth.h"
#include "judge/ray_reach.h"
#include "math/error.h"
#include "pipeline/thread_limit.h"

namespace scree {

namespace {

/// Side lengths of the supersampling grids: 1 to 1024 samples.
const std::vector<int> kGrids = {1, 2, 4, 8, 16, 32};

void expect_sensible(const ChartOptions& options)
{
    if (options.footprints < 1)
        throw Error("--footprints: expected 1 or more");
    if (options.grid < 2 || options.grid > 1024)
        throw Error("--samples: expected a grid of 2 to 1024 samples a side");
    if (!(options.material.base_alpha > 0 && options.material.base_alpha <= 1))
        throw Error("--base-alpha: expected a roughness above 0, up to 1");
    if (!(options.material.f0 >= 0 && options.material.f0 <= 1))
        throw Error("--f0: expected a reflectance from 0 to 1");
}

std::vector<ChartRow> method_rows(const ChartFootprints& footprints, const MethodSetting& setting,
                                  const ErrorScale& yardstick, int rounds,
                                  const BakeMonitor& monitor)
{
    const auto costs = time_methods(footprints, setting, yardstick.views, rounds, monitor);
    std::vector<ChartRow> rows;
    for (const Method& method : methods()) {
        std::vector<Appearance> shown;
        for (const FootprintData& data : footprints.data)
            shown.push_back(appearance_of(method, data, setting, yardstick.views));
        ChartRow row;
        row.name = method.name;
        row.what = method.what;
        row.family = method.family;
        row.bytes = bytes_per_texel(method, footprints.types);
        row.cost = costs[rows.size()];
        row.errors = rms_differences(yardstick, shown, yardstick.truth);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// plan  of the truth
std::vector<ChartRow> supersampling_rows(const reference::DisplacedSurface& surface,
                                         const std::vector<reference::Footprint>& places,
                                         const ErrorScale& yardstick, TruthPlan plan, int rounds,
                                         const BakeMonitor& monitor)
{
    const auto costs =
        time_supersampling(surface, places, kGrids, plan.material, plan.views, rounds, monitor);
    std::vector<ChartRow> rows;
    int all_samples = 0, samples_before = 0;
    for (const int grid : kGrids)
        all_samples += grid * grid;
    for (const int grid : kGrids) {
        plan.grid = grid;
        ++plan.seed; // neither the truth's samples nor those of another grid
        const auto shown = supersample(surface, places, plan, [&](double done) {
            monitor.report("samples", (samples_before + grid * grid * done) / all_samples);
        });
        samples_before += grid * grid;
        ChartRow row;
        row.samples = grid * grid;
        row.name = fmt::format("{} {}", row.samples, row.samples == 1 ? "sample" : "samples");
        row.what = "the reference renderer itself, with random numbers of its own.";
        row.family = MethodFamily::supersampling;
        row.cost = costs[rows.size()];
        row.errors = rms_differences(yardstick, shown, yardstick.truth);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

AssetChart make_chart(const Asset& asset, const ChartOptions& options, const BakeMonitor& monitor)
{
    expect_sensible(options);
    const ThreadLimit limit(options.threads);
    const reference::DisplacedSurface surface(asset.relief);
    const std::string too_high = too_high_for_rays(surface);
    if (!too_high.empty())
        throw Error(fmt::format("{}: {}", asset.name, too_high));
    const ChartFootprints footprints =
        bake_footprints(asset, options.footprints, options.seed, monitor);
    const TruthPlan plan{chart_views(), options.material, options.grid, options.seed};
    const ChartTruth truth = gather_truth(surface, footprints.places, plan, monitor);
    const MethodSetting setting{options.material, &footprints.height_colors,
                                nodes_of(footprints.visibility, footprints.visibility_axes)};

    AssetChart chart;
    chart.asset = asset.name;
    chart.width = asset.relief.width;
    chart.height = asset.relief.height;
    chart.footprints = static_cast<int>(footprints.places.size());
    chart.bands = plan.views.bands;
    chart.visibility = footprints.visibility;
    chart.visibility_axes = footprints.visibility_axes;
    chart.noise = truth.noise;
    chart.rays = truth.rays;
    chart.rows = method_rows(footprints, setting, truth.yardstick, options.rounds, monitor);
    for (ChartRow& row : supersampling_rows(surface, footprints.places, truth.yardstick, plan,
                                            options.rounds, monitor))
        chart.rows.push_back(std::move(row));
    return chart;
}

double cost_of(const ChartRow& row, CostAxis axis)
{
    return axis == CostAxis::time ? row.cost.median_ns : row.bytes;
}

double error_of(const RelativeErrors& errors, ErrorKind kind)
{
    return kind == ErrorKind::radiance ? errors.radiance : errors.color;
}

std::vector<bool> front_of(const AssetChart& chart, size_t band, CostAxis axis, ErrorKind kind)
{
    std::vector<CostAndError> ways;
    for (const ChartRow& row : chart.rows)
        ways.push_back({cost_of(row, axis), error_of(row.errors[band], kind)});
    return pareto_front(ways);
}

} // namespace scree
