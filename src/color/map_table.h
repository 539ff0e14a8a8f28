#pragma once

#include <cstddef>
#include <vector>

#include "color/color_map.h"

namespace scree {

/// A color map averaged over normal densities, as a texture: T(mean, deviation).
///
/// Columns are means, evenly from `low` (centre of the first) to `high` (centre of the last). Rows
/// are deviations widest y^2, y evenly from 0 (centre of the first row) to 1 (centre of the last):
/// the narrower the density, the faster the color changes with it.
struct MapTable {
    int columns = 1, rows = 1;
    double low = 0, high = 1;
    double widest = 1;
    std::vector<Rgb> colors; ///< rows x columns, row 0 first

    [[nodiscard]] const Rgb& at(int column, int row) const
    {
        return colors[static_cast<size_t>(row) * static_cast<size_t>(columns) +
                      static_cast<size_t>(column)];
    }
    [[nodiscard]] double mean(int column) const
    {
        return columns > 1 ? low + (high - low) * column / (columns - 1) : low;
    }
    [[nodiscard]] double deviation(int row) const
    {
        const double y = rows > 1 ? static_cast<double>(row) / (rows - 1) : 0;
        return widest * y * y;
    }
};

/// What a renderer reads from the table: coordinates clamped to the centres of the border, bilinear
/// interpolation. The twin of scree_color_map_coordinates and a texture unit.
Rgb lookup(const MapTable& table, double mean, double deviation);

} // namespace scree
