#include "figures/height_color_footprint.h"

#include <algorithm>

#include "stats/pyramid.h"

namespace scree::test {

Footprint mix(const std::vector<std::pair<const Footprint*, double>>& parts)
{
    Footprint all;
    for (const auto& [part, share] : parts)
        for (const Group& g : *part)
            all.push_back({g.height,
                           g.mass * share,
                           {g.color[0] * share, g.color[1] * share, g.color[2] * share}});
    std::sort(all.begin(), all.end(),
              [](const Group& a, const Group& b) { return a.height < b.height; });
    size_t last = 0;
    for (size_t i = 1; i < all.size(); ++i)
        if (all[i].height == all[last].height) {
            all[last].mass += all[i].mass;
            for (size_t c = 0; c < 3; ++c)
                all[last].color[c] += all[i].color[c];
        } else
            all[++last] = all[i];
    all.resize(last + 1);
    return all;
}

Color mean_color(const Footprint& footprint)
{
    Color sum{};
    for (const Group& g : footprint)
        for (size_t c = 0; c < 3; ++c)
            sum[c] += g.color[c];
    return sum;
}

FootprintLevel finest(const Surface& surface)
{
    FootprintLevel level{surface.size, {}};
    for (size_t i = 0; i < surface.heights.size(); ++i)
        level.texels.push_back({{surface.heights[i], 1, surface.colors[i]}});
    return level;
}

FootprintLevel coarser(const FootprintLevel& fine)
{
    FootprintLevel level{coarser_size(fine.size), {}};
    for (int y = 0; y < level.size; ++y)
        for (int x = 0; x < level.size; ++x) {
            const Share rows = share_of(y, fine.size, level.size);
            const Share columns = share_of(x, fine.size, level.size);
            std::vector<std::pair<const Footprint*, double>> parts;
            for (int i = 0; i < rows.count; ++i)
                for (int j = 0; j < columns.count; ++j)
                    parts.emplace_back(&fine.texels[fine.index(columns.first + j, rows.first + i)],
                                       rows.parts[i] * columns.parts[j]);
            level.texels.push_back(mix(parts));
        }
    return level;
}

} // namespace scree::test
