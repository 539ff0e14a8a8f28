#include "color/refined_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace scree {

namespace {

Rgb between(const Rgb& a, const Rgb& b, double t)
{
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double largest_difference(const Rgb& a, const Rgb& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The slopes of lines from one knot that pass all knots seen since within a tolerance.
class Cone {
public:
    explicit Cone(const Knot& apex) : apex_(apex)
    {
        least_.fill(-std::numeric_limits<double>::infinity());
        most_.fill(std::numeric_limits<double>::infinity());
    }

    [[nodiscard]] bool reaches(const Knot& k) const
    {
        for (size_t c = 0; c < 3; ++c) {
            const double slope = (k.color[c] - apex_.color[c]) / (k.x - apex_.x);
            if (!(slope >= least_[c] && slope <= most_[c]))
                return false;
        }
        return true;
    }

    void narrow(const Knot& k, double tolerance)
    {
        for (size_t c = 0; c < 3; ++c) {
            const double rise = k.color[c] - apex_.color[c], run = k.x - apex_.x;
            least_[c] = std::max(least_[c], (rise - tolerance) / run);
            most_[c] = std::min(most_[c], (rise + tolerance) / run);
        }
    }

private:
    Knot apex_;
    Rgb least_{}, most_{};
};

/// Bisects one piece of an encoded map until straight lines will do.
class Bisection {
public:
    Bisection(const Knot& a, const Knot& b, const std::function<Rgb(const Rgb&)>& convert,
              double tolerance, std::vector<Knot>& out)
        : a_(a), b_(b), convert_(convert), tolerance_(tolerance), out_(out)
    {}

    /// Appends the knots after t0 up to t1.
    void run(double t0, const Rgb& c0, double t1, const Rgb& c1, int depth)
    {
        std::array<Rgb, 3> inside;
        double error = 0;
        for (size_t i = 0; i < 3; ++i) {
            const double share = static_cast<double>(i + 1) / 4;
            inside[i] = convert_(between(a_.color, b_.color, t0 + share * (t1 - t0)));
            error = std::max(error, largest_difference(inside[i], between(c0, c1, share)));
        }
        // The first level is always halved, so that eighths are looked at.
        if (depth == 0 || (depth < kDeepest && !(error > tolerance_))) {
            out_.push_back({t1 == 1 ? b_.x : a_.x + t1 * (b_.x - a_.x), c1});
            return;
        }
        const double middle = (t0 + t1) / 2;
        run(t0, c0, middle, inside[1], depth - 1);
        run(middle, inside[1], t1, c1, depth - 1);
    }

    static constexpr int kDeepest = 14;

private:
    Knot a_, b_;
    const std::function<Rgb(const Rgb&)>& convert_;
    double tolerance_;
    std::vector<Knot>& out_;
};

} // namespace

ColorMap without_collinear_knots(const ColorMap& map, double tolerance)
{
    const std::vector<Knot>& knots = map.knots();
    std::vector<Knot> kept = {knots.front()};
    Cone cone(knots.front());
    for (size_t i = 1; i < knots.size(); ++i) {
        const bool jump = knots[i].x == knots[i - 1].x;
        if (jump || !cone.reaches(knots[i])) {
            if (kept.back().x != knots[i - 1].x)
                kept.push_back(knots[i - 1]);
            cone = Cone(knots[i - 1]);
        }
        if (jump) {
            kept.push_back(knots[i]);
            cone = Cone(knots[i]);
        } else {
            cone.narrow(knots[i], tolerance);
        }
    }
    if (kept.back().x != knots.back().x)
        kept.push_back(knots.back());
    return ColorMap(std::move(kept));
}

ColorMap refined(const ColorMap& encoded, const std::function<Rgb(const Rgb&)>& convert,
                 double tolerance)
{
    const std::vector<Knot>& knots = encoded.knots();
    std::vector<Rgb> colors;
    double largest = 0;
    for (const Knot& k : knots) {
        colors.push_back(convert(k.color));
        largest = std::max(largest, largest_difference(colors.back(), Rgb{}));
    }
    // Half for the bisection, half for the knots left out again.
    const double half = tolerance * largest / 2;
    std::vector<Knot> fine = {{knots.front().x, colors.front()}};
    for (size_t i = 1; i < knots.size(); ++i) {
        if (knots[i].x == knots[i - 1].x)
            fine.push_back({knots[i].x, colors[i]});
        else
            Bisection(knots[i - 1], knots[i], convert, half, fine)
                .run(0, colors[i - 1], 1, colors[i], Bisection::kDeepest);
    }
    return without_collinear_knots(ColorMap(std::move(fine)), half);
}

} // namespace scree
