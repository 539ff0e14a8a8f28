#include "pipeline/map_lanes.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <numeric>

namespace scree {

void for_each_map(const std::vector<int>& widths, const std::function<void(size_t)>& work)
{
    if (widths.empty())
        return;
    const int widest = *std::max_element(widths.begin(), widths.end());
    const size_t room = std::max<size_t>(1, static_cast<size_t>(kWidthAtOnce / widest));
    const auto threads = static_cast<size_t>(tbb::this_task_arena::max_concurrency());
    const size_t lanes = std::min({room, threads, widths.size()});
    std::atomic<size_t> next{0};
    tbb::parallel_for(
        size_t{0}, lanes,
        [&](size_t) {
            for (size_t map = next++; map < widths.size(); map = next++)
                work(map);
        },
        tbb::simple_partitioner());
}

MapMonitors::MapMonitors(const BakeMonitor& whole, size_t maps) : whole_(whole)
{
    for (size_t map = 0; map < maps; ++map) {
        BakeMonitor monitor;
        monitor.cancel = whole.cancel;
        monitor.progress = [this, map](const char* phase, double done) {
            report(map, phase, done);
        };
        monitors_.push_back(std::move(monitor));
    }
}

void MapMonitors::report(size_t map, const char* phase, double done)
{
    if (!whole_.progress)
        return;
    const std::lock_guard lock(mutex_);
    std::vector<double>& all = done_[phase];
    all.resize(monitors_.size());
    all[map] = done;
    whole_.progress(phase,
                    std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size()));
}

} // namespace scree
