#include "color/exact_table.h"

#include "color/magnitude_average.h"
#include "color/normal_average.h"

namespace scree {

namespace {

/// Rows that would need more nodes than this are asked mean by mean: their densities are narrow and
/// reach few knots.
constexpr double kMostNodes = 4096;

} // namespace

ExactTable::ExactTable(const ColorMap& map, MapVariable variable, double low, double high,
                       double widest)
    : map_(map), variable_(variable), low_(low), high_(high), widest_(widest)
{}

Rgb ExactTable::average(double mean, double deviation) const
{
    return variable_ == MapVariable::normal ? normal_average(map_, mean, deviation)
                                            : magnitude_average(map_, mean, deviation);
}

Rgb ExactTable::Row::at(double mean) const
{
    return smooth_ ? smooth_->at(mean) : table_->average(mean, deviation_);
}

const ExactTable::Row& ExactTable::row(double y)
{
    const auto [found, is_new] = rows_.try_emplace(y);
    Row& row = found->second;
    if (is_new) {
        row.table_ = this;
        row.deviation_ = widest_ * y * y;
        if (low_ < high_ && row.deviation_ > 0 &&
            SmoothRow::cost(low_, high_, row.deviation_) <= kMostNodes)
            row.smooth_.emplace([&](double mean) { return average(mean, row.deviation_); }, low_,
                                high_, row.deviation_);
    }
    return row;
}

MapTable ExactTable::sampled(int columns, int rows)
{
    MapTable table{columns, rows, low_, high_, widest_, {}};
    table.colors.reserve(static_cast<size_t>(columns) * static_cast<size_t>(rows));
    for (int r = 0; r < rows; ++r) {
        const Row& exact = row(rows > 1 ? static_cast<double>(r) / (rows - 1) : 0);
        for (int c = 0; c < columns; ++c)
            table.colors.push_back(exact.at(table.mean(c)));
    }
    return table;
}

} // namespace scree
