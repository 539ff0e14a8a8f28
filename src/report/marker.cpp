#include "report/marker.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "report/numbers.h"

namespace scree::report {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kShapes = 8;

/// Corners of a regular polygon (or star: every other corner at the inner radius), turned by a
/// number of degrees from upwards.
struct Polygon {
    int corners;
    double radius, inner, turn_deg;
};

// Sizes make the areas look alike. Shape 0, the circle, is not a polygon.
constexpr std::array<Polygon, kShapes> kPolygons = {{{0, 4.6, 0, 0},
                                                     {4, 5.6, 5.6, 45},
                                                     {3, 5.9, 5.9, 0},
                                                     {4, 5.9, 5.9, 0},
                                                     {3, 5.9, 5.9, 180},
                                                     {10, 6.4, 2.9, 0},
                                                     {8, 6.2, 2.6, 0},
                                                     {6, 5.4, 5.4, 30}}};

std::string points_of(const Polygon& polygon, const Spot& at)
{
    std::string points;
    for (int i = 0; i < polygon.corners; ++i) {
        const double angle = (polygon.turn_deg + 360.0 * i / polygon.corners) * kPi / 180;
        const double radius = i % 2 == 0 ? polygon.radius : polygon.inner;
        points +=
            fmt::format("{}{},{}", i == 0 ? "" : " ", coordinate(at.x + radius * std::sin(angle)),
                        coordinate(at.y - radius * std::cos(angle)));
    }
    return points;
}

} // namespace

Look look_of(int series)
{
    constexpr std::array<const char*, 7> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                    "#000000", "#e69f00", "#56b4e9"};
    constexpr std::array<const char*, 4> kDashes = {"", "7 3", "2 3", "9 3 2 3"};
    const auto index = static_cast<size_t>(series);
    return {kColors[index % kColors.size()], series % kShapes, kDashes[index % kDashes.size()]};
}

std::string marker(const Look& look, const Spot& at, bool is_full)
{
    const std::string paint =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\" stroke-linejoin=\"round\"/>",
                    is_full ? look.color : "#ffffff", look.color);
    const Polygon& polygon = kPolygons[static_cast<size_t>(look.shape)];
    if (polygon.corners == 0)
        return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}", coordinate(at.x),
                           coordinate(at.y), coordinate(polygon.radius), paint);
    return fmt::format("<polygon points=\"{}\" {}", points_of(polygon, at), paint);
}

std::string line_paint(const Look& look, bool is_dashed)
{
    const std::string dash =
        is_dashed && !look.dash.empty() ? fmt::format(" stroke-dasharray=\"{}\"", look.dash) : "";
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}", look.color, dash);
}

} // namespace scree::report
