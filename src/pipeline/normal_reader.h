#pragma once

#include <vector>

#include "pipeline/channel_rows.h"
#include "pipeline/options.h"

namespace scree {

/// Slopes (-nx/nz, -ny/nz) of a tangent-space normal map, x right, y down the image.
class NormalReader {
public:
    /// Throws Error when the file cannot be read or has fewer than 3 channels.
    NormalReader(const BakeOptions& options);

    /// The next rows; normals that are not finite or face inward (nz <= 0) are kNoData and counted.
    void read(int y, int count, std::vector<double>& slope_s, std::vector<double>& slope_t,
              Rejects& rejects);

    ChannelRows rows;
    std::vector<float> alpha; ///< of the rows just read; empty without

private:
    [[nodiscard]] double component(float stored) const;
    /// Whether a floating-point file's vectors are nearer to unit length as they stand than as
    /// [0, 1]; integers are [0, 1].
    bool looks_signed();

    double sign_x_, sign_y_;
    bool signed_ = false; ///< the file holds [-1, 1], not [0, 1]
};

} // namespace scree
