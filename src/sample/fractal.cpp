// Fractal terrain with a snow line.

#include "sample/kinds.h"
#include "sample/lattice_noise.h"
#include "sample/shaping.h"

#include <algorithm>

namespace scree {
namespace {

/// Terrain: octaves of noise, amplitudes 0.54 apart, each weighted by 1 / (1 + |d|^2), d the
/// slope of the octaves so far (after Quilez). Steep flanks stay smooth, level ground and
/// crests get the detail, which is roughly what erosion does. Octaves after kEroding keep the
/// last weight.
///
/// The amplitude spectrum falls about as 1 / f^2 (f in both directions), so slopes hardly grow
/// with the resolution. The longer side is 4 km; a larger map of the same shape shows the same
/// land in more detail.
///
/// The snow line rises on steep ground and where the ground climbs along +s, the lee of the
/// wind, and wavers with the finer octaves. Below it grass, and rock where it is steep or high.
class Fractal : public SampleField {
public:
    Fractal(int width, int height)
        : SampleField(describe(width, height)), octaves_(make_octaves(3, 20, width, height, 7))
    {}

private:
    static constexpr double kSide = 4000;                 // m
    static constexpr float kAmplitude = 600;              // m, of the first octave
    static constexpr float kGain = 0.54f;                 // from octave to octave
    static constexpr size_t kEroding = 5;                 // octaves that make the slope d
    static constexpr size_t kRoughFrom = 4, kRoughTo = 9; // octaves that stain the color

    static SampleInfo describe(int width, int height)
    {
        const double texel = kSide / std::max(width, height);
        SampleInfo info;
        info.kind = "fractal";
        info.description = "fractal terrain, grass and rock below a snow line; metres";
        info.width_texels = width;
        info.height_texels = height;
        info.world_width = width * texel;
        info.world_height = height * texel;
        info.wrap_s = info.wrap_t = "periodic";
        info.bilinear.mean_s = info.bilinear.mean_t = 0;
        info.continuous.mean_s = info.continuous.mean_t = 0;
        return info;
    }

    void evaluate(int y, float* heights, float* rgb) const override
    {
        const auto width = static_cast<size_t>(info().width_texels);
        std::vector<float> scratch(7 * width);
        float* noise = scratch.data();
        float* ds = noise + width;
        float* dt = ds + width;
        float* slope_s = dt + width;
        float* slope_t = slope_s + width;
        float* weight = slope_t + width;
        float* detail = weight + width;

        std::fill_n(heights, width, 0.0f);
        float amplitude = kAmplitude;
        for (size_t k = 0; k < octaves_.size(); ++k, amplitude *= kGain) {
            if (k < kEroding) {
                octaves_[k].row(y, noise, ds, dt);
                for (size_t x = 0; x < width; ++x) {
                    const float s = slope_s[x] += ds[x];
                    const float t = slope_t[x] += dt[x];
                    weight[x] = 1 / (1 + s * s + t * t);
                }
            } else {
                octaves_[k].row(y, noise);
            }
            for (size_t x = 0; x < width; ++x)
                heights[x] += amplitude * weight[x] * noise[x];
            if (rgb && k >= kRoughFrom && k < kRoughTo)
                for (size_t x = 0; x < width; ++x)
                    detail[x] += noise[x];
        }
        if (!rgb)
            return;
        for (size_t x = 0; x < width; ++x)
            paint(heights[x], slope_s[x], 1 - weight[x], detail[x], rgb + 3 * x);
    }

    static void paint(float height, float slope_s, float steep, float detail, float* rgb)
    {
        const float line = 15 + 60 * (steep - 0.5f) + 12 * slope_s + 15 * detail;
        const float snow = smooth_step(-30, 30, height - line);
        const float rock = smooth_step(
            -0.35f, 0.35f, 0.5f * (steep - 0.55f) + 0.00375f * (height + 87) + 0.07f * detail);
        const float shade = std::clamp(1 + 0.2f * detail, 0.5f, 1.5f);
        rgb[0] = mix(shade * mix(0.055f, 0.130f, rock), 0.86f, snow);
        rgb[1] = mix(shade * mix(0.085f, 0.112f, rock), 0.89f, snow);
        rgb[2] = mix(shade * mix(0.025f, 0.095f, rock), 0.93f, snow);
    }

    std::vector<LatticeNoise> octaves_;
};

} // namespace

std::unique_ptr<SampleField> make_fractal(int width, int height)
{
    return std::make_unique<Fractal>(width, height);
}

} // namespace scree
