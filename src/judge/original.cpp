#include "judge/original.h"

#include <algorithm>
#include <utility>

#include "math/error.h"
#include "pipeline/file_source.h"
#include "pipeline/mapped_color.h"
#include "pipeline/surface.h"

namespace scree {

namespace {

reference::Beyond beyond(Wrap wrap)
{
    switch (wrap) {
    case Wrap::periodic:
        return reference::Beyond::repeats;
    case Wrap::mirror:
        return reference::Beyond::mirrors;
    case Wrap::clamp:
        return reference::Beyond::extends;
    case Wrap::black:
        break;
    }
    return reference::Beyond::ends;
}

void append(const SurfaceRows& rows, Original& original)
{
    reference::Relief& relief = original.relief;
    relief.heights.insert(relief.heights.end(), rows.height.begin(), rows.height.end());
    for (size_t i = 0; i < rows.slope_s.size(); ++i)
        original.slopes.push_back({rows.slope_s[i], rows.slope_t[i]});
    for (size_t i = 0; i + 2 < rows.color.size(); i += 3)
        relief.colors.push_back({static_cast<double>(rows.color[i]),
                                 static_cast<double>(rows.color[i + 1]),
                                 static_cast<double>(rows.color[i + 2])});
    relief.weights.insert(relief.weights.end(), rows.weight.begin(), rows.weight.end());
}

/// Colors of a color map, which the source does not have.
void color_by_height(const MappedColor& mapped, reference::Relief& relief)
{
    relief.colors.reserve(relief.heights.size());
    for (const double height : relief.heights)
        relief.colors.push_back(mapped.at(height, 0, 0));
}

/// The same of a map by slope: of the mean slope of each texel.
void color_by_slope(const MappedColor& mapped, Reconstruction reconstruction, Original& original)
{
    const reference::Statistics statistics(statistics_input(original, reconstruction));
    reference::Relief& relief = original.relief;
    std::vector<reference::Rgb> colors;
    colors.reserve(static_cast<size_t>(relief.width) * static_cast<size_t>(relief.height));
    for (int y = 0; y < relief.height; y += kStripRows)
        for (const auto& texel : statistics.rows(0, y, std::min(kStripRows, relief.height - y)))
            colors.push_back(mapped.at(0, texel.mean_slope[0], texel.mean_slope[1]));
    relief.colors = std::move(colors);
}

Original read(Source& source, const BakeOptions& options, const BakeMonitor& monitor,
              const ColorMapInput* color_map, const std::optional<HeightScale>& scale)
{
    Survey found = survey(source, monitor);
    if (scale) {
        found.h0 = scale->h0;
        found.h1 = scale->h1;
        found.height_min = scale->lowest;
        found.height_max = scale->highest;
    }
    const Surface surface(source, options, monitor, std::move(found), color_map);
    Original original;
    original.scale = scale;
    reference::Relief& relief = original.relief;
    relief.width = surface.width();
    relief.height = surface.height();
    relief.texel_width = surface.texel[0];
    relief.texel_height = surface.texel[1];
    relief.beyond_s = beyond(options.wrap_s);
    relief.beyond_t = beyond(options.wrap_t);
    original.has_color = surface.has_color();

    const auto texels = static_cast<size_t>(relief.width) * static_cast<size_t>(relief.height);
    if (source.has_heights())
        relief.heights.reserve(texels);
    if (source.has_color())
        relief.colors.reserve(texels);

    source.rewind(true);
    SurfaceRows rows;
    for (int y = 0; y < relief.height; y += kStripRows) {
        source.read(std::min(kStripRows, relief.height - y), rows);
        append(rows, original);
        monitor.report("read", static_cast<double>(y) / relief.height);
    }
    if (surface.mapped && surface.mapped->by == MapBy::height)
        color_by_height(*surface.mapped, relief);
    else if (surface.mapped)
        color_by_slope(*surface.mapped, options.reconstruction, original);
    return original;
}

} // namespace

Original read_original(const BakeOptions& options, const BakeMonitor& monitor,
                       const std::optional<HeightScale>& scale)
{
    FileSource source(options);
    if (options.colormap_file.empty())
        return read(source, options, monitor, nullptr, scale);
    const ColorMapInput color_map = read_color_map_input(options);
    return read(source, options, monitor, &color_map, scale);
}

Original read_original(Source& source, const BakeOptions& options, const BakeMonitor& monitor)
{
    return read(source, options, monitor, nullptr, {});
}

reference::StatisticsInput statistics_input(const Original& original, Reconstruction reconstruction)
{
    reference::StatisticsInput input{
        original.relief, original.slopes, reference::Reconstruction::bilinear, {}};
    if (original.scale)
        input.h0_h1 = {original.scale->h0, original.scale->h1};
    if (reconstruction == Reconstruction::central)
        input.reconstruction = reference::Reconstruction::central;
    else if (reconstruction == Reconstruction::sobel)
        input.reconstruction = reference::Reconstruction::sobel;
    return input;
}

} // namespace scree
