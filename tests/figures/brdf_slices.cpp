// Draws docs/brdf-slices.svg: three test functions in three parametrizations of a BRDF.
//
//   scree_brdf_slices docs/brdf-slices.svg
//
// Isolines of S = 1 - |h_bar|, F = 1 - cos(theta_d), G = 1 - (wi.n)(wo.n) at 0.1, 0.3 ... 0.9 on
// slices of one azimuth, after Barla, Belcour, Pacanowski 2015, fig. 2. What no two directions
// above the surface have is grey.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "figures/drawing.h"
#include "tables/brdf_grid.h"

namespace scree::test {
namespace {

using filter::Directions;
using report::Spot;

constexpr double kPanel = 150, kGap = 28, kLeft = 120, kTop = 46;
constexpr int kSteps = 24;

struct TestFunction {
    const char* color;
    const char* words;
    std::function<double(const Directions<double>&)> value;
};

const std::array<TestFunction, 3>& test_functions()
{
    static const std::array<TestFunction, 3> all = {
        {{"#c4262e", "S = 1 - |h_bar|, specular",
          [](const Directions<double>& w) { return 1 - filter::isotropic_coordinates(w).h_bar; }},
         {"#1c1f23", "F = 1 - cos theta_d, Fresnel",
          [](const Directions<double>& w) {
              return 1 - std::cos(filter::isotropic_coordinates(w).theta_d);
          }},
         {"#2166ac", "G = 1 - (wi.n)(wo.n), grazing",
          [](const Directions<double>& w) { return 1 - w.wi.z * w.wo.z; }}}};
    return all;
}

/// One slice: nodes from edge to edge of what is above the surface, and where they are drawn.
struct Slice {
    std::vector<Spot> spots;
    std::vector<Directions<double>> directions;

    [[nodiscard]] static size_t index(int a, int b)
    {
        return static_cast<size_t>(b) * (kSteps + 1) + static_cast<size_t>(a);
    }
};

/// Absolute place of the second coordinate, 0 to 1.
double second_of(BrdfParametrization parametrization, const Directions<double>& w)
{
    const auto c = filter::isotropic_coordinates(w);
    if (parametrization == BrdfParametrization::half_difference)
        return c.theta_d / std::acos(0.0);
    return parametrization == BrdfParametrization::orthographic ? c.k_bar : c.k;
}

Slice slice_of(BrdfParametrization parametrization, int azimuth, const Spot& corner)
{
    const BrdfGrid grid{parametrization, {kSteps + 1, kSteps + 1, 3}, BrdfSpacing::even, true};
    Slice slice;
    for (int b = 0; b <= kSteps; ++b)
        for (int a = 0; a <= kSteps; ++a) {
            const auto w = grid.directions(a, b, azimuth);
            slice.directions.push_back(w);
            slice.spots.push_back({corner.x + kPanel * a / kSteps,
                                   corner.y + kPanel * (1 - second_of(parametrization, w))});
        }
    return slice;
}

/// Where the function has `level` on the sides of a triangle: two spots or none.
std::vector<Spot> crossings(const std::array<Spot, 3>& at, const std::array<double, 3>& value,
                            double level)
{
    std::vector<Spot> found;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        if ((value[i] < level) == (value[j] < level))
            continue;
        const double part = (level - value[i]) / (value[j] - value[i]);
        found.push_back(
            {at[i].x + part * (at[j].x - at[i].x), at[i].y + part * (at[j].y - at[i].y)});
    }
    return found;
}

/// The isoline of a level as the data of an SVG path.
std::string isoline(const Slice& slice, const std::vector<double>& values, double level)
{
    std::string path;
    for (int b = 0; b < kSteps; ++b)
        for (int a = 0; a < kSteps; ++a) {
            const std::array<size_t, 4> of = {Slice::index(a, b), Slice::index(a + 1, b),
                                              Slice::index(a + 1, b + 1), Slice::index(a, b + 1)};
            for (const auto& [i, j, k] : {std::array<size_t, 3>{of[0], of[1], of[2]},
                                          std::array<size_t, 3>{of[0], of[2], of[3]}}) {
                const auto ends = crossings({slice.spots[i], slice.spots[j], slice.spots[k]},
                                            {values[i], values[j], values[k]}, level);
                if (ends.size() == 2)
                    path += fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}", ends[0].x, ends[0].y,
                                        ends[1].x - ends[0].x, ends[1].y - ends[0].y);
            }
        }
    return path;
}

std::string panel(BrdfParametrization parametrization, int azimuth, const Spot& corner)
{
    const Slice slice = slice_of(parametrization, azimuth, corner);
    std::string svg = filled_rectangle(corner, kPanel, kPanel, "#dfe3e7");
    std::string inside = fmt::format("M{:.1f} {:.1f}", corner.x, corner.y + kPanel);
    for (int a = 0; a <= kSteps; ++a) {
        const Spot& end = slice.spots[Slice::index(a, kSteps)];
        inside += fmt::format("L{:.1f} {:.1f}", end.x, end.y);
    }
    svg += fmt::format("<path d=\"{}L{:.1f} {:.1f}Z\" fill=\"#ffffff\" stroke=\"#8a939c\"/>\n",
                       inside, corner.x + kPanel, corner.y + kPanel);
    for (const TestFunction& function : test_functions()) {
        std::vector<double> values;
        for (const auto& w : slice.directions)
            values.push_back(function.value(w));
        std::string path;
        for (const double level : {0.1, 0.3, 0.5, 0.7, 0.9})
            path += isoline(slice, values, level);
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n",
                           path, function.color);
    }
    return svg;
}

std::string picture()
{
    const double width = kLeft + 3 * (kPanel + kGap), height = kTop + 3 * (kPanel + kGap) + 30;
    std::string svg;
    const std::array<BrdfParametrization, 3> rows = {BrdfParametrization::half_difference,
                                                     BrdfParametrization::orthographic,
                                                     BrdfParametrization::hybrid};
    const std::array<std::array<const char*, 2>, 3> axes = {
        {{"theta_h", "theta_d"}, {"|h_bar|", "|k_bar|"}, {"|h_bar|", "|k|"}}};
    for (size_t row = 0; row < rows.size(); ++row) {
        const double top = kTop + static_cast<double>(row) * (kPanel + kGap);
        svg += report::svg_lines({8, top + 60}, 16,
                                 {name_of(rows[row]), std::string("right: ") + axes[row][0],
                                  std::string("up: ") + axes[row][1]},
                                 "");
        for (int azimuth = 0; azimuth < 3; ++azimuth)
            svg += panel(rows[row], azimuth, {kLeft + azimuth * (kPanel + kGap), top});
    }
    for (int azimuth = 0; azimuth < 3; ++azimuth)
        svg += centred_text({kLeft + azimuth * (kPanel + kGap) + kPanel / 2, kTop - 8},
                            fmt::format("{} degrees", 45 * azimuth));
    double x = 20;
    for (const TestFunction& function : test_functions()) {
        svg += report::svg_text({x, height - 16}, function.words,
                                fmt::format("fill=\"{}\"", function.color));
        x += 205;
    }
    return drawing(width, height, svg);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv)
{
    return scree::test::draw_to_file(argc, argv, scree::test::picture);
}
