#include "visibility/slope_survey.h"

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

/// Three rows of heights, and a texel beyond them on either side.
class Rows {
public:
    explicit Rows(const HeightGrid& heights)
        : heights_(heights), columns_(static_cast<size_t>(heights.shape().width) + 2),
          rows_(3 * columns_)
    {}

    void read_around(int y)
    {
        heights_.read(0, -1, y - 1, static_cast<int>(columns_), 3, rows_.data());
    }

    /// row 0 to 2; column 0 is the texel before the map
    [[nodiscard]] double at(size_t column, size_t row) const
    {
        return rows_[row * columns_ + column];
    }

private:
    const HeightGrid& heights_;
    size_t columns_;
    std::vector<float> rows_;
};

/// E[slope^2] along one axis of a bilinear cell: it goes linearly from one side's to the other's.
double mean_square(double first, double second)
{
    return (first * first + first * second + second * second) / 3;
}

/// Of the cells between the middle row and the next.
class Steepness {
public:
    explicit Steepness(const HeightGrid::Shape& shape) : shape_(shape) {}

    void add(const Rows& rows, size_t x)
    {
        const double a = rows.at(x + 1, 1), b = rows.at(x + 2, 1);
        const double c = rows.at(x + 1, 2), d = rows.at(x + 2, 2);
        const double square =
            mean_square(b - a, d - c) / (shape_.texel_width * shape_.texel_width) +
            mean_square(c - a, d - b) / (shape_.texel_height * shape_.texel_height);
        if (!std::isfinite(square)) // no data
            return;
        squares_ += square;
        fourths_ += square * square;
    }
    [[nodiscard]] double steepness() const
    {
        return squares_ > 0 ? std::sqrt(fourths_ / squares_) : 0;
    }

private:
    const HeightGrid::Shape& shape_;
    double squares_ = 0, fourths_ = 0;
};

class MainAxis {
public:
    explicit MainAxis(const HeightGrid::Shape& shape) : shape_(shape) {}

    void add(const Rows& rows, size_t x)
    {
        double s = 0, t = 0;
        for (size_t i = 0; i < 3; ++i) {
            s += kWeights[i] * (rows.at(x + 2, i) - rows.at(x, i)) / (2 * shape_.texel_width);
            t += kWeights[i] * (rows.at(x + i, 2) - rows.at(x + i, 0)) / (2 * shape_.texel_height);
        }
        const std::complex<double> slope(s, t);
        const double square = std::norm(slope);
        if (!(square > 0) || !std::isfinite(square)) // no data
            return;
        sum_ += slope * slope * slope * slope / square;
        squares_ += square;
    }
    [[nodiscard]] double degrees() const
    {
        if (!(std::abs(sum_) > kLeastShare * squares_))
            return 0;
        const double axis = std::arg(sum_) / 4 * kDegree;
        return std::abs(axis) < kAlongTheMap ? 0 : axis;
    }

private:
    const HeightGrid::Shape& shape_;
    std::complex<double> sum_;
    double squares_ = 0;
};

} // namespace

SlopeSurvey survey_slopes(const HeightGrid& heights)
{
    const HeightGrid::Shape& shape = heights.shape();
    const int every = (shape.height + kMostRows - 1) / kMostRows;
    Rows rows(heights);
    Steepness steepness(shape);
    MainAxis axis(shape);
    for (int y = 0; y < shape.height; y += every) {
        rows.read_around(y);
        for (size_t x = 0; x < static_cast<size_t>(shape.width); ++x) {
            steepness.add(rows, x);
            axis.add(rows, x);
        }
    }
    return {steepness.steepness(), axis.degrees()};
}

} // namespace scree
