// One table as text, HTML and CSV.

#include "report/table.h"

#include <gtest/gtest.h>

#include "support/markup.h"

namespace scree::report {
namespace {

const Table kTable = {"Levels",
                      {"level", "size", "RMS error", "share", "remark"},
                      {{"0", "512x512", "0.001", "98 %", "a, b"},
                       {"10", "1x1", "-1.5e-07", "-", "\"<b>\" & \u00b5"},
                       {"2", "128x128", "1 234", "+7 %", ""}}};

TEST(Table, TextPadsColumnsAndPutsNumbersToTheRight)
{
    EXPECT_EQ(to_text(kTable), "Levels\n"
                               "level  size     RMS error  share  remark\n"
                               "    0  512x512      0.001   98 %  a, b\n"
                               "   10  1x1       -1.5e-07      -  \"<b>\" & \u00b5\n"
                               "    2  128x128      1 234   +7 %\n");
}

TEST(Table, TextCountsCharactersNotBytes)
{
    EXPECT_EQ(to_text({"", {"a", "b"}, {{"\u00b5\u00b5", "x"}, {"yyy", "z"}}}),
              "a    b\n\u00b5\u00b5   x\nyyy  z\n");
}

TEST(Table, AColumnWithOneWordInItIsNoColumnOfNumbers)
{
    EXPECT_EQ(to_text({"", {"value"}, {{"1"}, {"inside"}}}), "value\n1\ninside\n");
    EXPECT_EQ(to_text({"", {"value"}, {{"1"}, {"1e999"}, {"-"}}}), "value\n    1\n1e999\n    -\n");
    EXPECT_EQ(to_text({"", {"value"}, {{"-"}, {""}}}), "value\n-\n\n");
    EXPECT_EQ(to_text({"", {"value"}, {{"1"}, {"nan"}, {"inf"}}}), "value\n    1\n  nan\n  inf\n");
}

TEST(Table, TextOfNoRowsIsItsHeadings) { EXPECT_EQ(to_text({"", {"a", "bc"}, {}}), "a  bc\n"); }

TEST(Table, CsvQuotesWhatNeedsIt)
{
    // RFC 4180: lines end in CR LF, quotes are doubled within quotes.
    EXPECT_EQ(to_csv(kTable), "level,size,RMS error,share,remark\r\n"
                              "0,512x512,0.001,98 %,\"a, b\"\r\n"
                              "10,1x1,-1.5e-07,-,\"\"\"<b>\"\" & \u00b5\"\r\n"
                              "2,128x128,1 234,+7 %,\r\n");
    EXPECT_EQ(to_csv({"", {"a"}, {{"two\nlines"}, {"cr\r"}}}),
              "a\r\n\"two\nlines\"\r\n\"cr\r\"\r\n");
}

TEST(Table, HtmlHoldsEveryWordEscaped)
{
    const auto elements = test::parse_markup(to_html(kTable));
    EXPECT_EQ(elements.at(0).name, "table");
    EXPECT_EQ(test::elements_named(elements, "caption").at(0).text, "Levels");
    std::vector<std::string> words;
    for (const char* name : {"th", "td"})
        for (const auto& element : test::elements_named(elements, name))
            words.push_back(element.text);
    std::vector<std::string> expected = kTable.headings;
    for (const auto& row : kTable.rows)
        expected.insert(expected.end(), row.begin(), row.end());
    EXPECT_EQ(words, expected);
}

TEST(Table, HtmlMarksNumbers)
{
    const auto cells = test::elements_named(test::parse_markup(to_html(kTable)), "td");
    for (size_t i = 0; i < cells.size(); ++i) {
        const bool is_number = i % 5 == 0 || i % 5 == 2 || i % 5 == 3;
        EXPECT_EQ(cells[i].attributes.count("class") == 1, is_number) << cells[i].text;
    }
}

} // namespace
} // namespace scree::report
