// Numbers as people read them.

#include "report/numbers.h"

#include <gtest/gtest.h>

#include <locale>

namespace scree::report {
namespace {

constexpr const char* kThin = "\u2009";

TEST(Numbers, DigitsAreGroupedByThrees)
{
    EXPECT_EQ(grouped(0, 0), "0");
    EXPECT_EQ(grouped(999, 0), "999");
    EXPECT_EQ(grouped(1000, 0), std::string("1") + kThin + "000");
    EXPECT_EQ(grouped(12345.678, 2), std::string("12") + kThin + "345.68");
    EXPECT_EQ(grouped(1234567, 0), std::string("1") + kThin + "234" + kThin + "567");
    EXPECT_EQ(grouped(0.00125, 5), "0.00125");
}

TEST(Numbers, MinusIsASignAndZeroHasNone)
{
    EXPECT_EQ(grouped(-0.5, 1), "\u22120.5");
    EXPECT_EQ(grouped(-1e-17, 2), "0.00");
    EXPECT_EQ(grouped(-0.0, 0), "0");
}

TEST(Numbers, PowersOfTenAreWrittenOutOrRaised)
{
    EXPECT_EQ(of_decade(1, 0, false), "1");
    EXPECT_EQ(of_decade(1, 2, false), "100");
    EXPECT_EQ(of_decade(5, 3, false), std::string("5") + kThin + "000");
    EXPECT_EQ(of_decade(1, -2, false), "0.01");
    EXPECT_EQ(of_decade(2, -4, false), "0.0002");
    EXPECT_EQ(of_decade(1, -12, true), "10\u207b\u00b9\u00b2");
    EXPECT_EQ(of_decade(2, 7, true), "2\u00b710\u2077");
    EXPECT_EQ(of_decade(1, 0, true), "1");
    EXPECT_EQ(of_decade(5, 1, true), "50");
}

TEST(Numbers, CoordinatesAreShort)
{
    EXPECT_EQ(coordinate(1), "1");
    EXPECT_EQ(coordinate(120), "120");
    EXPECT_EQ(coordinate(0.125), "0.12");
    EXPECT_EQ(coordinate(-0.001), "0");
    EXPECT_EQ(coordinate(1e15), "1000000000000000");
}

struct CommaForPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Numbers, TheLocaleChangesNothing)
{
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaForPoint));
    EXPECT_EQ(coordinate(12345.5), "12345.5");
    EXPECT_EQ(grouped(1.5, 1), "1.5");
    EXPECT_EQ(brief(0.25), "0.25");
    std::locale::global(before);
}

} // namespace
} // namespace scree::report
