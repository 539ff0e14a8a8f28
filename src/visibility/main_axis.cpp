#include "visibility/main_axis.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace scree {

namespace {

constexpr double kDegree = 180 / 3.14159265358979323846;
constexpr int kMostRows = 1024;

/// Degrees. What is so close to the map's own axes was meant to be on them.
constexpr double kAlongTheMap = 0.25;

/// Of three differences side by side: chosen so that slopes turn with the map (Scharr 2000).
constexpr double kWeights[] = {3.0 / 16, 10.0 / 16, 3.0 / 16};

/// Share of the squares of slopes that must agree. White noise of 64 x 64 texels has 0.02 at most.
constexpr double kLeastShare = 0.05;

} // namespace

double main_axis_deg(const HeightGrid& heights)
{
    const HeightGrid::Shape& shape = heights.shape();
    const int columns = shape.width + 2, every = (shape.height + kMostRows - 1) / kMostRows;
    std::vector<float> rows(3 * static_cast<size_t>(columns));
    std::complex<double> sum;
    double squares = 0;
    for (int y = 0; y < shape.height; y += every) {
        heights.read(0, -1, y - 1, columns, 3, rows.data());
        for (int x = 0; x < shape.width; ++x) {
            const auto at = [&](int column, int row) {
                return static_cast<double>(
                    rows[static_cast<size_t>(row) * static_cast<size_t>(columns) +
                         static_cast<size_t>(x + column)]);
            };
            double s = 0, t = 0;
            for (int i = 0; i < 3; ++i) {
                s += kWeights[i] * (at(2, i) - at(0, i)) / (2 * shape.texel_width);
                t += kWeights[i] * (at(i, 2) - at(i, 0)) / (2 * shape.texel_height);
            }
            const std::complex<double> slope(s, t);
            const double square = std::norm(slope);
            if (!(square > 0) || !std::isfinite(square)) // no data
                continue;
            sum += slope * slope * slope * slope / square;
            squares += square;
        }
    }
    if (!(std::abs(sum) > kLeastShare * squares))
        return 0;
    const double axis = std::arg(sum) / 4 * kDegree;
    return std::abs(axis) < kAlongTheMap ? 0 : axis;
}

} // namespace scree
