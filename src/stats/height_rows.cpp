#include "stats/height_rows.h"

#include <cmath>

namespace scree {

void pad_row(double* row, int width, Edge edge)
{
    double& before = row[0];
    double& after = row[width + 1];
    const double first = row[1];
    const double last = row[width];
    switch (edge) {
    case Edge::periodic:
        before = last;
        after = first;
        break;
    case Edge::extend:
        before = width > 1 ? 2 * first - row[2] : first;
        after = width > 1 ? 2 * last - row[width - 1] : last;
        break;
    case Edge::repeat:
        before = first;
        after = last;
        break;
    case Edge::zero:
        before = after = 0;
        break;
    }
}

std::vector<double> row_beyond(Edge edge, const std::vector<double>& last,
                               const std::vector<double>& before_last,
                               const std::vector<double>& opposite)
{
    switch (edge) {
    case Edge::periodic:
        return opposite;
    case Edge::extend: {
        std::vector<double> beyond(last.size());
        for (size_t x = 0; x < last.size(); ++x)
            beyond[x] = 2 * last[x] - before_last[x];
        return beyond;
    }
    case Edge::repeat:
        return last;
    case Edge::zero:
        break;
    }
    return std::vector<double>(last.size(), 0.0);
}

void complete_neighbours(double h[3][3])
{
    const double center = h[1][1];
    auto mirrored = [center](double neighbour, double opposite) {
        if (!std::isnan(neighbour))
            return neighbour;
        return std::isnan(opposite) ? center : 2 * center - opposite;
    };
    const double west = h[1][0], east = h[1][2], north = h[0][1], south = h[2][1];
    h[1][0] = mirrored(west, east);
    h[1][2] = mirrored(east, west);
    h[0][1] = mirrored(north, south);
    h[2][1] = mirrored(south, north);
    for (int t : {0, 2})
        for (int s : {0, 2})
            if (std::isnan(h[t][s]))
                h[t][s] = h[t][1] + h[1][s] - center;
}

} // namespace scree
