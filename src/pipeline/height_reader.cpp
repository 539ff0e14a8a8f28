#include "pipeline/height_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "math/error.h"

namespace scree {

namespace {

int choose_height_channel(const ImageInfo& info, const BakeOptions& options)
{
    if (!options.height_channel.empty())
        return channel_index(info, options.height_channel, "--height-channel");
    const bool only_alpha_beside = info.channels.size() == 2 && info.alpha_channel == 1;
    if (info.channels.size() == 1 || only_alpha_beside)
        return 0;
    throw Error(fmt::format("{}: {} channels, expected 1 height channel; name one with "
                            "--height-channel {} (or give --input normal)",
                            info.path, info.channels.size(), info.channels.front()));
}

} // namespace

HeightReader::HeightReader(const BakeOptions& options)
    : rows(options.height_file), scale_(options.height_scale), offset_(options.height_offset)
{
    if (options.no_data_height) // as the file holds it, so that a decimal number finds its float
        no_data_ = static_cast<float>(*options.no_data_height);
    rows.choose({choose_height_channel(rows.info(), options)}, options.alpha_weight);
}

void HeightReader::read(int y, int count, std::vector<double>& height, Rejects& rejects)
{
    const float* pixels = rows.next(count);
    const int width = rows.info().width;
    height.resize(static_cast<size_t>(count) * static_cast<size_t>(width));
    for (size_t i = 0; i < height.size(); ++i) {
        const float value = pixels[i * static_cast<size_t>(rows.stride())];
        const auto texel = static_cast<int>(i);
        height[i] = offset_ + scale_ * static_cast<double>(value);
        if (no_data_ && value == *no_data_) {
            height[i] = kNoData;
            reject(rejects.marked, rows.info().path, rows.name(0), texel % width,
                   y + texel / width);
        } else if (!std::isfinite(value)) {
            height[i] = kNoData;
            reject(rejects.not_finite, rows.info().path, rows.name(0), texel % width,
                   y + texel / width);
        }
    }
    rows.alpha_of(pixels, alpha);
}

double HeightReader::quantum() const
{
    const int bits = rows.info().integer_bits;
    if (bits == 0)
        return 0;
    const bool is_signed = rows.info().type.rfind("int", 0) == 0;
    return std::abs(scale_) / (std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1);
}

} // namespace scree
