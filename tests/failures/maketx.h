#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// Version of the maketx on PATH, "2.4.7.1"; empty where there is none.
std::string maketx_version();

/// All levels that `maketx --bumpslopes` makes of an image; absent where there is no maketx.
///
/// type     of the pixels in the file it reads: "float", "uint16", ...
/// options  more of them: "-d float --wrap periodic"
/// ending   of that file and of what maketx writes, which decides their formats
/// Throws Error when maketx refuses.
std::optional<std::vector<Image>> maketx_levels(const Image& image, const std::string& options,
                                                const std::string& type = "float",
                                                const std::string& ending = "exr");

/// Channels of what it writes.
enum Bumpslopes { kHeight, kMeanS, kMeanT, kMeanSs, kMeanTt, kMeanSt };

/// A number of its levels, where there are any.
template <class Of>
std::optional<double> of_levels(const std::optional<std::vector<Image>>& levels, Of of)
{
    if (!levels)
        return {};
    return static_cast<double>(of(*levels));
}

/// One channel of the 1x1 level.
std::optional<double> of_top(const std::optional<std::vector<Image>>& levels, int channel);

/// Variance of the slope along s of a texel: raw moment less squared mean, as shaders compute it,
/// but in double; and of the 1x1 level.
double variance_s(const Image& level, int x, int y);
double variance_of_top(const std::vector<Image>& levels);

/// Mean of one channel over a level.
double mean_over(const Image& level, int channel);

} // namespace scree::test
