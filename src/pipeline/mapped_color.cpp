#include "pipeline/mapped_color.h"

#include <fmt/format.h>

#include <cmath>

#include "color/normal_average.h"
#include "color/refined_map.h"
#include "math/error.h"
#include "texset/color_space.h"
#include "texset/file_hash.h"

namespace scree {

ColorMapInput read_color_map_input(const BakeOptions& options)
{
    const std::string path = options.colormap_file.string();
    ColorMapFile file = read_color_map(options.colormap_file);
    const ColorConversion conversion({options.ocio_config, options.working_space,
                                      options.color_space, file.color_space, path,
                                      file.color_fallback});
    const int knots = static_cast<int>(file.map.knots().size());
    file.map = refined(file.map, [&conversion](const Rgb& encoded) {
        float rgb[3];
        for (size_t c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(encoded[c]);
        conversion.apply(rgb, 1);
        return Rgb{rgb[0], rgb[1], rgb[2]};
    });
    InputRecord record{"colormap",
                       options.colormap_file.filename().string(),
                       sha256_of_file(options.colormap_file),
                       knots,
                       1,
                       "R,G,B",
                       file.kind,
                       conversion.input_space()};
    return {std::move(file), path, std::move(record), conversion.working_space(),
            conversion.notes()};
}

Rgb MappedColor::at(double height, double s, double t) const
{
    switch (by) {
    case MapBy::height:
        return map.at(height);
    case MapBy::slope:
        return map.at(azimuth_s * s + azimuth_t * t);
    case MapBy::slope_magnitude:
        break;
    }
    return map.at(std::hypot(s, t));
}

Rgb MappedColor::without_data(const Survey& survey) const
{
    return by == MapBy::height ? normal_average(map, survey.h0, survey.h1) : map.at(0);
}

MappedColor placed(const ColorMapInput& input, const BakeOptions& options, const Survey& survey)
{
    const ColorMapFile& file = input.file;
    constexpr double kRadian = 0.017453292519943295769;
    MappedColor mapped{file.map, options.map_by, std::cos(options.map_azimuth_deg * kRadian),
                       std::sin(options.map_azimuth_deg * kRadian)};
    std::array<double, 2> range{survey.height_min, survey.height_max};
    if (options.map_range)
        range = *options.map_range;
    else if (file.states_range)
        return mapped;
    else if (options.map_by != MapBy::height)
        throw Error(fmt::format("{}: states no range of slopes of its own; give --map-range LOW "
                                "HIGH, the slopes of its two ends",
                                input.path));
    const bool hinged = file.hinge && options.map_by == MapBy::height;
    mapped.map = hinged ? file.map.stretched(range[0], range[1], *file.hinge)
                        : file.map.stretched(range[0], range[1]);
    return mapped;
}

} // namespace scree
