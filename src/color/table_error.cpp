#include "color/table_error.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace scree {

namespace {

/// A mean and its share of the range.
struct MeanNode {
    double mean, weight;
};

double column_width(const MapTable& table)
{
    return (table.high - table.low) / (table.columns - 1);
}

/// Of how many columns one is looked at. Over a wide density what lookups get wrong changes slowly
/// from column to column; eight places a deviation see it. A power of two, as columns are, less
/// one.
int column_stride(const MapTable& table, double deviation)
{
    int stride = 1;
    while (stride < table.columns - 1 && 16 * stride * column_width(table) <= deviation)
        stride *= 2;
    return stride;
}

/// Means to look at, for a density of that deviation: the difference is nearly a polynomial between
/// the places this puts nodes between.
std::vector<MeanNode> mean_nodes(const ColorMap& map, const MapTable& table, double deviation)
{
    if (!(table.low < table.high))
        return {{table.low, 1}};
    std::vector<std::pair<double, double>> pieces;
    const int stride = column_stride(table, deviation);
    for (int c = stride / 2; c < table.columns - 1; c += stride)
        pieces.emplace_back(table.mean(c), table.mean(c + 1));
    if (deviation < column_width(table)) {
        std::vector<double> places = {table.high};
        for (const auto& piece : pieces)
            places.push_back(piece.first);
        const auto& knots = map.knots();
        for (size_t i = 0; i < knots.size(); ++i) {
            places.push_back(knots[i].x);
            if (deviation > 0 && i > 0 && knots[i].x == knots[i - 1].x)
                for (const double away : {-4.0, -2.0, -1.0, 1.0, 2.0, 4.0})
                    places.push_back(knots[i].x + away * deviation);
        }
        std::sort(places.begin(), places.end());
        pieces.clear();
        for (size_t i = 1; i < places.size(); ++i)
            pieces.emplace_back(std::max(places[i - 1], table.low),
                                std::min(places[i], table.high));
    }
    // Gauss and Legendre's three nodes on [-1, 1].
    constexpr double kOut = 0.77459666924148337704;
    std::vector<MeanNode> nodes;
    for (const auto& [from, to] : pieces) {
        if (!(from < to))
            continue;
        const double middle = (from + to) / 2, half = (to - from) / 2;
        const double share = stride * (to - from) / (table.high - table.low) / 18;
        nodes.push_back({middle - kOut * half, 5 * share});
        nodes.push_back({middle, 8 * share});
        nodes.push_back({middle + kOut * half, 5 * share});
    }
    return nodes;
}

/// RMS over the nodes of what `got` gives instead of the exact color.
template <typename Got>
double rms_error(const ExactTable::Row& exact, const std::vector<MeanNode>& nodes, const Got& got)
{
    Rgb squares{};
    for (const MeanNode& node : nodes) {
        const Rgb want = exact.at(node.mean), have = got(node.mean);
        for (size_t c = 0; c < 3; ++c)
            squares[c] += node.weight * (have[c] - want[c]) * (have[c] - want[c]);
    }
    return std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

double largest_error(const ExactTable::Row& exact, const MapTable& table)
{
    constexpr int kPlaces = 8; // from column to column
    const int stride = column_stride(table, exact.deviation());
    double largest = 0;
    for (int column = 0; column < table.columns; column += stride)
        for (int i = 0; i < kPlaces; ++i) {
            const double mean =
                std::min(table.mean(column) + column_width(table) * i / kPlaces, table.high);
            const Rgb want = exact.at(mean), got = lookup(table, mean, exact.deviation());
            for (size_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(got[c] - want[c]));
        }
    return largest;
}

/// Places from row to row, in quarters. The sketchy ones are around the rows where the deviation
/// is small, which are the worst unless a map has many colors, and a few more.
std::vector<int> quarters_to_look_at(int rows, Thoroughness thoroughness)
{
    const int end = 4 * (rows - 1);
    std::vector<int> quarters;
    for (int q = 0; q <= end; ++q)
        if (thoroughness == Thoroughness::thorough || q <= 8 || q % std::max(end / 8, 1) == 0 ||
            q % std::max(end / 8, 1) == 2)
            quarters.push_back(q);
    return quarters;
}

} // namespace

TableError table_error(ExactTable& exact, const MapTable& table, Thoroughness thoroughness)
{
    const bool thorough = thoroughness == Thoroughness::thorough;
    // The narrowest deviation that the largest error is taken from, and as a rule the worst.
    const double width = column_width(table);
    const double narrowest = width < table.widest ? std::sqrt(width / table.widest) : 1;

    TableError error;
    if (thorough)
        error.largest = largest_error(exact.row(narrowest), table);
    for (const int quarter : quarters_to_look_at(table.rows, thoroughness)) {
        const double rows = std::max(table.rows - 1, 1);
        const double y = quarter / (4.0 * rows);
        const ExactTable::Row& row = exact.row(y);
        const std::vector<MeanNode> nodes = mean_nodes(exact.map(), table, row.deviation());
        const double rms = rms_error(
            row, nodes, [&](double mean) { return lookup(table, mean, row.deviation()); });
        error.rms = std::max(error.rms, rms);
        if (quarter % 4 == 0) {
            error.from_columns = std::max(error.from_columns, rms);
        } else {
            const int above_index = quarter / 4;
            const double share = quarter % 4 / 4.0;
            const ExactTable::Row &above = exact.row(above_index / rows),
                                  &below = exact.row((above_index + 1) / rows);
            error.from_rows =
                std::max(error.from_rows, rms_error(row, nodes, [&](double mean) {
                             const Rgb a = above.at(mean), b = below.at(mean);
                             return Rgb{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                                        a[2] + share * (b[2] - a[2])};
                         }));
        }
        if (thorough && y >= narrowest)
            error.largest = std::max(error.largest, largest_error(row, table));
    }
    return error;
}

} // namespace scree
