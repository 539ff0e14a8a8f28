#pragma once

#include <optional>
#include <vector>

#include "pipeline/channel_rows.h"
#include "pipeline/options.h"

namespace scree {

/// Heights of a file in world units: offset + scale * value.
class HeightReader {
public:
    /// Throws Error when the file cannot be read or its height channel is not clear.
    HeightReader(const BakeOptions& options);

    /// The next rows; texels without data are kNoData and counted. `y` is the first row's number.
    void read(int y, int count, std::vector<double>& height, Rejects& rejects);

    /// One step of an integer file, world units; 0 for floating point.
    [[nodiscard]] double quantum() const;

    ChannelRows rows;
    std::vector<float> alpha; ///< of the rows just read; empty without

private:
    double scale_, offset_;
    std::optional<float> no_data_;
};

} // namespace scree
