// A brick wall in running bond.

#include "sample/kinds.h"
#include "sample/lattice_noise.h"
#include "sample/shaping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scree {
namespace {

/// Bricks of 215 x 65 mm with 10 mm joints: four by twelve on a square, every other course
/// shifted by half a brick; on other shapes the nearest whole number of bricks and even number
/// of courses, so the texels of awkward sizes are not quite square.
///
/// A brick is a plateau with rounded corners and a bevelled edge, set back and tilted a little
/// and fired a little differently from its neighbours; its outline wavers. The mortar between
/// is recessed, rougher and lighter. One coverage, from joint to brick, drives height and
/// color.
class Bricks : public SampleField {
public:
    Bricks(int width, int height)
        : SampleField(describe(width, height)), across_(across(width, height)),
          courses_(courses(width, height)), waver_(make_octaves(40, 3, width, height, 101)),
          grain_(make_octaves(180, 4, width, height, 201))
    {}

private:
    static constexpr float kPitchS = 225, kPitchT = 75, kJoint = 10; // mm
    static constexpr float kCorner = 5, kBevel = 5;                  // mm
    static constexpr float kRelief = 7;                              // mm, from mortar to brick

    static int across(int width, int height)
    {
        const double side = std::max(width, height);
        return std::max(1, static_cast<int>(std::lround(4 * width / side)));
    }

    static int courses(int width, int height)
    {
        const double side = std::max(width, height);
        return 2 * std::max(1, static_cast<int>(std::lround(6 * height / side)));
    }

    static SampleInfo describe(int width, int height)
    {
        SampleInfo info;
        info.kind = "bricks";
        info.description = "brick wall in running bond, light recessed mortar; millimetres";
        info.width_texels = width;
        info.height_texels = height;
        info.world_width = across(width, height) * double(kPitchS);
        info.world_height = courses(width, height) * double(kPitchT);
        info.wrap_s = info.wrap_t = "periodic";
        info.bilinear.mean_s = info.bilinear.mean_t = 0;
        info.continuous.mean_s = info.continuous.mean_t = 0;
        return info;
    }

    /// Sum of the octaves of row y, each 0.6 times as strong as the one before.
    static void add_octaves(const std::vector<LatticeNoise>& octaves, int y, float* sum,
                            std::vector<float>& noise)
    {
        float amplitude = 1;
        for (const LatticeNoise& octave : octaves) {
            octave.row(y, noise.data());
            for (size_t x = 0; x < noise.size(); ++x)
                sum[x] += amplitude * noise[x];
            amplitude *= 0.6f;
        }
    }

    void evaluate(int y, float* heights, float* rgb) const override
    {
        const int width = info().width_texels;
        const auto count = static_cast<size_t>(width);
        std::vector<float> noise(count), waver(count), grain(count);
        add_octaves(waver_, y, waver.data(), noise);
        add_octaves(grain_, y, grain.data(), noise);

        const double t = (y + 0.5) * courses_ / info().height_texels;
        const int course = static_cast<int>(t);
        const float from_middle_t = (static_cast<float>(t - course) - 0.5f) * kPitchT;
        const double shift = course % 2 == 0 ? 0.25 : 0.75; // no joint on the map's border
        for (int x = 0; x < width; ++x) {
            const double s = (x + 0.5) * across_ / width + shift;
            const int column = static_cast<int>(s);
            const float from_middle_s = (static_cast<float>(s - column) - 0.5f) * kPitchS;
            const Brick brick = fire(course * across_ + column % across_);
            const auto i = static_cast<size_t>(x);

            const float depth = inside(from_middle_s, from_middle_t) + 1.3f * waver[i];
            const float cover = smooth_step(0, kBevel, depth);
            const float mortar = 0.5f * waver[i] + 0.9f * grain[i];
            const float face = kRelief + brick.set_back + brick.tilt_s * from_middle_s +
                               brick.tilt_t * from_middle_t + 0.35f * waver[i] + 0.3f * grain[i];
            heights[x] = mix(mortar, face, cover);
            if (rgb)
                paint(brick, cover, depth, waver[i], grain[i], rgb + std::ptrdiff_t(3) * x);
        }
    }

    /// Distance to the outline of the brick, mm, positive inside: a rectangle with round
    /// corners.
    static float inside(float from_middle_s, float from_middle_t)
    {
        const float s = std::abs(from_middle_s) - (0.5f * (kPitchS - kJoint) - kCorner);
        const float t = std::abs(from_middle_t) - (0.5f * (kPitchT - kJoint) - kCorner);
        if (std::min(s, t) <= 0)
            return kCorner - std::max(s, t);
        return kCorner - std::sqrt(s * s + t * t);
    }

    /// What differs from brick to brick.
    struct Brick {
        float set_back;       // mm
        float tilt_s, tilt_t; // slope
        float burnt, pale;    // 0 to 1
    };

    static Brick fire(int index)
    {
        const std::uint32_t key = hash32(static_cast<std::uint32_t>(index) + 0x51ab5u);
        auto draw = [key](std::uint32_t k) { return unit_float(hash32(key + k)); };
        const float burnt = draw(3);
        return {1.6f * draw(0) - 0.8f, 0.012f * draw(1) - 0.006f, 0.04f * draw(2) - 0.02f,
                burnt * burnt * burnt, draw(4)};
    }

    static void paint(const Brick& brick, float cover, float depth, float waver, float grain,
                      float* rgb)
    {
        const float edge = smooth_step(0, 14, depth); // rims are worn paler
        const float stain = 1 + 0.22f * waver + 0.28f * grain;
        const float dark = stain * mix(1.15f, 1, edge) * mix(1, 0.35f, brick.burnt);
        const float sand = 1 + 0.10f * waver + 0.16f * grain;
        rgb[0] = mix(0.56f * sand, dark * mix(0.27f, 0.40f, brick.pale), cover);
        rgb[1] = mix(0.53f * sand, dark * mix(0.065f, 0.150f, brick.pale), cover);
        rgb[2] = mix(0.47f * sand, dark * mix(0.035f, 0.085f, brick.pale), cover);
        for (int k = 0; k < 3; ++k)
            rgb[k] = std::clamp(rgb[k], 0.0f, 1.0f);
    }

    int across_, courses_;
    std::vector<LatticeNoise> waver_, grain_;
};

} // namespace

std::unique_ptr<SampleField> make_bricks(int width, int height)
{
    return std::make_unique<Bricks>(width, height);
}

} // namespace scree
