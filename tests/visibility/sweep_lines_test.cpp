// What the lines of a sweep see, against every node of their profiles held against every other; and
// what does not depend on how a map is cut and turned.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "visibility/line_oracle.h"
#include "visibility/swept.h"

namespace scree {
namespace {

using test::around;
using test::heights_of;
using test::index_of;
using test::kLineOffset;
using test::mean_of;
using test::radians;
using test::rough_heights;
using test::shape_of;
using test::swept;
using test::whole_block;

const std::vector<double> kThetas = {20, 45, 60, 75, 83};

/// Not less than what rounds the sweep's floats: a height, in drops, to 2^-24 of itself, up to six
/// of them a texel. The highest: range 2 over a drop of cot 83 is 16; so 8 * 2^-24 * 16.
constexpr double kRounding = 8e-6;

long double height_at(const MemoryHeights& grid, int x, int y)
{
    float h;
    grid.read(0, x, y, 1, 1, &h);
    return static_cast<long double>(h);
}

/// The bilinear surface.
long double surface(const MemoryHeights& grid, double s, double t)
{
    const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
    const long double u = static_cast<long double>(s - x), v = static_cast<long double>(t - y);
    return (1 - v) * ((1 - u) * height_at(grid, x, y) + u * height_at(grid, x + 1, y)) +
           v * ((1 - u) * height_at(grid, x, y + 1) + u * height_at(grid, x + 1, y + 1));
}

/// A line over a map: it goes through place p, a texel of the axis that is crossed faster, at
/// position first + slope p of the other; away from the viewer on the side of `away`.
struct Line {
    bool along_s;
    int away;
    double first, slope;
    double length; ///< from place to place, world units

