#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// The statistics of a texture set, straight from their definitions: every texel of every MIP level
/// is summed from the level-0 texels under it, nothing is merged from the level above.
///
/// It judges the code in src/, so it includes none of it. Simple before fast: seconds for 640x480.
namespace scree::oracle {

/// What lies beyond the map's edge; read by the slopes of the border texels only.
enum class Wrap {
    kPeriodic, ///< the opposite border
    kClamp,    ///< the last cell, continued linearly: h(-1) = 2 h(0) - h(1); h(0) where n = 1
    kMirror,   ///< even about the map's edge: texel -1 is texel 0, texel n is texel n - 1
    kBlack,    ///< height 0, world units
};

/// How heights become slopes at level 0.
enum class Reconstruction {
    kBilinear, ///< surface bilinear between texel centres; the slope varies inside a texel
    kCentral,  ///< central difference, constant inside a texel
    kSobel,    ///< 3x3 Sobel, constant inside a texel; with kClamp it repeats the border texel,
               ///< for parity with maketx, so there a plane does not stay a plane
};

/// All grids: height x width, row-major, row 0 at t = 0, s to the right, t down, centres at +0.5.
///
/// A texel is no data when its height, one of its color channels or one of its slopes is NaN or
/// infinite, or when its weight is NaN or <= 0.
struct Input {
    int width = 0;
    int height = 0;
    std::vector<double> heights;               ///< world units; may be empty if slopes are given
    std::vector<std::array<double, 3>> colors; ///< scene-linear; empty: none (statistics 0)
    std::vector<double> weights;               ///< empty: 1 everywhere
    std::vector<std::array<double, 2>> slopes; ///< (s, t) of a normal map; empty: from heights
    double dx = 1;                             ///< texel size along s, world units
    double dy = 1;                             ///< texel size along t, world units
    Wrap wrap_s = Wrap::kPeriodic;
    Wrap wrap_t = Wrap::kPeriodic;
    Reconstruction reconstruction = Reconstruction::kBilinear;
};

/// What lies in the footprint of one texel; all zero where coverage is 0.
struct Texel {
    double coverage = 0;                  ///< weight / weight if all own weights were 1
    std::array<double, 2> mean_slope{};   ///< s, t
    std::array<double, 3> cov_slope{};    ///< ss, tt, st; central, as all that follow
    std::array<double, 4> third_slope{};  ///< sss, sst, stt, ttt
    std::array<double, 5> fourth_slope{}; ///< ssss, ssst, sstt, sttt, tttt
    double mean_hn = 0;                   ///< of hn = (h - h0) / h1
    double var_hn = 0;
    std::array<double, 3> mean_color{};
    std::array<double, 3> var_color{};
    std::array<double, 3> cov_color_hn{};
    std::array<double, 3> cov_color_s{};
    std::array<double, 3> cov_color_t{};
    double kurtosis = 0; ///< Mardia's E[(d' C^-1 d)^2], d = slope - mean; 8 for a Gaussian.
                         ///< C singular to rounding (det <= 1e-12 trace^2): 8 k1 / 3 with k1 the
                         ///< kurtosis along the principal axis; trace <= 0: 0
    double tau = 0;      ///< clamp((kurtosis - 8) / 8, 0, 1): 0 Gaussian, 1 K0
};

struct Level {
    int width = 0;
    int height = 0;
    std::vector<Texel> texels; ///< height x width, row-major

    const Texel& at(int x, int y) const
    {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

struct Result {
    double h0 = 0;                ///< weighted mean height of the valid texels, world units
    double h1 = 1;                ///< their population standard deviation; 1 if they are all equal
    std::size_t valid_texels = 0; ///< level-0 texels that are not no data
    std::vector<Level> levels;    ///< level 0 first, sizes max(1, floor(n / 2)), down to 1x1
};

/// One row of a composed 1-D share matrix: what a coarse texel takes of the level-0 texels
/// first, first + 1, ... along one axis; the shares sum to 1.
struct Shares {
    int first = 0;
    std::vector<long double> share;
};

/// Shares of each texel of one level in the n level-0 texels of an axis.
///
/// Texel j of m takes [j n/m, (j+1) n/m) of the n texels one level finer. Levels are composed, so a
/// fraction of a texel is taken evenly from that texel's whole footprint; this is not the same as
/// cutting level 0 into m equal parts (11 -> 5 -> 2).
std::vector<Shares> composed_shares(int n, int level);

/// Statistics of all levels, summed in long double, mean first and central sums second.
///
/// error  rounding. Equal values have exactly their value for mean, and variance 0; but where the
///        true covariance is 0 and the inputs are rounded (a plane of slope 0.1), kurtosis and tau
///        are those of the rounding errors: compare them only where trace is well above
///        (1e-16 max|h| / d)^2, d = min(dx, dy).
/// throws std::invalid_argument for grids of the wrong size, sizes <= 0, an infinite weight
Result brute_force(const Input& input);

} // namespace scree::oracle
