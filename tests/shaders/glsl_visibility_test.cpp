// Visible color in src/shaders/scree_visible.glsl against the kernel's C++ front.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shaders/gl_fixture.h"
#include "shaders/packed_set.h"
#include "shaders/visible_tables.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

using Imath::V3f;

constexpr double kTolerance = 1e-5; // absolute, of colors in [0, 1] and their double

/// Any mean color, tables for it, and both in the context.
struct Uploaded {
    std::vector<Image> color;
    VisibleTables tables;
    GLuint color_texture, visible_texture;

    Uploaded(GlContext& context, int width, int height, const std::vector<float>& cosines,
             int harmonics)
        : tables(random_visible_tables(width, height, cosines, harmonics))
    {
        for (const Image& level : tables.levels)
            color.push_back(
                random_image(level.width, level.height, {"R", "G", "B", "A"}, 81, 0.2F, 0.9F));
        color_texture = context.texture(color, GlFilter::nearest);
        visible_texture = context.texture_array(pack(tables), GlFilter::nearest);
    }

    /// R G B as seen (and lit, where there is a light), A the area that is seen.
    Imath::V4f want(size_t level, int x, int y, const V3f& view, const V3f& light) const
    {
        const V3f c = rgb(color[level], x, y);
        const std::vector<float> values = tables.values(level, x, y);
        const auto table = tables.table(values);
        V3f seen = filter::visible_color(c, table, view);
        if (light != V3f(0))
            seen = filter::color_seen_and_lit(c, seen, filter::visible_color(c, table, light), view,
                                              light);
        return {seen.x, seen.y, seen.z, filter::visible_area(table, view)};
    }
};

class GlslVisibility : public Glsl {
protected:
    GLuint make_program(const Uploaded& set)
    {
        const GLuint program =
            context().program({"tests/shaders/screen.vert"},
                              {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                               "src/shaders/scree_visible.glsl", "tests/shaders/set_visible.frag"});
        context().bind(program, {{"color", set.color_texture}, {"visible", set.visible_texture}});
        for (size_t k = 0; k < set.tables.cosines.size(); ++k)
            context().set(program, fmt::format("nodes.cosine[{}]", k),
                          std::vector<float>{set.tables.cosines[k]});
        context().set(program, "nodes.count", static_cast<int>(set.tables.cosines.size()));
        context().set(program, "nodes.harmonics", set.tables.harmonics);
        context().set(program, "nodes.axis", {set.tables.axis_cosine, set.tables.axis_sine});
        return program;
    }

    /// Compares a level; returns the largest difference.
    double worst_difference(const Uploaded& set, GLuint program, size_t level, const V3f& view,
                            const V3f& light, bool by_derivatives)
    {
        const Image& size = set.color[level];
        context().set(program, "wo", {view.x, view.y, view.z});
        context().set(program, "wi", {light.x, light.y, light.z});
        context().set(program, "size",
                      {static_cast<float>(size.width), static_cast<float>(size.height)});
        if (!by_derivatives)
            context().set(program, "level", std::vector<float>{static_cast<float>(level)});
        context().set(program, "by_derivatives", by_derivatives ? 1 : 0);
        const Image got = context().draw(program, size.width, size.height);
        double worst = 0;
        for (int y = 0; y < got.height; ++y)
            for (int x = 0; x < got.width; ++x) {
                const Imath::V4f want = set.want(level, x, y, view, light);
                for (int k = 0; k < 4; ++k) {
                    const double error = std::abs(static_cast<double>(got.at(x, y, k)) - want[k]);
                    worst = std::max(worst, error);
                    EXPECT_LE(error, kTolerance)
                        << got.at(x, y, k) << " for " << want[k] << ", level " << level << " texel "
                        << x << ',' << y << " channel " << k << " view " << view << " light "
                        << light << ", " << set.tables.cosines.size() << " nodes, "
                        << set.tables.harmonics << " harmonics";
                    if (HasFailure())
                        return worst;
                }
            }
        return worst;
    }
};

const std::vector<float> kCosines[] = {
    {0.45F}, {0.8F, 0.3F}, {0.9F, 0.75F, 0.5F, 0.3F, 0.15F, 0.05F}};

TEST_P(GlslVisibility, OfALevelIsThatOfTheCppFront)
{
    double worst = 0;
    for (const auto& cosines : kCosines)
        for (int harmonics = -1; harmonics <= 2; ++harmonics) { // -1: along axes
            const Uploaded set(context(), 19, 12, cosines, harmonics);
            const GLuint program = make_program(set);
            for (const V3f& view : {V3f(0, 0, 1), V3f(0.5F, 0.6F, 0.7F), V3f(0.3F, -0.8F, 0.5F),
                                    V3f(-0.9F, 0.3F, 0.2F), V3f(-1, -0.5F, 0.02F)})
                for (const V3f& light : {V3f(0), V3f(-0.2F, 0.9F, 0.4F).normalized()})
                    for (const size_t level : {0U, 2U, 4U})
                        worst = std::max(worst, worst_difference(set, program, level,
                                                                 view.normalized(), light, false));
        }
    RecordProperty("worst", fmt::format("{:.1e}", worst));
}

TEST_P(GlslVisibility, ByTheHardwaresChoiceOfLevelIsThatOfTheCppFront)
{
    double worst = 0;
    const size_t level = 1;
    for (int harmonics = -1; harmonics <= 2; ++harmonics) {
        const Uploaded set(context(), 32, 24, kCosines[2], harmonics);
        for (const GLuint texture : {set.color_texture, set.visible_texture})
            context().show_level(texture, level);
        const GLuint program = make_program(set);
        for (const V3f& view : {V3f(0.1F, 0.2F, 0.9F), V3f(-0.9F, 0.3F, 0.5F)})
            worst = std::max(worst, worst_difference(set, program, level, view.normalized(),
                                                     V3f(0.2F, 0.1F, 0.3F).normalized(), true));
    }
    RecordProperty("worst", fmt::format("{:.1e}", worst));
}

INSTANTIATE_TEST_SUITE_P(Set, GlslVisibility, both_dialects(), dialect_name);

} // namespace
} // namespace scree::test
