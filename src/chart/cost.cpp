#include "chart/cost.h"

#include <time.h> // NOLINT(modernize-deprecated-headers): clocks of POSIX

#include <algorithm>
#include <functional>

#include "reference/gather.h"

namespace scree {

namespace {

/// Processor time of this thread.
double now_ns()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

double time_of(const std::function<void()>& work)
{
    const double begin = now_ns();
    work();
    return now_ns() - begin;
}

/// Times pieces of work in turns, each of `count` footprints.
std::vector<Cost> time_in_turns(const std::vector<std::function<void()>>& works, int count,
                                int rounds, const BakeMonitor& monitor)
{
    std::vector<std::vector<double>> times(works.size());
    for (int round = -1; round < rounds; ++round) {
        for (size_t i = 0; i < works.size(); ++i) {
            const double ns = time_of(works[i]) / count;
            if (round >= 0)
                times[i].push_back(ns);
        }
        monitor.report("time", (round + 2.0) / (rounds + 1));
    }
    std::vector<Cost> costs;
    for (auto& of : times) {
        std::sort(of.begin(), of.end());
        const size_t quarter = of.size() / 4;
        costs.push_back(
            {of[of.size() / 2], of.front(), of.back(), of[quarter], of[of.size() - 1 - quarter]});
    }
    return costs;
}

/// Lookups as they lie in memory, each with directions of its own.
struct TileTexel {
    FootprintData data;
    Vec3f wo, wi;
};

std::vector<TileTexel> tile_of(const ChartFootprints& footprints, const ChartViews& views)
{
    std::vector<TileTexel> tile;
    for (size_t i = 0; i < static_cast<size_t>(kCostTexels); ++i) {
        // Each time round the footprints come with other directions.
        const size_t turn = i / footprints.data.size() + i;
        tile.push_back({footprints.data[i % footprints.data.size()],
                        Vec3f(views.views[turn % views.views.size()]),
                        Vec3f(views.lights[turn % views.lights.size()])});
    }
    return tile;
}

/// Somewhere results go that the compiler cannot leave out.
volatile float checksum = 0;

} // namespace

std::vector<Cost> time_methods(const ChartFootprints& footprints, const MethodSetting& setting,
                               const ChartViews& views, int rounds, const BakeMonitor& monitor)
{
    const std::vector<TileTexel> tile = tile_of(footprints, views);
    std::vector<std::function<void()>> works;
    for (const Method& method : methods())
        works.emplace_back([&tile, &setting, evaluate = method.radiance] {
            float sum = 0;
            for (const TileTexel& texel : tile) {
                const Rgbf radiance = evaluate(texel.data, setting, texel.wo, texel.wi);
                sum += radiance[0] + radiance[1] + radiance[2];
            }
            checksum = sum;
        });
    return time_in_turns(works, kCostTexels, rounds, monitor);
}

std::vector<Cost> time_supersampling(const reference::DisplacedSurface& surface,
                                     const std::vector<reference::Footprint>& footprints,
                                     const std::vector<int>& grids, const Material& material,
                                     const ChartViews& views, int rounds,
                                     const BakeMonitor& monitor)
{
    constexpr size_t kFootprints = 32;
    std::vector<std::function<void()>> works;
    works.reserve(grids.size());
    for (const int grid : grids)
        works.emplace_back([&, grid] {
            double sum = 0;
            for (size_t i = 0; i < kFootprints; ++i) {
                // Neighbours in the lists are of one level and of one band: go through them in
                // leaps that come by all of them.
                reference::GatherPlan plan;
                plan.views = {views.views[i * 13 % views.views.size()]};
                plan.lights = {views.lights[i % views.lights.size()]};
                plan.base_alpha = static_cast<double>(material.base_alpha);
                plan.grid = grid;
                const size_t place = i * 29 % footprints.size();
                sum += gather(surface, footprints[place], plan, i).all.lit[0].diffuse[0];
            }
            checksum = static_cast<float>(sum);
        });
    return time_in_turns(works, kFootprints, rounds, monitor);
}

} // namespace scree
