// Visible color in src/shaders/scree_set.glsl against the kernel's C++ front, by every model.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shaders/exponent_levels.h"
#include "shaders/gl_fixture.h"
#include "shaders/packed_set.h"

namespace scree::test {
namespace {

using Imath::V3f;

constexpr double kTolerance = 1e-5; // absolute, of colors in [0, 1]

/// The sampler of each texture of a set.
std::vector<std::pair<std::string, GLuint>> upload(GlContext& context, const PackedSet& set)
{
    const auto nearest = [&](const std::vector<Image>& levels) {
        return context.texture(levels, GlFilter::nearest);
    };
    // What a set does not have has something else in its place, which no model looks at.
    return {{"slope", nearest(set.slope)},
            {"extra", nearest(set.extra)},
            {"color", nearest(set.color)},
            {"color_height", nearest(set.color_height)},
            {"rank_b", nearest(set.rank_b)},
            {"rank_g", nearest(set.rank_g)},
            {"rank_r", nearest(set.rank_r)},
            {"color_slope_bg", nearest(set.color_slope_bg)},
            {"color_slope_r", nearest(set.color_slope_r)},
            {"exponents", nearest(set.exponent.empty() ? set.color : set.exponent)},
            {"map", context.texture(set.map.empty() ? set.color : set.map, GlFilter::trilinear,
                                    GL_CLAMP_TO_EDGE)}};
}

class GlslColor : public Glsl {
protected:
    /// Compares levels and views; returns the largest difference.
    double worst_difference(const SampleSet& set, const std::vector<ColorLook>& looks)
    {
        const GLuint program =
            context().program({"tests/shaders/screen.vert"},
                              {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                               "src/shaders/scree_set.glsl", "tests/shaders/set_color.frag"});
        context().bind(program, upload(context(), pack(set)));
        const auto& table = set.map_table;
        context().set(program, "map_range", {table.low, table.high, table.widest});
        context().set(program, "map_by",
                      set.map_by == "slope" ? 1 : (set.map_by == "slope magnitude" ? 2 : 0));
        context().set(program, "direction",
                      {std::cos(set.map_azimuth_rad), std::sin(set.map_azimuth_rad)});
        double worst = 0;
        std::vector<float> shift(looks.size()); // of the mean color
        for (const V3f& view : {V3f(0, 0, 1), V3f(0.5F, 0.6F, 0.7F).normalized(),
                                V3f(-0.9F, 0.3F, 0.2F).normalized()})
            for (const size_t level : {0U, 1U, 3U, 5U})
                for (size_t i = 0; i < looks.size(); ++i) {
                    const ColorLook& look = looks[i];
                    const Image& size = set.slope[level];
                    context().set(program, "wo", {view.x, view.y, view.z});
                    context().set(
                        program, "size",
                        {static_cast<float>(size.width), static_cast<float>(size.height)});
                    context().set(program, "level", std::vector<float>{static_cast<float>(level)});
                    context().set(program, "color_model", look.color_model);
                    context().set(program, "slope_color", look.slope_color ? 1 : 0);
                    const Image got = context().draw(program, size.width, size.height);
                    for (int y = 0; y < got.height; ++y)
                        for (int x = 0; x < got.width; ++x) {
                            const V3f want = visible_color(set, level, x, y, view, look);
                            shift[i] =
                                std::max(shift[i], (want - rgb(set.color[level], x, y)).length());
                            for (int k = 0; k < 3; ++k) {
                                const double error =
                                    std::abs(static_cast<double>(got.at(x, y, k)) - want[k]);
                                worst = std::max(worst, error);
                                EXPECT_LE(error, kTolerance)
                                    << got.at(x, y, k) << " for " << want[k] << ", model "
                                    << look.color_model << " slope color " << look.slope_color
                                    << " map by " << set.map_by << " level " << level << " texel "
                                    << x << ',' << y << " channel " << k << " view " << view;
                                if (HasFailure())
                                    return worst;
                            }
                        }
                }
        for (size_t i = 0; i < looks.size(); ++i) {
            const bool differs = looks[i].color_model > 0 || looks[i].slope_color;
            EXPECT_GE(shift[i], differs ? 0.02F : 0)
                << "a set that shows nothing of model " << looks[i].color_model;
        }
        return worst;
    }
};

TEST_P(GlslColor, ByHeightRankAndSlopeIsThatOfTheCppFront)
{
    for (const std::string kind : {"bricks", "fractal"}) {
        SampleSet set = bake_sample(kind, 60, 45);
        set.exponent = exponent_levels(60, 45);
        std::vector<ColorLook> looks;
        for (const int model : {0, 1, 2, 5})
            for (const bool slope_color : {false, true})
                looks.push_back({model, slope_color});
        RecordProperty("worst " + kind, fmt::format("{:.1e}", worst_difference(set, looks)));
    }
}

TEST_P(GlslColor, OfAColorMapIsThatOfTheCppFront)
{
    for (const MapBy by : {MapBy::height, MapBy::slope, MapBy::slope_magnitude}) {
        const SampleSet set = bake_sample("fractal", 60, 45, by);
        std::vector<ColorLook> looks = {{3, false}};
        if (by == MapBy::height)
            looks.push_back({3, true});
        RecordProperty("worst by " + map_by_name(by),
                       fmt::format("{:.1e}", worst_difference(set, looks)));
    }
}

INSTANTIATE_TEST_SUITE_P(Set, GlslColor, both_dialects(), dialect_name);

} // namespace
} // namespace scree::test
