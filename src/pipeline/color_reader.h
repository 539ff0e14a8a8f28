#pragma once

#include <vector>

#include "pipeline/channel_rows.h"
#include "pipeline/options.h"
#include "pipeline/resample.h"
#include "texset/color_space.h"

namespace scree {

/// Scene-linear colors of a file, at the size of the height map.
class ColorReader {
public:
    /// width, height  of the height map
    /// Throws Error when the file cannot be read, has no color, or its color space is unknown.
    ColorReader(const BakeOptions& options, int width, int height);

    void rewind(bool last_time);
    void rest();

    /// The next rows, linear, with alpha divided out of them where the file has it multiplied in;
    /// where it is 0 the color is as the file has it. Texels that are not finite are counted.
    void read(int y, int count, std::vector<float>& color, Rejects& rejects);

    ChannelRows rows;
    ColorConversion conversion;
    std::vector<float> alpha; ///< the weight of the rows just read; empty without

private:
    /// Rows of the file, linear, times alpha where alpha is the weight: what resampling may
    /// average.
    void read_linear(int count, float* out);

    RowResampler resampler_;
    int width_;
    bool weigh_ = false;  ///< alpha is the weight
    bool divide_ = false; ///< color is multiplied by alpha in the file
    std::vector<float> linear_, interleaved_;
};

} // namespace scree
