#pragma once

#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "pipeline/options.h"

namespace scree {

/// Maps at work at one time are together no wider than this, texels, unless one is: the memory of
/// a bake grows with the width of what it is at.
constexpr int kWidthAtOnce = 16384;

/// Does something for maps 0 to widths.size() - 1, several at once. Each gets done on its own, so
/// the order tells no difference. The first exception ends it all.
void for_each_map(const std::vector<int>& widths, const std::function<void(size_t)>& work);

/// A monitor for each of several maps, which tell one what they have done together.
class MapMonitors {
public:
    /// whole  must live longer
    MapMonitors(const BakeMonitor& whole, size_t maps);
    MapMonitors(const MapMonitors&) = delete;
    MapMonitors& operator=(const MapMonitors&) = delete;

    [[nodiscard]] const BakeMonitor& of(size_t map) const { return monitors_[map]; }

private:
    void report(size_t map, const char* phase, double done);

    const BakeMonitor& whole_;
    std::deque<BakeMonitor> monitors_;
    std::mutex mutex_;
    std::map<std::string, std::vector<double>> done_; ///< by phase, of every map
};

} // namespace scree
