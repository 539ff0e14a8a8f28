#include <algorithm>
#include <cmath>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/seen.h"
#include "failures/surfaces.h"

namespace scree::test {
namespace {

// --- 12 ------------------------------------------------------------------------------------------

/// Fine grain on gentle hills, light on the hills and dark in the valleys: what hides is small,
/// what is colored is large.
MemorySource grain_on_hills()
{
    const MemorySource hills = scaled_to_slope(gaussian_waves(256, 64, 128, 3), 0.15);
    const MemorySource grain = scaled_to_slope(gaussian_waves(256, 6, 10, 4), 0.6);
    const auto height = [](const MemorySource& map, int x, int y) {
        return map.heights[index_of(map, x, y)];
    };
    return painted(
        heights_of(256, 256,
                   [&](int x, int y) { return height(hills, x, y) + height(grain, x, y); }),
        [&](int x, int y, double /*h*/) { return height(hills, x, y) > 0 ? 0.8 : 0.2; });
}

/// A V-groove, dark at the bottom and light on the ridge.
MemorySource shaded_groove()
{
    return painted(v_groove(64, 32, 0.5), [](int, int, double h) { return 0.1 + 0.2 * h; });
}

/// Flat, with dark V-shaped cracks along t, 8 texels wide and 4 deep, one every 64.
MemorySource cracked()
{
    return painted(
        heights_of(256, 16, [](int x, int) { return std::min(0.0, std::abs(x % 64 - 32) - 4.0); }),
        [](int, int, double h) { return h < 0 ? 0.1 : 0.6; });
}

struct View {
    std::string words;
    double angle, azimuth, bound, table_bound;
};

void add_colors(const std::string& what, const MemorySource& map, const std::vector<View>& views,
                Measured& all)
{
    const SetTexel top = baked(map, plain_options()).top();
    BakedSet with_tables = baked(map, table_options());
    const auto surface = displaced(map);
    for (const View& view : views) {
        const Vec3f wo = toward(view.angle, view.azimuth);
        const double truth = seen_of_map(surface, view.angle, view.azimuth).color[0];
        const std::string words = what + view.words + ": visible color at " + degrees(view.angle);
        all.figures.push_back(Figure(words, truth)
                                  .peer("mean color", mean_red(map))
                                  .ours(red_by_rank(top, lambda_of(slopes_of(top), wo)))
                                  .bound(view.bound));
        all.figures.push_back(Figure(words + ", tables of visibility", truth)
                                  .ours(red_by_tables(with_tables, with_tables.top(), wo))
                                  .bound(view.table_bound)
                                  .aside());
    }
    add_words(all, flags_of("the " + what, map));
}

Measured correlated_heights()
{
    Measured all;
    add_colors("groove", shaded_groove(),
               {{" seen across", 80, 0, 0.13, 0.03},
                {" seen across", 60, 0, 0.022, 0.035},
                {" seen diagonally", 80, 45, 0.11, 0.1},
                {" seen along", 80, 90, 0.001, 0.0095}},
               all);
    add_colors("grain on hills", grain_on_hills(),
               {{"", 80, 0, 0.145, 0.012}, {"", 60, 0, 0.013, 0.003}}, all);
    add_colors("cracks", cracked(), {{"", 80, 0, 0.022, 0.0025}}, all);
    add_colors("bricks", scaled_to_slope(sample("bricks", 256), 0.3), {{"", 80, 0, 0.003, 0.006}},
               all);
    add_colors("fractal", scaled_to_slope(sample("fractal", 256), 0.6),
               {{"", 80, 0, 0.01, 0.002}, {"", 60, 0, 0.03, 0.005}}, all);
    return all;
}

// --- 13 ------------------------------------------------------------------------------------------

/// RMS errors over the texels of a level.
struct LevelErrors {
    double area = 0, flat_area = 0;   ///< of the projected area seen, over that of the plane
    double color = 0, mean_color = 0; ///< of its color, weighted with that area
};

LevelErrors level_errors(BakedSet& set, const reference::DisplacedSurface& surface, int level,
                         double angle, double azimuth)
{
    const Vec3f view = toward(angle, azimuth);
    const auto squared = [](double x) { return x * x; };
    LevelErrors sums;
    double weight = 0;
    const auto texels = seen_of_level(surface, level, angle, azimuth);
    for (const SeenTexel& at : texels) {
        const SetTexel& texel = set.texel(level, at.x, at.y);
        const auto slopes = slopes_of(texel);
        const double facing = static_cast<double>(filter::projected_area(view, slopes) / view.z);
        const double truth = at.seen.area / static_cast<double>(view.z);
        sums.area += squared(facing * g1_of(slopes, view) - truth);
        sums.flat_area += squared(1 - truth);
        if (truth > 0) {
            const double red = at.seen.color[0];
            weight += truth;
            sums.color += truth * squared(red_by_rank(texel, lambda_of(slopes, view)) - red);
            sums.mean_color += truth * squared(static_cast<double>(texel.color[0]) - red);
        }
    }
    const auto count = static_cast<double>(texels.size());
    return {std::sqrt(sums.area / count), std::sqrt(sums.flat_area / count),
            std::sqrt(sums.color / weight), std::sqrt(sums.mean_color / weight)};
}

Measured large_relief()
{
    constexpr double kAngle = 75, kAzimuth = 30;
    const MemorySource map = scaled_to_slope(sample("fractal", 256), 0.6);
    BakedSet set = baked(map, plain_options());
    const auto surface = displaced(map);
    const double mean = mean_red(map);
    struct Bounds {
        int level;
        double area, color;
    };
    Measured all;
    for (const auto& [level, area_bound, color_bound] :
         {Bounds{2, 0.55, 0.08}, Bounds{4, 0.34, 0.11}, Bounds{6, 0.09, 0.11}}) {
        const LevelErrors errors = level_errors(set, surface, level, kAngle, kAzimuth);
        const std::string where = std::to_string(1 << level) + " texels: RMS error of the ";
        all.figures.push_back(Figure(where + "area seen", 0)
                                  .peer("flat plane", errors.flat_area)
                                  .ours(errors.area)
                                  .relative_to(1, "the plane's")
                                  .bound(area_bound));
        all.figures.push_back(Figure(where + "visible color", 0)
                                  .peer("mean color", errors.mean_color)
                                  .ours(errors.color)
                                  .relative_to(mean, "the mean color")
                                  .bound(color_bound));
    }
    const double reach = set.manifest().h1 * std::tan(kAngle * std::acos(-1.0) / 180);
    for (const int texels : {4, 64, 256})
        all.figures.push_back(
            Figure(std::to_string(texels) + " texels: RMS parallax, in footprints", reach / texels)
                .peer("any texture", 0)
                .ours(0)
                .relative_to(1, "a footprint")
                .bound(1.01 * reach / texels));
    return all;
}

} // namespace

std::vector<FailureCase> relief_cases()
{
    return {
        {12, "Height that goes with slope or scale",
         R"(A V-groove of slopes +-0.5, red from 0.1 at the bottom to 0.9 on the ridge, seen across,
diagonally and along; grain of 6 to 10 texels and RMS slope 0.6 on hills of 64 to 128 texels and RMS
slope 0.15, hills red 0.8 and valleys 0.2; a plain with dark cracks; bricks and fractal of `scree
sample`, scaled to RMS slopes of 0.3 and 0.6. Truth is the reference renderer.)",
         R"(Smith takes a point to be hidden by its height rank alone, whatever the slope there and whatever
its neighbours. In a groove height and slope are bound to each other, and more of the bottom is
hidden than he says. On the hills it is the grain that hides, and it hides on top of a hill as much
as in a valley; Smith takes its steepness for that of the hills and hides valleys that anyone can
see: there the plain mean color is nearer to the truth. How much is hidden in all is as right as in
cases 7 and 8; which part of it is not. Tables of visibility (here with two harmonics) know of no
ranks: they hold what was seen of the heights themselves. What they leave of the groove is that two
harmonics do not follow it round: it hides nothing along itself and much across.)",
         R"(Where the reference says so (`scree validate`), bake tables: `--visibility tables`, with
`--harmonics 2` for what has a direction. `--maps auto` finds out by itself, since it measures what
views see of the heights: it takes the tables for hills, cracks, bricks and fractal.)",
         correlated_heights},
        {13, "Large relief, small footprints",
         R"(The fractal of `scree sample`, 256x256, scaled to an RMS slope of 0.6, seen from 75 degrees, 30
degrees off the s axis; footprints of 4, 16 and 64 texels a side. Truth is the reference
renderer.)",
         R"(A texel knows what lies inside its footprint, and what hides it may stand outside: a peak hides
whole footprints behind it, which the set shows. The smaller the footprints against the relief, the
worse. Nor does a texture move with the view: what lies h above the mean plane is seen h tan(angle)
away from where the texture has it (the last figures, RMS over the map).)",
         R"(Keep the deviation of the heights times tan(angle) below a third of a footprint and the errors
stay below a tenth. What is larger belongs into the mesh, as displacement; bake what is finer.)",
         large_relief},
    };
}

} // namespace scree::test
