#pragma once

#include <functional>
#include <vector>

#include "pipeline/options.h"

namespace scree {

/// Fits rows of one image to another size, from top to bottom, a few rows in memory.
///
/// A triangle filter, as wide as a texel of the coarser of the two grids, per axis: bilinear
/// interpolation where the image grows, an area average with soft edges where it shrinks. Equal
/// sizes pass through untouched. Beyond the edge the wrap of the map decides; what a periodic map
/// has beyond its first and last row is taken from the edge itself (one strip is all there is).
/// A texel that is not finite makes those it contributes to not finite.
class RowResampler {
public:
    RowResampler(int from_width, int from_height, int to_width, int to_height, Wrap wrap_s,
                 Wrap wrap_t);

    /// Reads interleaved rows of the original, in order.
    using Read = std::function<void(int count, float* pixels)>;

    /// The next `count` rows at the new size.
    void read(int count, size_t channels, const Read& read, float* pixels);

    void rewind();

private:
    /// Texels first, first + 1, ... of the original with their weights, which sum to 1.
    struct Taps {
        int first = 0;
        std::vector<float> weights;
    };
    static std::vector<Taps> taps_along(int from, int to);
    void stretch_row(size_t channels, const float* from, float* to) const;

    int from_width_, from_height_, to_width_;
    Wrap wrap_s_, wrap_t_;
    bool same_;
    std::vector<Taps> columns_, rows_;
    int next_from_ = 0, next_to_ = 0;
    std::vector<std::vector<float>> stretched_; ///< rows of the original at the new width
    int stretched_first_ = 0;
    std::vector<float> original_;
};

} // namespace scree
