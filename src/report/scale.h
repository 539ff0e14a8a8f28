#pragma once

#include <string>
#include <vector>

namespace scree::report {

/// A place on an axis that is marked.
struct Tick {
    double place = 0; ///< 0 at the low end of the axis, 1 at the high end
    std::string text; ///< empty: a small mark between numbers
};

/// Where the values of an axis lie, and the numbers written along it.
///
/// The axis reaches a little beyond the values; a linear one to 0 where it comes near it.
class Scale {
public:
    /// values       of all points; those that cannot be shown (not finite, or on a logarithmic axis
    ///              not above 0) do not count
    /// steps        about as many numbers find room
    Scale(const std::vector<double>& values, bool logarithmic, int steps);

    /// In [0, 1]; what the axis does not reach lies at its end.
    /// value  not NaN
    [[nodiscard]] double place(double value) const;

    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

private:
    void make_linear(double low, double high, int steps);
    void make_logarithmic(double low, double high, int steps);
    void add_round_numbers(double low, double high, int steps); ///< evenly spaced
    void add_decades(const std::vector<int>& numbered, int steps);

    bool logarithmic_;
    double low_ = 0, high_ = 1; ///< of the value, or of its logarithm to base 10
    std::vector<Tick> ticks_;
};

} // namespace scree::report
