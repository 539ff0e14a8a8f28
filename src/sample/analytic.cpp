// The samples with known answers: V-grooves, a sine, a plane.

#include "sample/kinds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace scree {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Color {
    float r, g, b;
};

/// Color linear in height: `low` where position is 0, `high` where it is 1.
void write_ramp(float* rgb, float position, const Color& low, const Color& high)
{
    rgb[0] = low.r + position * (high.r - low.r);
    rgb[1] = low.g + position * (high.g - low.g);
    rgb[2] = low.b + position * (high.b - low.b);
}

/// V-grooves along t. Texel size 1, P = period in texels, and along a row
///
///   h_i = min(m, P - m) / 2,   m = i mod P
///
/// so valleys (m = 0) and, for even P, ridges (m = P / 2) lie on texel centres, and the surface
/// is its own bilinear interpolation: every value, and every slope, is exact in float.
///
///   even P: half of the segments rise with 1/2, half fall with -1/2:
///           E[s] = 0, E[ss] = 1/4, E[t] = E[tt] = E[st] = 0
///           with q = P / 2:  E[h] = P / 8,  E[hh] = (2 q^2 + 1) / 24
///   odd P:  the two texels at m = (P -+ 1) / 2 are equally high, so one segment of P is flat:
///           E[s] = 0, E[ss] = (1 - 1 / P) / 4
///           with q = (P - 1) / 2:  E[h] = q (q + 1) / (2 P),  E[hh] = q (q + 1) / 12
///
/// (sums of k and k^2 over m.) P is the divisor of the width nearest to 16, among the even
/// ones if the width is even; 16 whenever 16 divides the width. A prime width is one groove.
class Vgroove : public SampleField {
public:
    Vgroove(int width, int height) : SampleField(describe(width, height)), period_(period(width)) {}

private:
    /// q above.
    static int half(int period) { return period / 2; }

    static int period(int width)
    {
        const int step = width % 2 == 0 ? 2 : 1;
        int best = width;
        for (int p = 2; p <= width; p += step)
            if (width % p == 0 && std::abs(p - 16) < std::abs(best - 16))
                best = p;
        return best;
    }

    static SampleInfo describe(int width, int height)
    {
        const int p = period(width);
        const double q = half(p);
        KnownAnswers known;
        known.mean_s = 0;
        known.mean_t = 0;
        known.var_ss = p % 2 == 0 ? 0.25 : 0.25 * (1 - 1.0 / p);
        known.var_tt = 0;
        known.cov_st = 0;
        known.mean_height = p % 2 == 0 ? p / 8.0 : q * (q + 1) / (2 * p);
        const double square = p % 2 == 0 ? (2 * q * q + 1) / 24 : q * (q + 1) / 12;
        known.std_height = std::sqrt(std::max(0.0, square - known.mean_height * known.mean_height));

        SampleInfo info;
        info.kind = "vgroove";
        info.description = "V-grooves along t, slopes +-0.5, dark in the valleys";
        info.width_texels = width;
        info.height_texels = height;
        info.world_width = width;
        info.world_height = height;
        info.wrap_s = info.wrap_t = "periodic";
        info.bilinear = known;
        info.continuous = known;
        if (p % 2 == 0) {
            // A triangle wave of amplitude P / 4 is uniform between its extremes.
            info.continuous.std_height = p / 4.0 / std::sqrt(12.0);
        } else {
            // Where the top is cut off depends on the sampling: there is no surface behind it.
            info.continuous = KnownAnswers();
        }
        return info;
    }

    void evaluate(int, float* heights, float* rgb) const override
    {
        const float top = std::max(0.5f * static_cast<float>(half(period_)), 0.5f);
        const Color valley = {0.04f, 0.03f, 0.02f}, ridge = {0.84f, 0.78f, 0.66f};
        for (int x = 0; x < info().width_texels; ++x) {
            const int m = x % period_;
            heights[x] = 0.5f * static_cast<float>(std::min(m, period_ - m));
            if (rgb)
                write_ramp(rgb + std::ptrdiff_t(3) * x, heights[x] / top, valley, ridge);
        }
    }

    int period_;
};