    [[nodiscard]] double position(double place) const { return first + slope * place; }
};

/// Places [low, high] where a line crosses rows and columns of texel centres and edges, in order
/// away from the viewer.
std::vector<double> crossings(const Line& line, double low, double high)
{
    std::vector<double> places;
    const auto halves = [](double from, double to, const auto& add) {
        const int last = static_cast<int>(std::floor(2 * to));
        for (int half = static_cast<int>(std::ceil(2 * from)); half <= last; ++half)
            add(0.5 * half);
    };
    halves(low, high, [&](double row) { places.push_back(row); });
    const auto [a, b] = std::minmax({line.position(low), line.position(high)});
    halves(a, b, [&](double column) { places.push_back((column - line.first) / line.slope); });
    std::sort(places.begin(), places.end(),
              [&](double p, double q) { return p * line.away < q * line.away; });
    return places;
}

/// What a line sees in a texel, over the length of a step.
long double seen_by_line(const MemoryHeights& grid, const Line& line, int place, int texel,
                         double cotangent)
{
    const double range = grid.shape().highest - grid.shape().lowest;
    const double reach = std::ceil(range / cotangent / line.length) + 1.5;
    const std::vector<double> places = crossings(line, line.away > 0 ? place - reach : place - 0.5,
                                                 line.away > 0 ? place + 0.5 : place + reach);
    std::vector<test::ProfileNode> nodes;
    nodes.reserve(places.size());
    for (const double p : places)
        nodes.push_back({static_cast<long double>(p * line.away * line.length),
                         line.along_s ? surface(grid, p, line.position(p))
                                      : surface(grid, line.position(p), p)});
    long double seen = 0;
    for (size_t i = 1; i < nodes.size(); ++i) {
        const double middle = (places[i - 1] + places[i]) / 2;
        if (std::abs(middle - place) < 0.5 && std::abs(line.position(middle) - texel) < 0.5)
            seen += test::seen_of_piece(nodes, i, static_cast<long double>(cotangent));
    }
    return seen / static_cast<long double>(line.length);
}

/// What all lines see in a texel.
///
/// offset  of the lines beyond whole positions at place 0
long double seen_of_texel(const MemoryHeights& grid, int x, int y, double azimuth_degrees,
                          double theta_degrees, double offset)
{
    const HeightGrid::Shape& shape = grid.shape();
    const double ds = std::cos(radians(azimuth_degrees)) / shape.texel_width;
    const double dt = std::sin(radians(azimuth_degrees)) / shape.texel_height;
    const bool along_s = std::abs(ds) > std::abs(dt);
    const double run = along_s ? ds : dt, slope = along_s ? dt / ds : ds / dt;
    const int place = along_s ? x : y, texel = along_s ? y : x;
    const double nearest = std::floor(texel + 0.5 - offset - slope * place);
    long double seen = 0;
    for (const int beside : {-1, 0, 1}) {
        const Line line{along_s, run > 0 ? -1 : 1, nearest + beside + offset, slope,
                        1 / std::abs(run)};
        seen += seen_by_line(grid, line, place, texel, test::cotangent(theta_degrees));
    }
    return seen;
}

struct Lattice {
    int width, height;
    Edge edge;
    double texel_width, texel_height;
};

TEST(Sweep, SeesWhatNoNodeOfItsLinesHides)
{
    const Lattice lattices[] = {{16, 16, Edge::periodic, 1, 1},  {13, 9, Edge::repeat, 1, 1},
                                {8, 21, Edge::periodic, 2, 0.7}, {1, 11, Edge::periodic, 1, 1},
                                {5, 1, Edge::repeat, 1, 0.3},    {1, 1, Edge::periodic, 1, 1}};
    for (const Lattice& l : lattices) {
        HeightGrid::Shape shape = shape_of(l.width, l.height, l.edge, l.edge);
        shape.texel_width = l.texel_width;
        shape.texel_height = l.texel_height;
        const MemoryHeights grid = rough_heights(shape, 2, 7);
        // Not the diagonal itself: which axis it is crossed along is up to rounding.
        for (const double azimuth :
             {0.0, 11.0, 44.9, 57.0, 90.0, 133.0, 180.0, 201.0, 270.0, 320.0})
            for (const int lines : {1, 3}) {
                SweepOptions options;
                options.lines_per_texel = lines;
                const auto seen = swept(grid, whole_block(grid), azimuth, kThetas, options);
                for (size_t k = 0; k < kThetas.size(); ++k)
                    for (int i = 0; i < l.width * l.height; i += lines == 1 ? 1 : 5) {
                        const int x = i % l.width, y = i / l.width;
                        long double want = 0;
                        for (int line = 0; line < lines; ++line)
                            want += seen_of_texel(grid, x, y, azimuth, kThetas[k],
                                                  (line + kLineOffset) / lines) /
                                    lines;
                        ASSERT_NEAR(static_cast<double>(seen[k][static_cast<size_t>(i)]),
                                    static_cast<double>(want), kRounding)
                            << l.width << " x " << l.height << ", azimuth " << azimuth << ", theta "
                            << kThetas[k] << ", texel " << x << ", " << y << ", lines " << lines;
                    }
            }
    }
}

/// All that lines rise by is what they sank by: v is 1 on average, but for what the maxima of the
/// lines' ends and beginnings differ by: at most the range in drops, over the map's length.
TEST(Sweep, SeesOneOnAverageOfAMapThatGoesOn)
{
    for (const Edge edge : {Edge::periodic, Edge::repeat})
        for (const auto& [width, height] : {std::pair(64, 64), {63, 31}, {17, 128}}) {
            HeightGrid::Shape shape = shape_of(width, height, edge, edge);
            shape.texel_width = 0.6;
            const MemoryHeights grid = rough_heights(shape, 1, 3);
            for (const double azimuth : around(16)) {
                const auto seen = swept(grid, whole_block(grid), azimuth, kThetas);
                for (size_t k = 0; k < kThetas.size(); ++k) {
                    const bool along_s = std::abs(std::cos(radians(azimuth))) / 0.6 >
                                         std::abs(std::sin(radians(azimuth)));
                    const double length = along_s
                                              ? width * 0.6 / std::abs(std::cos(radians(azimuth)))
                                              : height / std::abs(std::sin(radians(azimuth)));
                    EXPECT_NEAR(mean_of(seen[k]), 1,
                                1 / test::cotangent(kThetas[k]) / length + 1e-5)
                        << width << " x " << height << " azimuth " << azimuth << " theta "
                        << kThetas[k];
                }
            }
        }
}

/// Where lines come back to where they began nothing is left but rounding.
TEST(Sweep, SeesExactlyOneOnAverageWhereLinesComeBack)
{
    const MemoryHeights grid = rough_heights(shape_of(48, 48), 3, 4);
    for (const double slope : {0.0, 0.25, 1.0 / 3, 0.5, 0.75})
        for (const double quadrant : {0.0, 90.0, 180.0, 270.0}) {
            const double azimuth = quadrant + std::atan(slope) * 180 / test::kPi;
            const auto seen = swept(grid, whole_block(grid), azimuth, kThetas);
            for (size_t k = 0; k < kThetas.size(); ++k)
                EXPECT_NEAR(mean_of(seen[k]), 1, 3 * kRounding)
                    << "azimuth " << azimuth << " theta " << kThetas[k];
        }
}

void expect_part(const std::vector<float>& part, const TexelBlock& block,
                 const std::vector<float>& whole, int width, double tolerance,
                 const std::string& where)
{
    for (int y = 0; y < block.height; ++y)
        for (int x = 0; x < block.width; ++x)
            ASSERT_NEAR(static_cast<double>(part[index_of(x, y, block.width)]),
                        static_cast<double>(whole[index_of(block.x0 + x, block.y0 + y, width)]),
                        tolerance)
                << where << ", texel " << x << ", " << y << " of block " << block.x0 << ", "
                << block.y0;
}

/// Bit for bit: the lines lie on the map the same way, and begin where nothing hides them.
TEST(Sweep, SeesTheSameWhateverTheBlock)
{
    for (const Edge edge : {Edge::periodic, Edge::repeat, Edge::extend, Edge::zero})
        for (const double holes : {0.0, 0.1}) {
            test::Uniform uniform(9);
            const MemoryHeights grid = heights_of(shape_of(150, 110, edge, edge), [&](int, int) {
                return uniform() < holes ? std::nan("") : 2 * uniform();
            });
            for (const double azimuth : around(24)) {
                const auto whole = swept(grid, whole_block(grid), azimuth, kThetas);
                for (const TexelBlock& block : {TexelBlock{0, 0, 150, 1},
                                                {149, 0, 1, 110},
                                                {17, 33, 71, 64},
                                                {149, 109, 1, 1},
                                                {64, 0, 64, 64}}) {
                    const auto part = swept(grid, block, azimuth, kThetas);
                    for (size_t k = 0; k < kThetas.size(); ++k)
                        expect_part(part[k], block, whole[k], 150, 0,
                                    "azimuth " + std::to_string(azimuth));
                }
            }
        }
}

/// A map whose rows are columns: the same lines.
TEST(Sweep, SeesATurnedMapTurned)
{
    HeightGrid::Shape shape = shape_of(23, 40, Edge::periodic, Edge::repeat);
    shape.texel_width = 1.5;
    HeightGrid::Shape turned_shape = shape_of(40, 23, Edge::repeat, Edge::periodic);
    turned_shape.texel_height = 1.5;
    std::vector<double> heights;
    test::Uniform uniform(2);
    const MemoryHeights grid = heights_of(shape, [&](int, int) {
        heights.push_back(2 * uniform());
        return heights.back();
    });
    const MemoryHeights turned =
        heights_of(turned_shape, [&](int x, int y) { return heights[index_of(y, x, 23)]; });
    for (const double azimuth : around(17)) { // no diagonal: which way it is crossed is open
        const auto seen = swept(grid, whole_block(grid), azimuth, kThetas);
        const auto again = swept(turned, whole_block(turned), 90 - azimuth, kThetas);
        for (size_t k = 0; k < kThetas.size(); ++k)
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 23; ++x)
                    ASSERT_NEAR(static_cast<double>(seen[k][index_of(x, y, 23)]),
                                static_cast<double>(again[k][index_of(y, x, 40)]), kRounding)
                        << "azimuth " << azimuth << " texel " << x << ", " << y;
    }
}

/// A map turned by half a turn: other lines of the same surface, so the same on average only. The
/// profile of a map that is the same along one axis is the same, and so are the numbers.
TEST(Sweep, SeesAMapFromTheOtherSideTurnedRound)
{
    test::Uniform uniform(8);
    std::vector<double> profile(37);
    for (double& h : profile)
        h = 2 * uniform();
    const MemoryHeights grid =
        heights_of(shape_of(37, 5), [&](int x, int) { return profile[static_cast<size_t>(x)]; });
    const MemoryHeights round = heights_of(
        shape_of(37, 5), [&](int x, int) { return profile[static_cast<size_t>(36 - x)]; });
    for (const double azimuth : {0.0, 20.0, -30.0}) {
        const auto seen = swept(grid, whole_block(grid), azimuth, kThetas);
        const auto again = swept(round, whole_block(round), azimuth + 180, kThetas);
        for (size_t k = 0; k < kThetas.size(); ++k)
            for (size_t i = 0; i < seen[k].size(); ++i)
                ASSERT_NEAR(static_cast<double>(seen[k][i]),
                            static_cast<double>(again[k][i / 37 * 37 + 36 - i % 37]), kRounding)
                    << "azimuth " << azimuth << " texel " << i;
    }
}

} // namespace
} // namespace scree
