#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "color/visible_color.h"
#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/plain_code.h"
#include "failures/seen.h"
#include "failures/surfaces.h"
#include "figures/uniform.h"

namespace scree::test {
namespace {

std::string lambda_words(double exponent)
{
    const std::string words = std::to_string(exponent);
    return "Lambda = " + words.substr(0, words.find_last_not_of("0.") + 1);
}

/// Texels under one of a level, by rising height; sizes powers of two.
std::vector<HeightColor> steps_under(const MemorySource& map, int level, int x, int y)
{
    const int size = 1 << level;
    std::vector<std::pair<double, double>> texels;
    for (int v = y * size; v < (y + 1) * size; ++v)
        for (int u = x * size; u < (x + 1) * size; ++u) {
            const auto i = index_of(map, u, v);
            texels.emplace_back(map.heights[i], map.colors[i][0]);
        }
    return by_rising_height(std::move(texels));
}

/// The same of a whole square map.
std::vector<HeightColor> steps_of(const MemorySource& map)
{
    const int level = static_cast<int>(std::lround(std::log2(map.map_width)));
    return steps_under(map, level, 0, 0);
}

// --- 9 -------------------------------------------------------------------------------------------

constexpr double kJoint = 0.1, kBrick = 0.7; // red

/// Bricks of height 1 over joints of height 0, 3 texels wide, every 16.
MemorySource wall()
{
    const auto is_joint = [](int x, int y) {
        return y % 16 < 3 || (x + (y / 16 % 2) * 8) % 16 < 3;
    };
    return painted(heights_of(64, 64, [&](int x, int y) { return is_joint(x, y) ? 0.0 : 1.0; }),
                   [](int, int, double h) { return h > 0.5 ? kBrick : kJoint; });
}

/// The visible color of Gaussian heights of the same mean and variance, the color a step halfway.
double gaussian_color(double share_of_bricks, double exponent)
{
    const ColorMap map({{0.5, {kJoint, 0, 0}}, {0.5, {kBrick, 0, 0}}});
    const double deviation = std::sqrt(share_of_bricks * (1 - share_of_bricks));
    return visible_color(map, share_of_bricks, deviation, exponent)[0];
}

/// A view of a map, and how far the tables may be off.
struct TableView {
    double angle, azimuth, bound;
    std::string words; ///< where it comes from
};

double red_by_smith(const SetTexel& texel, const Vec3f& wo)
{
    return red_by_rank(texel, lambda_of(slopes_of(texel), wo));
}

/// What another model makes of a texel and a view.
struct OtherModel {
    std::string name;
    double (*red)(const SetTexel& texel, const Vec3f& wo);
};

/// What the tables of a set's visibility say, beside another model.
void add_tables(const std::string& what, const MemorySource& map, const OtherModel& other,
                const std::vector<TableView>& views, Measured& all)
{
    BakedSet set = baked(map, table_options());
    const SetTexel without_tables = baked(map, plain_options()).top();
    const auto surface = displaced(map);
    for (const TableView& view : views) {
        const Vec3f wo = toward(view.angle, view.azimuth);
        all.figures.push_back(Figure(what + ", tables of visibility: visible color at " +
                                         degrees(view.angle) + view.words,
                                     seen_of_map(surface, view.angle, view.azimuth).color[0])
                                  .peer(other.name, other.red(without_tables, wo))
                                  .ours(red_by_tables(set, set.top(), wo))
                                  .bound(view.bound)
                                  .aside());
    }
}

Measured few_heights()
{
    const std::vector<HeightColor> steps = steps_of(wall());
    const SetTexel top = baked(wall(), plain_options()).top();
    Measured all;
    const auto add = [&](const std::string& model, double exponent, double ours, double bound,
                         const std::string& way, double peer) {
        all.figures.push_back(Figure(model + ": visible color, " + lambda_words(exponent),
                                     color_by_definition(steps, exponent))
                                  .peer(way, peer)
                                  .ours(ours)
                                  .bound(bound));
    };
    const std::string gaussian = "Gaussian heights, Heitz 2013";
    const double share = steps.back().share;
    for (const double exponent : {1.0, 0.3, 3.0}) {
        const double ours = red_by_rank(top, exponent);
        add("rank table", exponent, ours, 0.001, gaussian, gaussian_color(share, exponent));
        add("rank table", exponent, ours, 0.001, "P(<= h)^Lambda",
            color_at_or_below(steps, exponent));
        add("rank table", exponent, ours, 0.001, "P(< h)^Lambda", color_below(steps, exponent));
    }
    for (const auto& [exponent, bound] : {std::pair(1.0, 0.042), {0.3, 0.016}, {3.0, 0.15}})
        add("linear in height", exponent, red_by_height(top, exponent), bound, gaussian,
            gaussian_color(share, exponent));
    add_tables("wall", wall(), {"rank table, Smith", red_by_smith},
               {{60, 30, 0.006, ""}, {80, 30, 0.03, ""}}, all);
    add_words(all, flags_of("the wall", wall()));
    return all;
}

// --- 10 ------------------------------------------------------------------------------------------

/// The color map that heights and colors of a map make: mean red of 64 ranges of height.
ColorMap map_of_means(const MemorySource& surface)
{
    constexpr size_t kRanges = 64;
    const auto [low, high] = std::minmax_element(surface.heights.begin(), surface.heights.end());
    const double width = (*high - *low) / kRanges;
    std::array<double, kRanges> sum{}, count{};
    for (size_t i = 0; i < surface.heights.size(); ++i) {
        const auto range = static_cast<size_t>((surface.heights[i] - *low) / width);
        sum[std::min(range, kRanges - 1)] += surface.colors[i][0];
        ++count[std::min(range, kRanges - 1)];
    }
    std::vector<Knot> knots;
    for (size_t range = 0; range < kRanges; ++range)
        if (count[range] > 0)
            knots.push_back({*low + (static_cast<double>(range) + 0.5) * width,
                             {sum[range] / count[range], 0, 0}});
    return ColorMap(std::move(knots));
}

/// RMS over the texels of level 2 of what `shown` differs by from the color seen.
double rms_error(const MemorySource& map, BakedSet& set, double exponent,
                 double (*shown)(const SetTexel&, double))
{
    constexpr int kLevel = 2;
    double squares = 0;
    for (int y = 0; y < set.height(kLevel); ++y)
        for (int x = 0; x < set.width(kLevel); ++x) {
            const double error = shown(set.texel(kLevel, x, y), exponent) -
                                 color_by_definition(steps_under(map, kLevel, x, y), exponent);
            squares += error * error;
        }
    return std::sqrt(squares / (set.width(kLevel) * set.height(kLevel)));
}

double red_by_mean(const SetTexel& texel, double /*exponent*/)
{
    return static_cast<double>(texel.color[0]);
}

Measured unrelated_color()
{
    std::mt19937 random(3);
    const MemorySource shuffled =
        painted(sample("fractal", 128), [&](int, int, double) { return uniform(random); });
    BakedSet set = baked(shuffled, plain_options());
    const ColorMap map = map_of_means(shuffled);
    Measured all;
    for (const double exponent : {1.0, 5.0}) {
        const double truth = color_by_definition(steps_of(shuffled), exponent);
        const double peer = visible_color(map, set.manifest().h0, set.manifest().h1, exponent)[0];
        const std::string what = "whole map: visible color, " + lambda_words(exponent);
        all.figures.push_back(Figure(what + ", rank table", truth)
                                  .peer("Gaussian heights, Heitz 2013", peer)
                                  .ours(red_by_rank(set.top(), exponent))
                                  .bound(0.001));
        all.figures.push_back(Figure(what + ", linear in height", truth)
                                  .peer("Gaussian heights, Heitz 2013", peer)
                                  .ours(red_by_height(set.top(), exponent))
                                  .bound(0.008));
    }
    const double mean = mean_red(shuffled), by_mean = rms_error(shuffled, set, 1, red_by_mean);
    const std::string what = "footprints of 4x4 texels: RMS error of the color, Lambda = 1";
    all.figures.push_back(Figure(what + ", rank table", 0)
                              .peer("mean color", by_mean)
                              .ours(rms_error(shuffled, set, 1, red_by_rank))
                              .relative_to(mean, "the mean color")
                              .bound(0.001));
    all.figures.push_back(Figure(what + ", linear in height", 0)
                              .peer("mean color", by_mean)
                              .ours(rms_error(shuffled, set, 1, red_by_height))
                              .relative_to(mean, "the mean color")
                              .bound(0.025));
    return all;
}

// --- 11 ------------------------------------------------------------------------------------------

/// Waves of 8 to 32 texels and RMS slope 0.6, colored by the slope along s.
MemorySource waves_by_slope(double (*red)(double slope))
{
    const MemorySource waves = scaled_to_slope(gaussian_waves(128, 8, 32, 2), 0.6);
    return painted(waves,
                   [&](int x, int y, double /*h*/) { return red(slope_of_texel(waves, x, y)); });
}

double in_proportion(double slope) { return std::clamp(0.5 + 0.3 * slope, 0.0, 1.0); }
double by_its_sign(double slope) { return slope > 0 ? 0.8 : 0.2; }

struct View {
    double angle, azimuth, bound;
};

std::string from(double azimuth) { return azimuth > 0 ? " from -s" : " from +s"; }

void add_colors(const std::string& what, const MemorySource& map, const std::vector<View>& views,
                Measured& all)
{
    BakedSet set = baked(map, plain_options());
    const auto surface = displaced(map);
    const ColorMap by_height = map_of_means(map);
    for (const auto& [angle, azimuth, bound] : views) {
        const Vec3f view = toward(angle, azimuth);
        const double lambda = lambda_of(slopes_of(set.top()), view);
        const double peer =
            visible_color(by_height, set.manifest().h0, set.manifest().h1, lambda)[0];
        all.figures.push_back(Figure(what + ": visible color at " + degrees(angle) + from(azimuth),
                                     seen_of_map(surface, angle, azimuth).color[0])
                                  .peer("color by height, Heitz 2013", peer)
                                  .ours(red_by_slope(set.top(), view))
                                  .bound(bound));
    }
}

/// The two colors by the sign once more, from a color map by slope.
void add_mapped(const MemorySource& map, const std::vector<View>& views, Measured& all)
{
    const TempFolder temp;
    Image strip{1024, 1, {"R", "G", "B"}, {}}; // slopes -2 to 2
    for (int x = 0; x < strip.width; ++x)
        for (const double value : {by_its_sign(x - 511.5), 0.0, 0.0})
            strip.pixels.push_back(static_cast<float>(value));
    write_image(temp / "map.exr", strip);
    BakeOptions options = plain_options();
    options.colormap_file = temp / "map.exr";
    options.map_by = MapBy::slope;
    options.map_range = {{-2, 2}};
    MemorySource uncolored = map;
    uncolored.colors.clear();
    BakedSet set = baked(uncolored, options);
    const auto surface = displaced(map);
    for (const auto& [angle, azimuth, bound] : views)
        all.figures.push_back(
            Figure("by the sign, color map: visible color at " + degrees(angle) + from(azimuth),
                   seen_of_map(surface, angle, azimuth).color[0])
                .ours(red_by_map(set, set.top(), toward(angle, azimuth)))
                .bound(bound));
}

Measured color_by_slope()
{
    const MemorySource two_sided = waves_by_slope(by_its_sign);
    Measured all;
    add_colors("in proportion", waves_by_slope(in_proportion),
               {{75, 0, 0.017}, {75, 180, 0.008}, {60, 0, 0.01}, {60, 180, 0.005}}, all);
    add_colors("by the sign", two_sided,
               {{75, 0, 0.105}, {75, 180, 0.036}, {60, 0, 0.045}, {60, 180, 0.02}}, all);
    add_mapped(two_sided, {{75, 0, 0.02}, {75, 180, 0.004}}, all);
    std::vector<TableView> views;
    for (const auto& [angle, azimuth, bound] :
         {View{75, 0, 0.018}, {75, 180, 0.008}, {60, 0, 0.038}, {60, 180, 0.019}})
        views.push_back({angle, azimuth, bound, from(azimuth)});
    add_tables("by the sign", two_sided, {"linear in slope", red_by_slope}, views, all);
    return all;
}

} // namespace

std::vector<FailureCase> color_cases()
{
    return {
        {9, "Few heights",
         "A brick wall, 64x64: bricks of height 1 and red 0.7, joints of height 0 and red 0.1.",
         R"(Two thirds of a footprint at one height and the rest at another are no bell curve. A color map
averaged over Gaussian heights shows colors of heights that are not there. Where heights tie, the
share at or below a height and the share below it differ, and so do the formulas that use one or the
other. In Scree's rank table ties share their ranks. Its line over height (`colorheight`) takes the
mean visible height of a bell curve, and overshoots the brightest color there is. All three follow
the definition, a point of rank q seen with probability q^Lambda; what the wall itself shows from
some angle the tables of visibility tell (the last figures; two harmonics).)",
         R"(Use the rank table where heights have few values. R^2 in `scree info` does not tell: two heights
and two colors lie on a line exactly, and it is the Gaussian visible height that is wrong.
`--maps auto` does, since it compares what is seen. `--visibility tables` asks neither for ranks nor
for Lambda.)",
         few_heights},
        {10, "Color that does not follow height",
         "The fractal of `scree sample`, 128x128, with a random red in every texel.",
         R"(What has no correlation must show the mean color at every angle. In a footprint of few texels
there is always some by chance, and it is real: these texels do look like that.)",
         R"(Nothing to do. In `scree info` R^2 falls to 0 with the level. `--maps auto` keeps maps for such an
asset all the same, for the chance in small footprints; name the maps (`--maps color,slope,tail`) to
do without.)",
         unrelated_color},
        {11, "Color that follows slope",
         R"(Random waves of 8 to 32 texels, 128x128, RMS slope 0.6; red 0.5 + 0.3 times the slope
along s, or red 0.2 and 0.8 by the sign of that slope. Truth is the reference renderer.)",
         R"(Lichen on the north side, snow on the lee: such a surface looks different from the two sides,
and no model of color by height sees it. Scree bakes E[c s] (`colorslope`), which is right for
colors in proportion to slope and the first order of any other.)",
         R"(Bake `colorslope` (it is baked unless `--maps` leaves it out) and turn it on in the shader. Where
the color jumps at a slope, bake it as a color map (`--colormap FILE --map-by slope`): a line through
a jump is off by a tenth at grazing views, the map by a fiftieth, tables of visibility with two
harmonics (`--visibility tables --harmonics 2`), which need to know of no cause, by a thirtieth.)",
         color_by_slope},
    };
}

} // namespace scree::test
