// Tables of color maps: what they hold, how large they are, how wrong lookups are.

#include "color/filtered_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "color/magnitude_average.h"
#include "color/maps.h"
#include "color/normal_average.h"
#include "color/smooth_row.h"
#include "color/table_error.h"
#include "kernel/filter.h"

namespace scree::test {
namespace {

/// RMS over evenly spaced means of lookups at one deviation, and the largest.
struct Sampled {
    double rms = 0, largest = 0;
};

Sampled sampled_error(const MapTable& table, double deviation,
                      const std::function<Rgb(double, double)>& exact, int count)
{
    Rgb squares{};
    Sampled error;
    for (int i = 0; i < count; ++i) {
        const double mean = table.low + (table.high - table.low) * (i + 0.5) / count;
        const Rgb got = lookup(table, mean, deviation), want = exact(mean, deviation);
        for (size_t c = 0; c < 3; ++c)
            squares[c] += (got[c] - want[c]) * (got[c] - want[c]) / count;
        error.largest = std::max(error.largest, largest_difference(got, want));
    }
    error.rms = std::sqrt(std::max({squares[0], squares[1], squares[2]}));
    return error;
}

TEST(SmoothRow, FollowsTheAverage)
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const ColorMap map = random_map(seed);
        for (const double deviation : {0.01, 0.1, 1.0}) {
            const auto exact = [&](double mean) { return normal_average(map, mean, deviation); };
            const SmoothRow row(exact, -0.2, 1.3, deviation);
            for (double mean = -0.2; mean <= 1.3; mean += 7e-4)
                ASSERT_LT(largest_difference(row.at(mean), exact(mean)), 2e-9)
                    << "seed " << seed << " deviation " << deviation << " mean " << mean;
            ASSERT_LT(largest_difference(row.at(1.3), exact(1.3)), 2e-9);
        }
    }
}

TEST(MapTable, LookupsAreBilinearInMeanAndRootOfDeviation)
{
    MapTable table{3, 3, 10, 20, 4, {}};
    for (int i = 0; i < 9; ++i)
        table.colors.push_back({i * i / 1.0, -i / 1.0, 1});
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_EQ(lookup(table, table.mean(column), table.deviation(row)),
                      table.at(column, row));
    EXPECT_EQ(table.deviation(1), 1); // 4 (1/2)^2
    // a quarter of the way along, halfway down in the root: deviation 4 (1/4)^2
    const Rgb got = lookup(table, 12.5, 0.25);
    EXPECT_DOUBLE_EQ(got[0], (0 + 1 + 9 + 16) / 4.0);
    EXPECT_DOUBLE_EQ(got[1], -2);
    EXPECT_EQ(lookup(table, -1e9, -1), table.at(0, 0));
    EXPECT_EQ(lookup(table, 1e9, 1e9), table.at(2, 2));
    const MapTable one{1, 1, 5, 5, 0, {{1, 2, 3}}};
    EXPECT_EQ(lookup(one, 7, 7), (Rgb{1, 2, 3}));
}

// Oracle: a texture unit, from the kernel's coordinates: texel centres at (i + 0.5) / size.
TEST(MapTable, LookupsAreWhatARendererReads)
{
    const MapTable table =
        make_filtered_map(random_map(8), MapVariable::normal, -0.1, 1.2, 0.4, 0.05).table;
    const filter::ColorMapTable<double> size{table.low, table.high, table.widest, table.columns,
                                             table.rows};
    for (double mean = -0.3; mean < 1.4; mean += 0.0371)
        for (double deviation = 0; deviation < 0.5; deviation += 0.0113) {
            const auto uv = filter::color_map_coordinates(mean, deviation, size);
            const double x = uv.x * table.columns - 0.5, y = uv.y * table.rows - 0.5;
            Rgb want{};
            for (int row = 0; row < table.rows; ++row)
                for (int column = 0; column < table.columns; ++column)
                    for (size_t c = 0; c < 3; ++c)
                        want[c] += std::max(0.0, 1 - std::abs(x - column)) *
                                   std::max(0.0, 1 - std::abs(y - row)) * table.at(column, row)[c];
            ASSERT_LT(largest_difference(lookup(table, mean, deviation), want), 1e-12)
                << mean << " " << deviation;
        }
}

