#include "pipeline/color_table.h"

#include <algorithm>
#include <cmath>

#include "color/filtered_map.h"
#include "color/shortcut_error.h"
#include "texset/channels.h"
#include "texset/image_file.h"

namespace scree {

namespace {

struct TableRange {
    double low, high, widest;
};

TableRange range_of(const MappedColor& mapped, const Survey& survey)
{
    const double first = mapped.map.first(), last = mapped.map.last(), width = last - first;
    switch (mapped.by) {
    case MapBy::height:
        return {survey.height_min, survey.height_max, (survey.height_max - survey.height_min) / 2};
    case MapBy::slope:
        return {first - width / 2, last + width / 2, width};
    case MapBy::slope_magnitude:
        break;
    }
    return {0, std::max(0.0, last + width / 2), width};
}

} // namespace

ColorTable color_table(const MappedColor& mapped, const Survey& survey, double tolerance)
{
    const TableRange range = range_of(mapped, survey);
    const MapVariable variable =
        mapped.by == MapBy::slope_magnitude ? MapVariable::magnitude : MapVariable::normal;
    const FilteredMap filtered =
        make_filtered_map(mapped.map, variable, range.low, range.high, range.widest, tolerance);
    MapTableRecord record;
    record.columns = filtered.table.columns;
    record.rows = filtered.table.rows;
    const bool by_height = mapped.by == MapBy::height;
    record.low = by_height ? (range.low - survey.h0) / survey.h1 : range.low;
    record.high = by_height ? (range.high - survey.h0) / survey.h1 : range.high;
    record.widest = by_height ? range.widest / survey.h1 : range.widest;
    record.tolerance = tolerance;
    record.rms_error = filtered.rms_error;
    record.largest_error = filtered.largest_error;
    if (by_height) {
        const ShortcutError shortcut =
            shortcut_error(mapped.map, range.low, range.high, range.widest);
        record.shortcut_rms = shortcut.rms;
        record.shortcut_largest = shortcut.largest;
    }
    return {filtered.table, record};
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
