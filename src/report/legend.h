#pragma once

#include <string>
#include <vector>

#include "report/chart.h"
#include "report/svg.h"

namespace scree::report {

/// Whether a line has so many points that markers would run into each other.
/// width  of the plot, pixels
bool is_crowded(const Series& series, double width);

/// Names of series with what they are drawn with, in columns of one width under a chart.
class Legend {
public:
    /// chart  outlives this
    /// width  of all columns, pixels
    Legend(const Chart& chart, double width);

    [[nodiscard]] double height() const;
    [[nodiscard]] std::string draw(const Spot& corner) const;

private:
    [[nodiscard]] std::string entry(size_t series, const Spot& left) const;

    const Chart& chart_;
    double width_;
    std::vector<size_t> entries_; ///< series that have a name
    double column_ = 0;
    size_t per_row_ = 1;
};

} // namespace scree::report
