#include "reference/patch.h"

#include <cmath>

namespace scree::reference {
namespace {

double completed(double neighbour, double centre, double opposite)
{
    if (!std::isnan(neighbour))
        return neighbour;
    return std::isnan(opposite) ? centre : 2 * centre - opposite;
}

} // namespace

PatchPoint patch_at(const NodeGrid& grid, int column, int row, double x, double y)
{
    const int i = column + 1, j = row + 1;
    const double* centre = grid.row(j) + i;
    const double from_x = x - i, from_y = y - j;
    const int side_x = from_x < 0 ? -1 : 1, side_y = from_y < 0 ? -1 : 1;
    const double h = *centre;
    const double beside = completed(centre[side_x], h, centre[-side_x]);
    const double below = completed(grid.row(j + side_y)[i], h, grid.row(j - side_y)[i]);
    const double corner = grid.row(j + side_y)[i + side_x];

    const double along_x = side_x * (beside - h);
    const double along_y = side_y * (below - h);
    const double twist =
        std::isnan(corner) ? 0 : side_x * side_y * ((corner - beside) - (below - h));
    return {h + from_x * along_x + from_y * (along_y + from_x * twist),
            {along_x + from_y * twist, along_y + from_x * twist}};
}

} // namespace scree::reference