TEST(FilteredMap, HoldsTheMapInItsFirstRowAndAveragesInTheOthers)
{
    const ColorMap map = random_map(5);
    for (const MapVariable variable : {MapVariable::normal, MapVariable::magnitude}) {
        const FilteredMap filtered = make_filtered_map(map, variable, 0, 1.25, 0.3, 0.02);
        const MapTable& table = filtered.table;
        ASSERT_GT(table.rows, 2);
        for (int column = 0; column < table.columns; ++column)
            ASSERT_EQ(table.at(column, 0), map.at(table.mean(column)));
        for (int row = 1; row < table.rows; ++row)
            for (int column = 0; column < table.columns; column += 5) {
                const double mean = table.mean(column), deviation = table.deviation(row);
                const Rgb want = variable == MapVariable::normal
                                     ? normal_average(map, mean, deviation)
                                     : magnitude_average(map, mean, deviation);
                ASSERT_LT(largest_difference(table.at(column, row), want), 2e-9);
            }
    }
}

// The figure in the result against lookups at evenly spaced means, for closed forms and quadrature.
TEST(FilteredMap, RecordsTheErrorLookupsHave)
{
    struct Case {
        ColorMap map;
        double tolerance;
    };
    for (const auto& [map, tolerance] :
         {Case{step_map(0.3717), 0.02}, Case{step_map(0.5), 0.02}, Case{ramp_map(0.2, 0.7), 0.01},
          Case{hat_map(0.3, 0.35, 0.8), 0.003}, Case{random_map(11), 0.01}}) {
        const FilteredMap filtered =
            make_filtered_map(map, MapVariable::normal, 0, 1, 0.25, tolerance);
        EXPECT_TRUE(filtered.reached);
        EXPECT_LE(filtered.rms_error, tolerance);
        const double span = color_span(map, 0, 1);
        const auto exact = [&](double mean, double deviation) {
            return deviation > 0 ? normal_by_quadrature(map, mean, deviation) : map.at(mean);
        };
        double rms = 0, largest = 0;
        const double column_width = 1.0 / (filtered.table.columns - 1);
        // rows, halfway between, and places that are neither
        for (double row = 0; row <= filtered.table.rows - 1; row += row < 4 ? 0.25 : 0.73) {
            const double y = row / (filtered.table.rows - 1), deviation = 0.25 * y * y;
            const int samples = deviation < 4 * column_width ? 10 * filtered.table.columns : 503;
            const Sampled error = sampled_error(filtered.table, deviation, exact, samples);
            rms = std::max(rms, error.rms / span);
            if (deviation >= column_width)
                largest = std::max(largest, error.largest / span);
        }
        // ten samples a column leave 1 % of doubt about a jump within one
        EXPECT_LT(rms, 1.02 * filtered.rms_error);
        EXPECT_GT(rms, 0.95 * filtered.rms_error);
        EXPECT_LT(largest, 1.02 * filtered.largest_error);
        EXPECT_GT(largest, 0.5 * filtered.largest_error);
    }
}

// An error put into the widest row alone, where one column of many is looked at.
TEST(TableError, ErrorsOfWideDensitiesCountInFull)
{
    const ColorMap map = ramp_map(0.2, 0.7);
    ExactTable exact(map, MapVariable::normal, 0, 1, 0.5);
    MapTable table = exact.sampled(1025, 33);
    for (int column = 0; column < table.columns; ++column)
        table.colors[static_cast<size_t>(32 * table.columns + column)][1] += 0.3;
    const TableError error = table_error(exact, table, Thoroughness::thorough);
    EXPECT_NEAR(error.rms, 0.3, 1e-3);
    EXPECT_NEAR(error.from_columns, 0.3, 1e-3);
    EXPECT_NEAR(error.largest, 0.3, 1e-3);
    EXPECT_LT(error.from_rows, 0.01); // of the exact rows
}

TEST(FilteredMap, NeitherColumnsNorRowsAreMoreThanItTakes)
{
    for (const ColorMap& map : {step_map(0.37), ramp_map(0.2, 0.7), hat_map(0.3, 0.35, 0.8)}) {
        const double tolerance = 0.01, span = color_span(map, 0, 1);
        const FilteredMap filtered =
            make_filtered_map(map, MapVariable::normal, 0, 1, 0.25, tolerance);
        const int columns = filtered.table.columns, rows = filtered.table.rows;
        ExactTable exact(map, MapVariable::normal, 0, 1, 0.25);
        const auto rms = [&](int c, int r) {
            return table_error(exact, exact.sampled(c, r), Thoroughness::thorough).rms / span;
        };
        EXPECT_LE(rms(columns, rows), tolerance);
        EXPECT_GT(rms((columns + 1) / 2, rows), tolerance) << columns << " x " << rows;
        EXPECT_GT(rms(columns, (rows + 1) / 2), tolerance) << columns << " x " << rows;
    }
}

