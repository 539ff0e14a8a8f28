// Draws docs/linear-light-failures.svg: where the ways to reflect a linear light fail.
//
//   scree_linear_light_map docs/linear-light-failures.svg
//
// Over all normals that face the viewer, the error of what is reflected relative to adaptive
// quadrature of the full integral. The light is as long as lights can be, parallel to the surface
// and facing it: all of it is above the horizon, whatever the normal, and no end of it matters.
// Left halves: the Gaussian; right halves: eight points about the peak. The light's plane makes
// both halves alike.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figures/drawing.h"
#include "kernel/linear_scenes.h"

namespace scree::test {
namespace {

using Imath::V3d;
using report::Spot;

constexpr int kCells = 180; // across a disk, even
constexpr double kCell = 1, kDisk = kCells * kCell, kGap = 24, kLeft = 108, kTop = 60;
constexpr double kDark = 1e-4; // of the brightest: what is darker is not judged

const std::vector<ColorStep>& colors()
{
    static const std::vector<ColorStep> all = {
        {"#0b5d3b", 0.003, "< 0.3 %"}, {"#2f9e5b", 0.01, "< 1 %"}, {"#a5d96a", 0.03, "< 3 %"},
        {"#ffe08a", 0.1, "< 10 %"},    {"#f68d4b", 0.3, "< 30 %"}, {"#c4262e", 1, "< 100 %"},
        {"#000000", 0, "more"}};
    return all;
}
constexpr const char* kDarkFill = "#d4d8dc";
constexpr const char* kJumpLook = "stroke=\"#2447d8\" stroke-width=\"2\"";

/// The disk of normals by Lambert's equal-area projection: the viewer's direction is its centre, 90
/// degrees from it the rim; upwards is towards w, the normal of the plane of light and point.
struct Disk {
    V3d viewer, right, up;

    explicit Disk(double cos_v)
        : viewer(std::sqrt(1 - cos_v * cos_v), 0, cos_v), right(0, 1, 0), up(viewer.cross(right))
    {}
    /// x, y  from the centre, in radii
    [[nodiscard]] V3d normal(double x, double y) const
    {
        const double rr = x * x + y * y;
        return viewer * (1 - rr) + (right * x + up * y) * std::sqrt(2 - rr);
    }
    /// Where that normal is drawn, in radii.
    [[nodiscard]] Spot spot(const V3d& normal) const
    {
        const double scale = 1 / std::sqrt(1 + normal.dot(viewer));
        return {normal.dot(right) * scale, normal.dot(up) * scale};
    }
};

struct Cell {
    double reflected = 0, gaussian_error = 0, points_error = 0;
};

Cell cell_of(const LinearScene& scene)
{
    const auto view = view_of<double>(scene);
    const auto peak = filter::linear_peak(view.viewer, view.normal, 8);
    const double full = reflected_exactly(scene);
    auto error = [full](double got) { return std::abs(got - full) / full; };
    return {full, error(filter::linear_reflection(view, peak, scene.sigma2)),
            error(filter::linear_quadrature(view, peak, scene.sigma2, 2))};
}

/// The right half of a disk, row 0 uppermost; what is beyond the rim reflects nothing.
std::vector<Cell> cells_of(const Disk& disk, double sigma2)
{
    std::vector<Cell> cells;
    for (int row = 0; row < kCells; ++row)
        for (int column = kCells / 2; column < kCells; ++column) {
            const double x = (2 * column + 1.0) / kCells - 1, y = 1 - (2 * row + 1.0) / kCells;
            const bool inside = std::hypot(x, y) < 1;
            cells.push_back(inside ? cell_of(endless_light(disk.viewer, disk.normal(x, y), sigma2))
                                   : Cell());
        }
    return cells;
}

/// Where Phi jumps: the normals between the cone's foci in its plane of symmetry.
std::string jump(const Disk& disk, const Spot& centre)
{
    const double q = disk.viewer.z;
    const double focus = std::atan2(1 - q, 2 * std::sqrt(q));
    const V3d a = (disk.viewer + V3d(0, 0, 1)).normalized();
    std::string path;
    for (int i = -20; i <= 20; ++i) {
        const double along = focus * i / 20;
        const Spot at = disk.spot(a * std::cos(along) + disk.right * std::sin(along));
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L',
                            centre.x + at.x * kDisk / 2, centre.y - at.y * kDisk / 2);
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", path, kJumpLook);
}

/// Prints the share of all light, reflected by all normals alike, whose error is above 10 %.
void print_bad_share(double cos_v, double sigma2, const std::vector<Cell>& cells)
{
    double all = 0, gaussian = 0, points = 0;
    for (const Cell& cell : cells) {
        all += cell.reflected;
        gaussian += cell.gaussian_error > 0.1 ? cell.reflected : 0;
        points += cell.points_error > 0.1 ? cell.reflected : 0;
    }
    fmt::print("cos theta_v {:4} sigma^2 {:5}: more than 10 % off {:5.1f} % of the light by the "
               "Gaussian, {:4.1f} % by eight points\n",
               cos_v, sigma2, 100 * gaussian / all, 100 * points / all);
}

/// Marks w.
std::string ring(const Spot& centre)
{
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"#ffffff\" "
                       "stroke=\"#1c1f23\"/>\n",
                       centre.x, centre.y);
}

std::string panel(double cos_v, double sigma2, const Spot& corner)
{
    const Disk disk(cos_v);
    const auto cells = cells_of(disk, sigma2);
    print_bad_share(cos_v, sigma2, cells);
    const double brightest =
        std::max_element(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
            return a.reflected < b.reflected;
        })->reflected;
    auto color = [&](int column, int row) -> std::string {
        const bool left = column < kCells / 2;
        const int from_middle = left ? kCells / 2 - 1 - column : column - kCells / 2;
        const Cell& cell =
            cells[static_cast<size_t>(row) * (kCells / 2) + static_cast<size_t>(from_middle)];
        if (!(cell.reflected > kDark * brightest))
            return "";
        return colors()[step_of(colors(), left ? cell.gaussian_error : cell.points_error)].fill;
    };
    const Spot centre{corner.x + kDisk / 2, corner.y + kDisk / 2};
    auto circle = [&](const char* look) {
        return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", centre.x, centre.y,
                           kDisk / 2, look);
    };
    const Spot w = disk.spot(V3d(0, 0, 1));
    return circle(fmt::format("fill=\"{}\"", kDarkFill).c_str()) +
           cell_map(corner, kCell, kCell, kCells, kCells, color) +
           report::svg_line({centre.x, corner.y}, {centre.x, corner.y + kDisk},
                            "stroke=\"#ffffff\"") +
           circle("fill=\"none\" stroke=\"#8a939c\"") + jump(disk, centre) +
           ring({centre.x + w.x * kDisk / 2, centre.y - w.y * kDisk / 2});
}

