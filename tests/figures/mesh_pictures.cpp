// Draws docs/mesh.png and prints the figures beside it (docs/mesh.sh):
//
//   scree_mesh_pictures MESH.obj MESH_SET PLANE_SET FONT.ttf OUTPUT.png
//
// MESH_SET  the mesh's set, with heights and a color; PLANE_SET the same heights baked on a plane.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>

#include "figures/canvas.h"
#include "figures/mesh_measure.h"
#include "figures/mesh_view.h"
#include "math/error.h"
#include "surface/mesh_file.h"

namespace scree::test {
namespace {

constexpr int kPanel = 384; // pixels a side; 3 a texel of level 3 of 1024 texels
constexpr int kSamples = 3; // a pixel's side
constexpr int kLevel = 3;   // whose weight and variance are shown
constexpr Rgb kNothing = {206, 206, 206};

using Place = std::function<Rgb(const Vec2&)>;

/// color  of a place in [0, 1)^2
void draw_panel(Canvas& canvas, int left, int top, const Place& color)
{
    for (int y = 0; y < kPanel; ++y)
        for (int x = 0; x < kPanel; ++x) {
            std::array<int, 3> sum{};
            for (int i = 0; i < kSamples * kSamples; ++i) {
                const Rgb one = color({(x + (i % kSamples + 0.5) / kSamples) / kPanel,
                                       (y + (i / kSamples + 0.5) / kSamples) / kPanel});
                for (size_t c = 0; c < 3; ++c)
                    sum[c] += one[c];
            }
            Rgb mean{};
            for (size_t c = 0; c < 3; ++c)
                mean[c] = static_cast<uint8_t>(sum[c] / (kSamples * kSamples));
            canvas.put(left + x, top + y, mean);
        }
}

/// A logarithmic scale of colors; values beyond its ends have the ends' colors.
struct Scale {
    double low = 1, high = 10;
    std::vector<double> ticks;

