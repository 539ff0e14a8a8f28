// Where values lie on an axis and what is written there.

#include "report/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// "0.5 -> 20": the numbers along an axis.
std::vector<std::string> numbers(const Scale& scale)
{
    std::vector<std::string> found;
    for (const auto& tick : scale.ticks())
        if (!tick.text.empty())
            found.push_back(tick.text);
    return found;
}

double place_of(const Scale& scale, const std::string& text)
{
    for (const auto& tick : scale.ticks())
        if (tick.text == text)
            return tick.place;
    ADD_FAILURE() << "no number " << text;
    return 0;
}

using Words = std::vector<std::string>;

TEST(Scale, LinearAxesHaveRoundNumbers)
{
    EXPECT_EQ(numbers(Scale({0, 8}, false, 9)),
              (Words{"0", "1", "2", "3", "4", "5", "6", "7", "8"}));
    EXPECT_EQ(numbers(Scale({0.31, 1}, false, 6)),
              (Words{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(numbers(Scale({-0.01, 0.02}, false, 3)),
              (Words{"\u22120.01", "0.00", "0.01", "0.02"}));
    EXPECT_EQ(numbers(Scale({0, 1e6}, false, 2)),
              (Words{"0", "500\u2009000", "1\u2009000\u2009000"}));
}

TEST(Scale, AnAxisReachesZeroWhereItComesNear)
{
    EXPECT_EQ(Scale({0.3, 1}, false, 6).place(0), 0);
    EXPECT_EQ(Scale({-1, -0.3}, false, 6).place(0), 1);
    // Values far from 0 stay as far apart as they can.
    const Scale far({100, 101}, false, 6);
    EXPECT_LT(far.place(100), 0.1);
    EXPECT_GT(far.place(101), 0.9);
}

TEST(Scale, NumbersStandWhereTheirValuesLie)
{
    const Scale linear({3, 17}, false, 5);
    EXPECT_NEAR(place_of(linear, "10"), linear.place(10), 1e-12); // rounding
    EXPECT_NEAR(linear.place(10) - linear.place(5), linear.place(15) - linear.place(10), 1e-12);
    const Scale logarithmic({0.02, 300}, true, 8);
    EXPECT_NEAR(place_of(logarithmic, "10"), logarithmic.place(10), 1e-12);
    EXPECT_NEAR(logarithmic.place(1) - logarithmic.place(0.1),
                logarithmic.place(100) - logarithmic.place(10), 1e-12);
}

TEST(Scale, LogarithmicAxesShowPowersOfTenAndWhatLiesBetween)
{
    EXPECT_EQ(numbers(Scale({0.02, 20000}, true, 8)),
              (Words{"0.1", "1", "10", "100", "1\u2009000", "10\u2009000"}));
    EXPECT_EQ(numbers(Scale({1.3, 80}, true, 5)), (Words{"2", "5", "10", "20", "50"}));
    EXPECT_EQ(numbers(Scale({1.3, 80}, true, 8)),
              (Words{"2", "3", "5", "7", "10", "20", "30", "50", "70"}));
    EXPECT_EQ(numbers(Scale({0.15, 1.2}, true, 3)), (Words{"0.2", "0.5", "1"}));
    // Too narrow for them: evenly spaced, but where a logarithm puts them.
    const Scale narrow({2.1, 2.4}, true, 3);
    EXPECT_EQ(numbers(narrow), (Words{"2.1", "2.2", "2.3", "2.4"}));
    EXPECT_NEAR((place_of(narrow, "2.2") - place_of(narrow, "2.1")) /
                    (place_of(narrow, "2.4") - place_of(narrow, "2.3")),
                std::log(2.2 / 2.1) / std::log(2.4 / 2.3), 1e-9);
    // Every 2 to 9 of a decade has its mark, numbered or not.
    EXPECT_EQ(Scale({1.2, 800}, true, 5).ticks().size(), 28U);
}

TEST(Scale, ManyDecadesAreThinnedAndRaised)
{
    const auto found = numbers(Scale({1e-20, 1e20}, true, 8));
    EXPECT_LE(found.size(), 9U);
    EXPECT_GE(found.size(), 5U);
    EXPECT_EQ(numbers(Scale({1e-7, 2e-4}, true, 8)),
              (Words{"10\u207b\u2077", "10\u207b\u2076", "10\u207b\u2075", "10\u207b\u2074"}));
}

TEST(Scale, WhatALogarithmCannotShowLiesAtTheLowEnd)
{
    const Scale scale({-5, 0, 1, 10}, true, 8);
    EXPECT_EQ(scale.place(0), 0);
    EXPECT_EQ(scale.place(-5), 0);
    EXPECT_GT(scale.place(1), 0);
}

TEST(Scale, AnyValuesGiveFiniteRisingTicksInside)
{
    const std::vector<std::vector<double>> cases = {
        {},
        {0},
        {5},
        {-5, -5},
        {kInfinity, std::nan("")},
        {1, kInfinity},
        {-1.7e308, 1.7e308},
        {5e-324, 1e-320},
        {1e-300, 1e300},
        {1e15, 1e15 + 1},
        {1, 1 + 1e-12},
        {-3, 1e-9},
        {1e9, 3e9},
        {0.1, 0.1000001},
    };
    for (const auto& values : cases)
        for (const bool logarithmic : {false, true})
            for (const int steps : {2, 6, 12}) {
                const Scale scale(values, logarithmic, steps);
                const std::string what =
                    testing::PrintToString(values) + (logarithmic ? " log" : " linear");
                ASSERT_FALSE(scale.ticks().empty()) << what;
                EXPECT_LE(numbers(scale).size(), 2U * static_cast<size_t>(steps) + 8U) << what;
                double before = -1;
                for (const auto& tick : scale.ticks()) {
                    EXPECT_GE(tick.place, 0) << what;
                    EXPECT_LE(tick.place, 1) << what;
                    EXPECT_GT(tick.place, before) << what;
                    before = tick.place;
                }
                for (const double value : values)
                    if (!std::isnan(value)) {
                        EXPECT_GE(scale.place(value), 0) << what;
                        EXPECT_LE(scale.place(value), 1) << what;
                    }
            }
}

} // namespace
} // namespace scree::report
