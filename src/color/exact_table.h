#pragma once

#include <map>
#include <optional>

#include "color/color_map.h"
#include "color/map_table.h"
#include "color/smooth_row.h"

namespace scree {

/// What a color map is a function of.
enum class MapVariable {
    normal,    ///< a normal number: a height, a slope along a direction
    magnitude, ///< the length of a normal vector: the steepness of a slope
};

/// The function a table holds samples of, T(mean, y), with y = sqrt(deviation / widest); to 2e-9
/// of the color span. What it finds out about a deviation it keeps for the next question about it.
class ExactTable {
public:
    ExactTable(const ColorMap& map, MapVariable variable, double low, double high, double widest);
    ExactTable(const ExactTable&) = delete; // rows point to it
    ExactTable& operator=(const ExactTable&) = delete;

    /// One deviation.
    class Row {
    public:
        [[nodiscard]] Rgb at(double mean) const;
        [[nodiscard]] double deviation() const { return deviation_; }

    private:
        friend class ExactTable;
        const ExactTable* table_ = nullptr;
        double deviation_ = 0;
        std::optional<SmoothRow> smooth_; ///< where the deviation is large enough for it to pay
    };

    /// y  in [0, 1]
    const Row& row(double y);

    /// The table of a size, filled.
    MapTable sampled(int columns, int rows);

    [[nodiscard]] const ColorMap& map() const { return map_; }

private:
    [[nodiscard]] Rgb average(double mean, double deviation) const;

    ColorMap map_;
    MapVariable variable_;
    double low_, high_, widest_;
    std::map<double, Row> rows_;
};

} // namespace scree
