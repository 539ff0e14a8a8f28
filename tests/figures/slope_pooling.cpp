#include "figures/slope_pooling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::test {

double rms(const ScoresOfAngles& scores, const Angles& angles)
{
    double sum = 0;
    for (const size_t angle : angles)
        sum += scores[angle].square();
    return std::sqrt(sum / static_cast<double>(angles.size()));
}

std::optional<double> error_of(const SlopeSizeFigures& size, const std::string& way, Figure figure,
                               const Angles& angles)
{
    for (const WayFigures& one : size.ways)
        if (one.name == way && one[figure].front().measured())
            return rms(one[figure], angles);
    return std::nullopt;
}

void Pooled::add(double error)
{
    squares_ += error * error;
    largest_ = std::max(largest_, error);
    ++count_;
}

double Pooled::rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : 0; }

std::string Pooled::text() const
{
    return count_ > 0 ? fmt::format("{:.1f} / {:.1f}", 100 * rms(), 100 * largest_) : "";
}

Pooled pooled(const SurfacesSlopeFigures& all, const std::string& way, const Column& column)
{
    Pooled sum;
    for (const SurfaceSlopeFigures& surface : all)
        if (const auto one =
                error_of(surface.sizes[column.size], way, column.figure, column.angles))
            sum.add(*one);
    return sum;
}

} // namespace scree::test
