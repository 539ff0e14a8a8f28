#include "pipeline/color_reader.h"

#include <algorithm>
#include <cmath>

#include "pipeline/let_go.h"

namespace scree {

ColorReader::ColorReader(const BakeOptions& options, int width, int height)
    : rows(options.color_file),
      conversion({options.ocio_config, options.working_space, options.color_space,
                  rows.info().color_space, rows.info().path, rows.info().color_fallback}),
      resampler_(rows.info().width, rows.info().height, width, height, options.wrap_s,
                 options.wrap_t),
      width_(width)
{
    rows.choose(choose_color_channels(rows.info()),
                options.alpha_weight || rows.info().premultiplied);
    weigh_ = rows.has_alpha() && options.alpha_weight;
    divide_ = rows.has_alpha() && rows.info().premultiplied;
}

void ColorReader::rewind(bool last_time)
{
    rows.rewind(last_time);
    resampler_.rewind();
}

void ColorReader::rest()
{
    rows.rest();
    let_go(linear_);
    let_go(interleaved_);
    let_go(alpha);
}

void ColorReader::read(int y, int count, std::vector<float>& color, Rejects& rejects)
{
    const auto texels = static_cast<size_t>(count) * static_cast<size_t>(width_);
    const size_t channels = weigh_ ? 4 : 3;
    interleaved_.resize(texels * channels);
    resampler_.read(
        count, channels, [this](int row_count, float* out) { read_linear(row_count, out); },
        interleaved_.data());
    color.resize(texels * 3);
    alpha.resize(weigh_ ? texels : 0);
    for (size_t i = 0; i < texels; ++i) {
        const float* from = &interleaved_[i * channels];
        for (size_t c = 0; c < 3; ++c)
            color[i * 3 + c] = weigh_ && from[3] > 0 ? from[c] / from[3] : from[c];
        if (weigh_)
            alpha[i] = from[3];
        for (int c = 0; c < 3; ++c)
            if (!std::isfinite(from[c])) {
                reject(rejects.not_finite, rows.info().path, rows.name(c),
                       static_cast<int>(i) % width_, y + static_cast<int>(i) / width_);
                break;
            }
    }
}

void ColorReader::read_linear(int count, float* out)
{
    const float* pixels = rows.next(count);
    const auto texels = static_cast<size_t>(count) * static_cast<size_t>(rows.info().width);
    const auto stride = static_cast<size_t>(rows.stride());
    linear_.resize(texels * 3);
    for (size_t i = 0; i < texels; ++i) {
        const float* from = pixels + i * stride;
        const bool divide = divide_ && from[3] > 0;
        for (size_t c = 0; c < 3; ++c)
            linear_[i * 3 + c] = divide ? from[c] / from[3] : from[c];
    }
    conversion.apply(linear_.data(), static_cast<long>(texels));
    for (size_t i = 0; i < texels; ++i) {
        const float a = weigh_ ? pixels[i * stride + 3] : 1;
        for (size_t c = 0; c < 3; ++c)
            *out++ = linear_[i * 3 + c] * a;
        if (weigh_)
            *out++ = a;
    }
}

} // namespace scree
