#include "reference/slope_points.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace scree::reference {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Sets the entries before the first and after the last of a line of n numbers.
///
/// line  entry 0 is the one before the first; stride apart
void continue_line(double* line, size_t n, size_t stride, Beyond beyond, bool repeats_border)
{
    auto at = [=](size_t i) -> double& { return line[i * stride]; };
    double &before = at(0), &after = at(n + 1);
    switch (beyond) {
    case Beyond::repeats:
        before = at(n);
        after = at(1);
        return;
    case Beyond::ends:
        before = after = 0;
        return;
    case Beyond::mirrors:
        before = at(1);
        after = at(n);
        return;
    case Beyond::extends:
        const bool level = repeats_border || n == 1;
        before = level ? at(1) : 2 * at(1) - at(2);
        after = level ? at(n) : 2 * at(n) - at(n - 1);
        return;
    }
}

/// Places of the points in half a texel, from 0 to 1.
const std::array<double, 3> kPlaces = {0.5 - std::sqrt(15.0) / 10, 0.5, 0.5 + std::sqrt(15.0) / 10};

} // namespace

HeightGrid::HeightGrid(const Relief& relief, const std::vector<double>& weights,
                       Reconstruction reconstruction)
    : reconstruction_(reconstruction), texel_width_(relief.texel_width),
      texel_height_(relief.texel_height), width_(relief.width + 2)
{
    const auto columns = static_cast<size_t>(relief.width),
               rows = static_cast<size_t>(relief.height);
    const size_t stride = columns + 2;
    heights_.resize(stride * (rows + 2));
    // Columns first, then rows from the rows so continued.
    for (size_t y = 0; y < rows; ++y) {
        double* row = heights_.data() + (y + 1) * stride;
        for (size_t x = 0; x < columns; ++x) {
            const size_t i = y * columns + x;
            row[x + 1] = weights[i] > 0 ? relief.heights[i] : kMissing;
        }
        continue_line(row, columns, 1, relief.beyond_s, reconstruction == Reconstruction::sobel);
    }
    for (size_t x = 0; x < stride; ++x)
        continue_line(heights_.data() + x, rows, stride, relief.beyond_t,
                      reconstruction == Reconstruction::sobel);
}

HeightGrid::Neighbours HeightGrid::neighbours(int x, int y) const
{
    const auto stride = static_cast<size_t>(width_);
    const double* corner =
        heights_.data() + static_cast<size_t>(y) * stride + static_cast<size_t>(x);
    Neighbours h;
    bool complete = true;
    for (size_t j = 0; j < 3; ++j)
        for (size_t i = 0; i < 3; ++i) {
            h[j][i] = corner[j * stride + i];
            complete = complete && !std::isnan(h[j][i]);
        }
    if (complete)
        return h;

    // Edges look at what was there, not at what was completed: two missing ones are both level
    // with the centre.
    const Neighbours given = h;
    const double centre = h[1][1];
    auto edge = [centre](double mine, double opposite) {
        if (!std::isnan(mine))
            return mine;
        return std::isnan(opposite) ? centre : 2 * centre - opposite;
    };
    h[1][0] = edge(given[1][0], given[1][2]);
    h[1][2] = edge(given[1][2], given[1][0]);
    h[0][1] = edge(given[0][1], given[2][1]);
    h[2][1] = edge(given[2][1], given[0][1]);
    for (size_t j : {0U, 2U})
        for (size_t i : {0U, 2U})
            if (std::isnan(given[j][i]))
                h[j][i] = h[1][i] + h[j][1] - centre;
    return h;
}

SlopePoints HeightGrid::slopes(int x, int y) const
{
    const Neighbours h = neighbours(x, y);
    if (reconstruction_ == Reconstruction::central)
        return constant_slope((h[1][2] - h[1][0]) / (2 * texel_width_),
                              (h[2][1] - h[0][1]) / (2 * texel_height_));
    if (reconstruction_ == Reconstruction::sobel) {
        double s = 0, t = 0;
        constexpr std::array<double, 3> kSmooth = {1, 2, 1};
        for (size_t k = 0; k < 3; ++k) {
            s += kSmooth[k] * (h[k][2] - h[k][0]);
            t += kSmooth[k] * (h[2][k] - h[0][k]);
        }
        return constant_slope(s / (8 * texel_width_), t / (8 * texel_height_));
    }
    SlopePoints points;
    points.cells = 4;
    for (size_t q = 0; q < 4; ++q) {
        const size_t i = q % 2, j = q / 2; // corner of the bilinear cell in the 3x3
        const double h00 = h[j][i], h10 = h[j][i + 1], h01 = h[j + 1][i], h11 = h[j + 1][i + 1];
        for (size_t k = 0; k < 3; ++k) {
            // The texel holds the far half of a cell before its centre, the near half of one after.
            const double u = (kPlaces[k] + (i == 0 ? 1 : 0)) / 2;
            const double v = (kPlaces[k] + (j == 0 ? 1 : 0)) / 2;
            // Differences, not (1 - v) a + v b: equal slopes stay equal to the last bit.
            points.s[q][k] = ((h10 - h00) + v * ((h11 - h01) - (h10 - h00))) / texel_width_;
            points.t[q][k] = ((h01 - h00) + u * ((h11 - h10) - (h01 - h00))) / texel_height_;
        }
    }
    return points;
}

SlopePoints constant_slope(double s, double t)
{
    SlopePoints points;
    points.cells = 1;
    points.s[0] = {s, s, s};
    points.t[0] = {t, t, t};
    return points;
}

} // namespace scree::reference
