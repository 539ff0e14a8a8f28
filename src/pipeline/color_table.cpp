#include "pipeline/color_table.h"

#include <algorithm>
#include <cmath>

#include "color/filtered_map.h"
#include "color/shortcut_error.h"
#include "texset/channels.h"
#include "texset/image_file.h"

namespace scree {

namespace {

ColorTable recorded(const FilteredMap& filtered)
{
    MapTableRecord record;
    record.columns = filtered.table.columns;
    record.rows = filtered.table.rows;
    record.low = filtered.table.low;
    record.high = filtered.table.high;
    record.widest = filtered.table.widest;
    record.tolerance = filtered.tolerance;
    record.rms_error = filtered.rms_error;
    record.largest_error = filtered.largest_error;
    return {filtered.table, record};
}

} // namespace

ColorTable color_table_by_height(const MappedColor& mapped, const Survey& survey, double tolerance)
{
    const double low = survey.height_min, high = survey.height_max, widest = (high - low) / 2;
    ColorTable made =
        recorded(make_filtered_map(mapped.map, MapVariable::normal, low, high, widest, tolerance));
    const ShortcutError shortcut = shortcut_error(mapped.map, low, high, widest);
    made.record.shortcut_rms = shortcut.rms;
    made.record.shortcut_largest = shortcut.largest;
    // A renderer has heights normalised.
    made.record.low = (low - survey.h0) / survey.h1;
    made.record.high = (high - survey.h0) / survey.h1;
    made.record.widest = widest / survey.h1;
    return made;
}

ColorTable color_table_by_slope(const MappedColor& mapped, const LevelSummary& finest,
                                double tolerance)
{
    const auto [steepest_s, steepest_t] = *finest.steepest;
    const bool by_length = mapped.by == MapBy::slope_magnitude;
    const double mean = by_length ? std::hypot(steepest_s, steepest_t)
                                  : std::abs(mapped.azimuth_s) * steepest_s +
                                        std::abs(mapped.azimuth_t) * steepest_t;
    // A ridge inside a texel is steeper than the texel's mean, and than its neighbours' halves of
    // it.
    const double steepest = std::max(2 * mean, 4 * *finest.rms_slope);
    const double first = mapped.map.first(), last = mapped.map.last();
    const double beyond = std::max(last - first, 3 * *finest.rms_slope);
    const double low = std::clamp(first - beyond, by_length ? 0 : -steepest, steepest);
    const double high = std::clamp(last + beyond, low, steepest);
    return recorded(make_filtered_map(mapped.map,
                                      by_length ? MapVariable::magnitude : MapVariable::normal, low,
                                      high, steepest, tolerance));
}

ColorMapRecord color_map_record(const MappedColor& mapped, const BakeOptions& options)
{
    ColorMapRecord record;
    record.by = map_by_name(mapped.by);
    record.azimuth_deg = options.map_azimuth_deg;
    record.first = mapped.map.first();
    record.last = mapped.map.last();
    return record;
}

void write_color_table(const MapTable& table, const std::filesystem::path& file,
                       const Attributes& attributes)
{
    ImageFile image(file, table.columns, table.rows, map_info(Map::map).channels, attributes);
    std::vector<float> pixels(3 * static_cast<size_t>(table.columns));
    for (int y = 0; y < table.rows; ++y) {
        float* pixel = pixels.data();
        for (int x = 0; x < table.columns; ++x)
            for (const double c : table.at(x, y))
                *pixel++ = static_cast<float>(c);
        image.write_row(pixels.data());
    }
    image.close();
}

} // namespace scree
