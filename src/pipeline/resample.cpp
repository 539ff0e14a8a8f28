#include "pipeline/resample.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// Texel `i` of `n` under a wrap; -1 where it is black.
int wrapped(int i, int n, Wrap wrap)
{
    if (i >= 0 && i < n)
        return i;
    switch (wrap) {
    case Wrap::periodic:
        return ((i % n) + n) % n;
    case Wrap::mirror: {
        const int m = ((i % (2 * n)) + 2 * n) % (2 * n);
        return m < n ? m : 2 * n - 1 - m;
    }
    case Wrap::clamp:
        return std::clamp(i, 0, n - 1);
    case Wrap::black:
        break;
    }
    return -1;
}

} // namespace

RowResampler::RowResampler(int from_width, int from_height, int to_width, int to_height,
                           Wrap wrap_s, Wrap wrap_t)
    : from_width_(from_width), from_height_(from_height), to_width_(to_width), wrap_s_(wrap_s),
      // Rows beyond the edge are gone or not there yet: a periodic map repeats its edge instead.
      wrap_t_(wrap_t == Wrap::periodic ? Wrap::clamp : wrap_t),
      same_(from_width == to_width && from_height == to_height)
{
    if (!same_) {
        columns_ = taps_along(from_width, to_width);
        rows_ = taps_along(from_height, to_height);
    }
}

std::vector<RowResampler::Taps> RowResampler::taps_along(int from, int to)
{
    std::vector<Taps> all(static_cast<size_t>(to));
    const double ratio = static_cast<double>(from) / to;
    const double radius = std::max(1.0, ratio);
    for (int i = 0; i < to; ++i) {
        const double center = (i + 0.5) * ratio - 0.5; // in texels of the original, centres whole
        const int first = static_cast<int>(std::floor(center - radius)) + 1;
        const int last = static_cast<int>(std::ceil(center + radius)) - 1;
        Taps& taps = all[static_cast<size_t>(i)];
        taps.first = first;
        double sum = 0;
        for (int k = first; k <= last; ++k)
            sum += 1 - std::abs(k - center) / radius;
        for (int k = first; k <= last; ++k)
            taps.weights.push_back(static_cast<float>((1 - std::abs(k - center) / radius) / sum));
    }
    return all;
}

void RowResampler::stretch_row(size_t channels, const float* from, float* to) const
{
    std::fill_n(to, static_cast<size_t>(to_width_) * channels, 0.0F);
    for (const Taps& taps : columns_) {
        for (size_t k = 0; k < taps.weights.size(); ++k) {
            const int column = wrapped(taps.first + static_cast<int>(k), from_width_, wrap_s_);
            if (column < 0)
                continue;
            const float* texel = from + static_cast<size_t>(column) * channels;
            for (size_t c = 0; c < channels; ++c)
                to[c] += taps.weights[k] * texel[c];
        }
        to += channels;
    }
}

void RowResampler::read(int count, size_t channels, const Read& read, float* pixels)
{
    if (same_) {
        read(count, pixels);
        return;
    }
    const size_t row_size = static_cast<size_t>(to_width_) * channels;
    for (int row = 0; row < count; ++row, ++next_to_, pixels += row_size) {
        const Taps& taps = rows_[static_cast<size_t>(next_to_)];
        const int last = taps.first + static_cast<int>(taps.weights.size()) - 1;
        while (next_from_ <= std::min(last, from_height_ - 1)) {
            original_.resize(static_cast<size_t>(from_width_) * channels);
            read(1, original_.data());
            stretched_.emplace_back(row_size);
            stretch_row(channels, original_.data(), stretched_.back().data());
            ++next_from_;
        }
        std::fill_n(pixels, row_size, 0.0F);
        for (size_t k = 0; k < taps.weights.size(); ++k) {
            const int from = wrapped(taps.first + static_cast<int>(k), from_height_, wrap_t_);
            if (from < 0)
                continue;
            const auto& texels = stretched_[static_cast<size_t>(from - stretched_first_)];
            for (size_t i = 0; i < row_size; ++i)
                pixels[i] += taps.weights[k] * texels[i];
        }
        // Rows that no later row needs; a mirrored edge looks back as far as it looks beyond.
        const int reach = static_cast<int>(taps.weights.size()) + 1;
        while (stretched_.size() > 1 &&
               stretched_first_ < std::min(taps.first, next_from_) - reach) {
            stretched_.erase(stretched_.begin());
            ++stretched_first_;
        }
    }
}

void RowResampler::rewind()
{
    next_from_ = next_to_ = 0;
    stretched_.clear();
    stretched_first_ = 0;
}

} // namespace scree