/// A tilted sine: at texel (i, j), with whole wave numbers p and q,
///
///   h = A sin(i a + j b),   a = 2 pi p / width,  b = 2 pi q / height
///
/// Surface, with texels dx x dy:  E[ss] = A^2 a^2 / (2 dx^2),  E[tt] = A^2 b^2 / (2 dy^2),
/// E[st] = A^2 a b / (2 dx dy); E[h] = 0, E[hh] = A^2 / 2.
///
/// Bilinear interpolation: in the square with the texel centres (i, j) and (i + 1, j + 1) at
/// its corners, at (f, g) in [0, 1]^2, and with the phase u = i a + j b,
///
///   ds h = ((1 - g) X(u) + g X(u + b)) / dx,  X(u) = h(i+1, j) - h(i, j)
///                                                  = 2 A sin(a/2) cos(u + a/2)
///   dt h = ((1 - f) Y(u) + f Y(u + a)) / dy,  Y(u) = 2 A sin(b/2) cos(u + b/2)
///
/// Over all (i, j), cos(u + c) cos(u + d) averages to cos(c - d) / 2: exactly, since the sum of
/// exp(2 i u) is zero unless width divides 2p and height divides 2q, and 2p < width, 2q <
/// height leave only p = q = 0, where X = Y = 0. With E[(1-g)^2 + g^2] = 2/3 and E[2 g (1-g)] =
/// 1/3:
///
///   E[ss] = 2 A^2 sin^2(a/2) (2 + cos b) / 3 / dx^2      E[tt]: a and b exchanged, dy
///
/// and f, g being independent, X and Y enter E[st] by their means over g and f,
/// (X(u) + X(u+b)) / 2 = 2 A sin(a/2) cos(b/2) cos(u + a/2 + b/2) and its mirror image:
///
///   E[st] = A^2 sin a sin b / 2 / (dx dy)
///
/// The mean slope is zero, as of any periodic surface. Texels: E[h] = 0, E[hh] = A^2 / 2 (0 for
/// p = q = 0). The longer side is 1 wide, so slopes do not depend on the resolution.
class Sine : public SampleField {
public:
    Sine(int width, int height)
        : SampleField(describe(width, height)), waves_(waves(width, height)),
          sin_s_(static_cast<size_t>(width)), cos_s_(static_cast<size_t>(width))
    {
        for (int x = 0; x < width; ++x) {
            const double a = phase(x, waves_.p, width);
            sin_s_[static_cast<size_t>(x)] = kAmplitude * std::sin(a);
            cos_s_[static_cast<size_t>(x)] = kAmplitude * std::cos(a);
        }
    }

private:
    static constexpr double kAmplitude = 0.02;

    struct Waves {
        int p, q;
    };

    /// Five waves by three on a square, the same wavelength on other shapes, below Nyquist.
    static Waves waves(int width, int height)
    {
        const double side = std::max(width, height);
        const int p = static_cast<int>(std::lround(5 * width / side));
        const int q = static_cast<int>(std::lround(3 * height / side));
        return {std::min(p, (width - 1) / 2), std::min(q, (height - 1) / 2)};
    }

    /// 2 pi k i / n, from the whole-number remainder: exactly periodic, no large arguments.
    static double phase(int i, int k, int n)
    {
        const auto turn = static_cast<double>(std::int64_t(i) * k % n);
        return 2 * kPi * turn / n;
    }

    static SampleInfo describe(int width, int height)
    {
        const Waves w = waves(width, height);
        const double texel = 1.0 / std::max(width, height);
        const double a = 2 * kPi * w.p / width, b = 2 * kPi * w.q / height;
        const double square = kAmplitude * kAmplitude, area = texel * texel;

        SampleInfo info;
        info.kind = "sine";
        info.description = "a tilted sine wave, light on the crests";
        info.width_texels = width;
        info.height_texels = height;
        info.world_width = width * texel;
        info.world_height = height * texel;
        info.wrap_s = info.wrap_t = "periodic";

        KnownAnswers& surface = info.continuous;
        surface.mean_s = surface.mean_t = surface.mean_height = 0;
        surface.var_ss = square * a * a / 2 / area;
        surface.var_tt = square * b * b / 2 / area;
        surface.cov_st = square * a * b / 2 / area;
        surface.std_height = w.p == 0 && w.q == 0 ? 0 : kAmplitude / std::sqrt(2.0);

        const double sin_a = std::sin(a / 2), sin_b = std::sin(b / 2);
        info.bilinear = surface;
        info.bilinear.var_ss = 2 * square * sin_a * sin_a * (2 + std::cos(b)) / 3 / area;
        info.bilinear.var_tt = 2 * square * sin_b * sin_b * (2 + std::cos(a)) / 3 / area;
        info.bilinear.cov_st = square * std::sin(a) * std::sin(b) / 2 / area;
        return info;
    }