TEST(FilteredMap, AStepNeedsMoreColumnsThanARamp)
{
    const auto columns = [](const ColorMap& map, double tolerance) {
        return make_filtered_map(map, MapVariable::normal, 0, 1, 0.25, tolerance).table.columns;
    };
    EXPECT_GT(columns(step_map(0.37), 0.01), 20 * columns(ramp_map(0.2, 0.7), 0.01));
    EXPECT_GT(columns(step_map(0.37), 0.01), 3 * columns(step_map(0.37), 0.03));
}

TEST(FilteredMap, OneColorNeedsNoTable)
{
    const ColorMap one(std::vector<Knot>{{0, {0.5, 0.2, 0.1}}});
    const FilteredMap filtered = make_filtered_map(one, MapVariable::normal, -10, 10, 3, 1e-6);
    EXPECT_EQ(filtered.table.columns, 2);
    EXPECT_EQ(filtered.table.rows, 2);
    EXPECT_EQ(filtered.rms_error, 0);
    EXPECT_TRUE(filtered.reached);
    EXPECT_LT(largest_difference(lookup(filtered.table, 3, 1), {0.5, 0.2, 0.1}), 1e-15);
}

TEST(FilteredMap, WithoutDeviationsThereIsOneRow)
{
    const FilteredMap filtered =
        make_filtered_map(ramp_map(0.25, 0.5), MapVariable::normal, 0, 1, 0, 1e-3);
    EXPECT_EQ(filtered.table.rows, 1);
    EXPECT_EQ(filtered.table.columns, 5); // both bends fall on columns
    EXPECT_LT(filtered.rms_error, 1e-12);
    EXPECT_TRUE(filtered.reached);
}

TEST(FilteredMap, ARangeOfOneMeanIsAllowed)
{
    const FilteredMap filtered =
        make_filtered_map(ramp_map(0, 1), MapVariable::normal, 0.5, 0.5, 0.2, 1e-3);
    EXPECT_EQ(filtered.table.columns, 2);
    EXPECT_TRUE(filtered.reached);
    EXPECT_LT(largest_difference(lookup(filtered.table, 0.5, 0.1),
                                 normal_average(ramp_map(0, 1), 0.5, 0.1)),
              2e-3);
}

// The colors beyond the range show through wide densities.
TEST(FilteredMap, OneColorInItsRangeMayHaveOthersBeyond)
{
    const ColorMap map = step_map(1.2);
    const FilteredMap filtered = make_filtered_map(map, MapVariable::normal, 0, 1, 0.5, 1e-2);
    EXPECT_TRUE(filtered.reached);
    EXPECT_GT(filtered.table.columns, 2);
    EXPECT_LT(largest_difference(lookup(filtered.table, 0.9, 0.4), normal_average(map, 0.9, 0.4)),
              0.1);
}

TEST(FilteredMap, SaysWhenTheLargestTableIsNotEnough)
{
    const FilteredMap filtered =
        make_filtered_map(step_map(0.5), MapVariable::normal, 0, 1, 0.25, 1e-3);
    EXPECT_FALSE(filtered.reached);
    EXPECT_GT(filtered.rms_error, 1e-3);
    EXPECT_EQ(filtered.table.columns, kMostMapColumns);
    // rows cannot mend it: no more of them than they need themselves
    EXPECT_LT(filtered.table.rows, kMostMapRows);
    // A jump on a column: the integral of t^2 over one column's width, by hand.
    EXPECT_NEAR(filtered.rms_error, std::sqrt(1 / 3.0 / (kMostMapColumns - 1)), 1e-4);
}

TEST(FilteredMap, RealMapsReachAHundredth)
{
    const auto maps = real_maps();
    if (maps.empty())
        GTEST_SKIP() << "no folder of real data";
    for (const auto& [name, map] : maps) {
        const double width = map.last() - map.first();
        const FilteredMap filtered = make_filtered_map(map, MapVariable::normal, map.first(),
                                                       map.last(), 0.25 * width, 0.01);
        EXPECT_TRUE(filtered.reached) << name << ": " << filtered.rms_error;
        const double span = color_span(map, map.first(), map.last());
        const auto exact = [&, &of = map](double mean, double deviation) {
            return normal_by_quadrature(of, mean, deviation);
        };
        for (const double y : {0.3, 0.77}) {
            const double deviation = 0.25 * width * y * y;
            EXPECT_LT(sampled_error(filtered.table, deviation, exact, 50).rms, 0.011 * span)
                << name;
        }
        RecordProperty(name, std::to_string(filtered.table.columns) + "x" +
                                 std::to_string(filtered.table.rows));
    }
}

} // namespace
} // namespace scree::test
