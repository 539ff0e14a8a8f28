#include "report/page.h"

#include <utility>

#include "report/markup.h"

namespace scree::report {

namespace {

// Charts are drawn for white paper, so they keep a white card in the dark.
constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1c1f23; --paper: #ffffff; --faint: #5d666f;
        --rule: #d4d9de; --band: #f4f6f8; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7ea; --paper: #16191c; --faint: #9aa4ad; --rule: #3a4147; --band: #1f2428; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem; color: var(--ink);
       background: var(--paper); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; padding-top: .8rem;
     border-top: 1px solid var(--rule); }
p, ul { max-width: 46rem; }
.wide { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .2rem .6rem .4rem 0; }
th, td { padding: .25rem .7rem; text-align: left; white-space: nowrap; }
th { border-bottom: 2px solid var(--rule); }
td { border-bottom: 1px solid var(--rule); }
tbody tr:nth-child(even) { background: var(--band); }
.number { text-align: right; }
.card { background: #ffffff; border: 1px solid var(--rule); border-radius: 6px; margin: 1rem 0;
        padding: .5rem; width: fit-content; max-width: 100%; }
.card svg { display: block; max-width: 100%; height: auto; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
figure { margin: 0; max-width: 100%; }
figure img { display: block; max-width: 100%; height: auto; image-rendering: pixelated;
             border: 1px solid var(--rule); }
figcaption { color: var(--faint); font-size: .875rem; padding-top: .3rem; }
)";

/// Width and height of a PNG from its header chunk; 0 where the bytes are not one.
std::pair<uint32_t, uint32_t> png_size(const std::vector<uint8_t>& png)
{
    constexpr size_t kWidthAt = 16, kHeightAt = 20, kEnd = 24;
    if (png.size() < kEnd)
        return {0, 0};
    auto number = [&png](size_t at) {
        return static_cast<uint32_t>(png[at]) << 24 | static_cast<uint32_t>(png[at + 1]) << 16 |
               static_cast<uint32_t>(png[at + 2]) << 8 | static_cast<uint32_t>(png[at + 3]);
    };
    return {number(kWidthAt), number(kHeightAt)};
}

/// A small picture is shown larger, every pixel a whole number of CSS pixels.
std::string shown_size(const std::vector<uint8_t>& png)
{
    constexpr uint32_t kWorthSeeing = 240;
    const auto [width, height] = png_size(png);
    if (width == 0 || height == 0)
        return "";
    const uint32_t scale = width >= kWorthSeeing ? 1 : kWorthSeeing / width;
    return " style=\"width: " + std::to_string(width * scale) + "px\"";
}

} // namespace

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::heading(const std::string& text) { body_ += "<h2>" + escaped(text) + "</h2>\n"; }

void Page::paragraph(const std::string& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }

void Page::list(const std::vector<std::string>& items)
{
    body_ += "<ul>\n";
    for (const auto& item : items)
        body_ += "<li>" + escaped(item) + "</li>\n";
    body_ += "</ul>\n";
}

void Page::add(const Table& table)
{
    body_ += "<div class=\"wide\">" + report::to_html(table) + "</div>\n";
}

void Page::add(const Chart& chart) { body_ += "<div class=\"card\">" + to_svg(chart) + "</div>\n"; }

void Page::add(const std::vector<PageImage>& images)
{
    body_ += "<div class=\"pictures\">\n";
    for (const auto& image : images) {
        const std::string caption = escaped(image.caption);
        body_ += "<figure><img alt=\"" + caption + "\"" + shown_size(image.png);
        body_ += " src=\"data:image/png;base64," + base64(image.png);
        body_ += "\"/><figcaption>" + caption + "</figcaption></figure>\n";
    }
    body_ += "</div>\n";
}

std::string Page::to_html() const
{
    const std::string title = escaped(title_);
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
           title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + title +
           "</h1>\n" + body_ + "</body>\n</html>\n";
}

} // namespace scree::report