    void evaluate(int y, float* heights, float* rgb) const override
    {
        const double b = phase(y, waves_.q, info().height_texels);
        const double sin_t = std::sin(b), cos_t = std::cos(b);
        const Color trough = {0.02f, 0.06f, 0.18f}, crest = {0.70f, 0.76f, 0.72f};
        for (size_t x = 0; x < sin_s_.size(); ++x) {
            const double h = sin_s_[x] * cos_t + cos_s_[x] * sin_t;
            heights[x] = static_cast<float>(h);
            if (rgb)
                write_ramp(rgb + 3 * x, static_cast<float>(0.5 + 0.5 * h / kAmplitude), trough,
                           crest);
        }
    }

    Waves waves_;
    std::vector<double> sin_s_, cos_s_; // A sin(i a), A cos(i a)
};

/// A tilted plane: at texel (i, j), with texel size 1 and the map's middle at height 0,
///
///   h = 0.3 (i - (width - 1) / 2) - 0.2 (j - (height - 1) / 2)
///
/// Slope (0.3, -0.2) everywhere, variance 0, to the rounding of the heights to float. The texel
/// heights have mean 0 and variance (0.3^2 (width^2 - 1) + 0.2^2 (height^2 - 1)) / 12, the
/// surface the same without the two -1. This holds inside the map; what lies beyond the border
/// is up to the reader of the map. One who clamps by repeating the border texels sees a flat
/// half texel at each end, and so a mean slope less by the factor 1 - 1 / width (1 - 1 /
/// height).
class Plane : public SampleField {
public:
    Plane(int width, int height) : SampleField(describe(width, height)) {}

private:
    static constexpr double kSlopeS = 0.3, kSlopeT = -0.2;

    static SampleInfo describe(int width, int height)
    {
        SampleInfo info;
        info.kind = "plane";
        info.description = "a tilted plane, slopes 0.3 and -0.2, light where it is high";
        info.width_texels = width;
        info.height_texels = height;
        info.world_width = width;
        info.world_height = height;
        info.wrap_s = info.wrap_t = "clamp";

        const double w = width, h = height;
        const double ss = kSlopeS * kSlopeS / 12, tt = kSlopeT * kSlopeT / 12;
        KnownAnswers& surface = info.continuous;
        surface.mean_s = kSlopeS;
        surface.mean_t = kSlopeT;
        surface.var_ss = surface.var_tt = surface.cov_st = surface.mean_height = 0;
        surface.std_height = std::sqrt(ss * w * w + tt * h * h);
        info.bilinear = surface;
        info.bilinear.std_height = std::sqrt(ss * (w * w - 1) + tt * (h * h - 1));
        return info;
    }

    void evaluate(int y, float* heights, float* rgb) const override
    {
        const double mid_s = 0.5 * (info().width_texels - 1);
        const double mid_t = 0.5 * (info().height_texels - 1);
        const double top = std::max(std::abs(kSlopeS) * mid_s + std::abs(kSlopeT) * mid_t, 0.1);
        const Color low = {0.05f, 0.05f, 0.05f}, high = {0.75f, 0.75f, 0.75f};
        for (int x = 0; x < info().width_texels; ++x) {
            const double h = kSlopeS * (x - mid_s) + kSlopeT * (y - mid_t);
            heights[x] = static_cast<float>(h);
            if (rgb)
                write_ramp(rgb + std::ptrdiff_t(3) * x, static_cast<float>(0.5 + 0.5 * h / top),
                           low, high);
        }
    }
};

} // namespace

std::unique_ptr<SampleField> make_vgroove(int width, int height)
{
    return std::make_unique<Vgroove>(width, height);
}

std::unique_ptr<SampleField> make_sine(int width, int height)
{
    return std::make_unique<Sine>(width, height);
}

std::unique_ptr<SampleField> make_plane(int width, int height)
{
    return std::make_unique<Plane>(width, height);
}

} // namespace scree