    [[nodiscard]] double part(double value) const
    {
        return std::log(value / low) / std::log(high / low);
    }
    [[nodiscard]] Rgb color(double value) const { return scale_color(part(value)); }
};

void draw_scale(Canvas& canvas, int left, int top, const Scale& scale)
{
    constexpr int kHigh = 12;
    for (int x = 0; x < kPanel; ++x)
        canvas.fill(left + x, top, 1, kHigh, scale_color((x + 0.5) / kPanel));
    for (const double tick : scale.ticks) {
        const int x = static_cast<int>(std::lround(scale.part(tick) * (kPanel - 1)));
        canvas.fill(left + x, top + kHigh, 1, 4, {60, 60, 60});
        const auto align = x < 12            ? Canvas::Align::left
                           : x > kPanel - 12 ? Canvas::Align::right
                                             : Canvas::Align::centre;
        canvas.words(left + x, top + kHigh + 20, 15, align, fmt::format("{:g}", tick));
    }
}

/// The surface as a diffuse one in a light from the upper left, its normals those of the slopes.
Place seen_surface(const LimitSurface& surface, const MeshAndPlane& sets)
{
    constexpr int kSize = kPanel * kSamples;
    auto view = view_of_surface(surface, kSize, {-0.75, 0.3, -1});
    return [view = std::move(view), color = sets.level(true, Map::color, 0),
            slope = sets.level(true, Map::slope, 0)](const Vec2& at) -> Rgb {
        const auto pixel = [](double along) { return static_cast<size_t>(along * kSize); };
        const SeenPoint& point = view[pixel(at.y) * kSize + pixel(at.x)];
        if (!std::isfinite(point.depth))
            return {255, 255, 255};
        const double s = slope.at(point.place, slope.channel("s"));
        const double t = slope.at(point.place, slope.channel("t"));
        const Vec3 normal = (point.normal - point.x * s - point.y * t).normalized();
        const Vec3 light = Vec3(-0.2, 0.9, -0.75).normalized();
        const double shade = 0.12 + 0.88 * std::max(0.0, normal ^ light);
        return srgb(shade * color.at(point.place, color.channel("R")),
                    shade * color.at(point.place, color.channel("G")),
                    shade * color.at(point.place, color.channel("B")));
    };
}

struct Panel {
    std::string title;
    Place color;
    Scale scale; ///< no ticks: none is drawn
};

std::vector<Panel> panels(const LimitSurface& surface, const MeshAndPlane& sets)
{
    const auto metric = std::make_shared<MetricGrid>(metric_grid(surface, kPanel * kSamples));
    const auto of_metric = [metric](const Scale& scale, double (*measure)(const TexelMetric&)) {
        return [metric, scale, measure](const Vec2& at) {
            const TexelMetric& texel = metric->at(at);
            return texel.area > 0 ? scale.color(measure(texel)) : kNothing;
        };
    };
    const Scale lengths{0.5, 8, {0.5, 1, 2, 4, 8}};
    const Scale ratios{1, 5, {1, 1.5, 2, 3, 5}};
    const Scale weights{0.0005, 0.1, {0.001, 0.01, 0.1}};
    const Scale variances{0.01, 3, {0.01, 0.03, 0.1, 0.3, 1}};
    const auto weight = [weights,
                         coverage = sets.level(true, Map::coverage, kLevel)](const Vec2& at) {
        const double w = coverage.at(at, coverage.channel("w"));
        return w > 0 ? weights.color(w) : kNothing;
    };
    const auto variance = [&](bool on_mesh) {
        return [variances, slope = sets.level(on_mesh, Map::slope, kLevel),
                coverage = sets.level(true, Map::coverage, kLevel)](const Vec2& at) {
            return coverage.at(at, coverage.channel("w")) > 0
                       ? variances.color(slope_variance(slope, at))
                       : kNothing;
        };
    };
    return {{"a  The surface, shaded with the baked slopes", seen_surface(surface, sets), {}},
            {"b  World units a texture unit", of_metric(lengths, unit_length), lengths},
            {"c  Anisotropy of the metric", of_metric(ratios, anisotropy), ratios},
            {"d  Weight as baked, level 3", weight, weights},
            {"e  Slope variance on the mesh, level 3", variance(true), variances},
            {"f  Slope variance on a plane, level 3", variance(false), variances}};
}

void draw(const std::vector<Panel>& all, const std::string& font, const std::string& file)
{
    constexpr int kColumns = 3, kMargin = 10, kGap = 24, kTitle = 30, kKey = 54;
    constexpr int kRow = kTitle + kPanel + kKey;
    const int rows = static_cast<int>(all.size()) / kColumns;
    Canvas canvas(2 * kMargin + kColumns * kPanel + (kColumns - 1) * kGap, rows * kRow + kMargin,
                  font);
    for (size_t i = 0; i < all.size(); ++i) {
        const int left = kMargin + static_cast<int>(i % kColumns) * (kPanel + kGap);
        const int top = static_cast<int>(i / kColumns) * kRow + kTitle;
        canvas.words(left, top - 10, 17, Canvas::Align::left, all[i].title);
        draw_panel(canvas, left, top, all[i].color);
        if (!all[i].scale.ticks.empty())
            draw_scale(canvas, left, top + kPanel + 8, all[i].scale);
    }
    canvas.write(file);
}

void run(char** words)
{
    const MeshFile file = read_mesh(words[1]);
    const LimitSurface surface(file.mesh, {});
    const MeshAndPlane sets(words[2], words[3]);
    const MetricGrid grid = metric_grid(surface, sets.of_mesh.width);
    print_metric(grid, sets);
    print_spread(sets);
    print_ratios(grid, sets, kLevel);
    draw(panels(surface, sets), words[4], words[5]);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv)
{
    if (argc != 6) {
        fmt::print(stderr, "usage: {} MESH.obj MESH_SET PLANE_SET FONT.ttf OUTPUT.png\n", argv[0]);
        return 2;
    }
    try {
        scree::test::run(argv);
    } catch (const scree::Error& error) {
        fmt::print(stderr, "{}: error: {}\n", argv[0], error.what());
        return 1;
    }
    return 0;
}