/// What the colors and marks mean, in three rows.
std::string key(double top)
{
    constexpr double kLine = 22;
    const double second = top + kLine, middle = second + 7, third = second + kLine + 12;
    return color_key({20, top}, 84, colors()) +
           color_key({20, second}, 0, {{kDarkFill, 0, "below 1e-4 of the brightest"}}) +
           report::svg_line({230, middle}, {246, middle}, kJumpLook) +
           report::svg_text({254, second + 12}, "where Phi jumps", "") + ring({382, middle}) +
           report::svg_text({394, second + 12}, "w, across the plane of light and point", "") +
           report::svg_text({20, third},
                            "A place in a disk is the normal of the surface: facing the viewer at "
                            "the centre, seen edge-on at the rim.",
                            "");
}

std::string draw()
{
    constexpr std::array<double, 3> kViewers = {0.7, 0.3, 0.05}, kSigma2 = {0.002, 0.02, 0.3};
    const double width = kLeft + 3 * (kDisk + kGap);
    const double bottom = kTop + 3 * (kDisk + kGap);
    std::string svg;
    for (size_t column = 0; column < kViewers.size(); ++column) {
        const double left = kLeft + static_cast<double>(column) * (kDisk + kGap);
        svg +=
            centred_text({left + kDisk / 2, 20}, fmt::format("cos theta_v = {}", kViewers[column]),
                         "font-weight=\"bold\"") +
            centred_text({left + kDisk / 4, kTop - 14}, "Gaussian") +
            centred_text({left + kDisk * 3 / 4, kTop - 14}, "8 points");
        for (size_t row = 0; row < kSigma2.size(); ++row)
            svg += panel(kViewers[column], kSigma2[row],
                         {left, kTop + static_cast<double>(row) * (kDisk + kGap)});
    }
    for (size_t row = 0; row < kSigma2.size(); ++row)
        svg += report::svg_lines({8, kTop + static_cast<double>(row) * (kDisk + kGap) + kDisk / 2},
                                 16, {"sigma^2 =", fmt::format("{}", kSigma2[row])},
                                 "font-weight=\"bold\"");
    return drawing(width, bottom + 70, svg + key(bottom));
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::draw_to_file(argc, argv, scree::test::draw); }
