// A page holds all it shows.

#include "report/page.h"

#include <gtest/gtest.h>

#include "report/markup.h"
#include "support/markup.h"
#include "texset/picture.h"

namespace scree::report {
namespace {

using test::elements_named;

Picture gray(int width, int height)
{
    return {width, height,
            std::vector<float>(3 * static_cast<size_t>(width) * static_cast<size_t>(height), 0.5F)};
}

Page full_page()
{
    Page page("Bricks & <mortar>");
    page.paragraph("An error of 3 < 4.");
    page.heading("Levels & views");
    page.list({"first", "second & \"last\""});
    page.add(Table{"", {"a", "b"}, {{"1", "<x>"}}});
    Chart chart;
    chart.title = "G1";
    chart.series = {{"truth", {{1, 2, "p", false, 0, 0}}, false}};
    page.add(chart);
    page.add({{png_bytes(gray(40, 20)), "naive"}, {png_bytes(gray(500, 10)), "set > naive"}});
    return page;
}

TEST(Page, IsWellFormedAndHoldsWhatWasAdded)
{
    const auto html = test::parse_markup(full_page().to_html());
    EXPECT_EQ(elements_named(html, "title").at(0).text, "Bricks & <mortar>");
    EXPECT_EQ(elements_named(html, "h1").at(0).text, "Bricks & <mortar>");
    EXPECT_EQ(elements_named(html, "h2").at(0).text, "Levels & views");
    EXPECT_EQ(elements_named(html, "p").at(0).text, "An error of 3 < 4.");
    EXPECT_EQ(elements_named(html, "li").at(1).text, "second & \"last\"");
    EXPECT_EQ(elements_named(html, "td").at(1).text, "<x>");
    EXPECT_EQ(elements_named(html, "svg").size(), 1U);
    EXPECT_EQ(elements_named(html, "figcaption").at(1).text, "set > naive");
}

TEST(Page, NeedsNothingBesideItself)
{
    const std::string text = full_page().to_html();
    for (const auto& element : test::parse_markup(text)) {
        for (const char* outside : {"script", "link", "iframe", "object", "image", "use"})
            EXPECT_NE(element.name, outside);
        for (const char* key : {"src", "href", "xlink:href"})
            if (element.attributes.count(key) != 0) {
                EXPECT_EQ(element.attributes.at(key).rfind("data:image/png;base64,", 0), 0U) << key;
            }
    }
    for (const char* fetch : {"@import", "url("})
        EXPECT_EQ(text.find(fetch), std::string::npos) << fetch;
}

TEST(Page, PicturesAreInItByteByByteAndSmallOnesAreShownLarger)
{
    const auto images = elements_named(test::parse_markup(full_page().to_html()), "img");
    ASSERT_EQ(images.size(), 2U);
    EXPECT_EQ(images[0].attributes.at("src"),
              "data:image/png;base64," + base64(png_bytes(gray(40, 20))));
    EXPECT_EQ(images[0].attributes.at("style"), "width: 240px");
    EXPECT_EQ(images[1].attributes.at("style"), "width: 500px");
}

} // namespace
} // namespace scree::report
