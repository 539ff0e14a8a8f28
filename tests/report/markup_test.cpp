// Escapes, base64, and the tests' own reader of markup.

#include "report/markup.h"

#include <gtest/gtest.h>

#include "support/markup.h"

namespace scree::report {
namespace {

std::vector<uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Markup, Base64IsThatOfRfc4648)
{
    // Section 10 of the RFC, and the two digits that are not letters.
    const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                      {"f", "Zg=="},
                                                                      {"fo", "Zm8="},
                                                                      {"foo", "Zm9v"},
                                                                      {"foob", "Zm9vYg=="},
                                                                      {"fooba", "Zm9vYmE="},
                                                                      {"foobar", "Zm9vYmFy"},
                                                                      {"\xfb\xff\xfe", "+//+"}};
    for (const auto& [plain, coded] : vectors)
        EXPECT_EQ(base64(bytes(plain)), coded) << plain;
}

TEST(Markup, EscapedTextReadsBackAsItWas)
{
    const std::string text = "a < b && \"c\" > 'd' &lt; \u00b5\nlast";
    const auto inside = test::parse_markup("<a>" + escaped(text) + "</a>");
    EXPECT_EQ(inside.at(0).text, text);
    const auto quoted = test::parse_markup("<a b=\"" + escaped(text) + "\"/>");
    EXPECT_EQ(quoted.at(0).attributes.at("b"), text);
}

TEST(Markup, ControlCharactersBecomeTheReplacementCharacter)
{
    EXPECT_EQ(escaped(std::string("a\0b\x1f", 4)), "a\ufffdb\ufffd");
}

TEST(Markup, PrintedWidthCountsCharactersNotBytes)
{
    EXPECT_EQ(printed_width(""), 0U);
    EXPECT_EQ(printed_width("abc"), 3U);
    EXPECT_EQ(printed_width("\u03bc \u2212 \U0001d54f"), 5U);
}

// What the other tests lean on: faults are found.
TEST(Markup, TheReaderRefusesWhatIsNotWellFormed)
{
    for (const char* text : {"", "a", "<a>", "<a></b>", "<a/><b/>", "<a b=c/>",
                             "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "<a>&nbsp;</a>", "<a b=\"<\"/>",
                             "<a b=\"1\"c=\"2\"/>", "<a>\x01</a>", "<a></a></a>", "<a><b></a></b>"})
        EXPECT_THROW(test::parse_markup(text), std::runtime_error) << text;
    EXPECT_NO_THROW(test::parse_markup("<!DOCTYPE html>\n<a b=\"1\" c=\"2\"><d/>e</a>\n"));
}

} // namespace
} // namespace scree::report
