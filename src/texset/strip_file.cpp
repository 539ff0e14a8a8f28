#include "texset/strip_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "math/error.h"
#include "texset/image_rows.h"

namespace scree {

namespace {

/// Channels of red, green and blue: indices into the image.
std::array<int, 3> color_channels(const ImageInfo& info)
{
    std::array<int, 3> channels = {0, 0, 0};
    const std::array<std::string, 3> names = {"R", "G", "B"};
    for (size_t c = 0; c < 3; ++c) {
        const auto found = std::find(info.channels.begin(), info.channels.end(), names[c]);
        if (found == info.channels.end())
            return {0, 0, 0};
        channels[c] = static_cast<int>(found - info.channels.begin());
    }
    return channels;
}

ImageRows open_strip(const std::filesystem::path& path)
{
    try {
        return ImageRows(path);
    } catch (const Error& e) {
        throw Error(fmt::format("{}; a color map is a GMT table (named .cpt), a 1-D LUT that "
                                "OpenColorIO reads (.spi1d, .csp, .cube, .clf, ...) or an image",
                                e.what()));
    }
}

} // namespace

ColorMapFile read_strip(const std::filesystem::path& path)
{
    ImageRows rows = open_strip(path);
    const ImageInfo& info = rows.info();
    std::vector<int> all(info.channels.size());
    for (size_t c = 0; c < all.size(); ++c)
        all[c] = static_cast<int>(c);
    const std::array<int, 3> channels = color_channels(info);
    std::vector<float> texels(static_cast<size_t>(info.width) * all.size());
    rows.next(1, all, texels.data());

    std::vector<Knot> knots;
    for (int i = 0; i < info.width; ++i) {
        const float* texel = &texels[static_cast<size_t>(i) * all.size()];
        Knot knot;
        knot.x = info.width > 1 ? static_cast<double>(i) / (info.width - 1) : 0;
        for (size_t c = 0; c < 3; ++c) {
            knot.color[c] = static_cast<double>(texel[channels[c]]);
            if (info.premultiplied && info.alpha_channel >= 0)
                knot.color[c] /= static_cast<double>(texel[info.alpha_channel]);
            if (!std::isfinite(knot.color[c]))
                throw Error(fmt::format("{}: texel {} of the first row has no color (it is not a "
                                        "number, or of no coverage); every texel of a color map "
                                        "must have one",
                                        info.path, i));
        }
        knots.push_back(knot);
    }
    return {ColorMap(std::move(knots)), false,   std::nullopt,
            info.color_space,           "image", info.color_fallback};
}

} // namespace scree
