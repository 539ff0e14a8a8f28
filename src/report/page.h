#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/chart.h"
#include "report/table.h"

namespace scree::report {

/// A picture within a page: PNG bytes with a caption.
struct PageImage {
    std::vector<uint8_t> png;
    std::string caption;
};

/// One HTML page that needs nothing beside itself: style, charts and pictures are inside.
class Page {
public:
    /// title  of the page, its first heading too
    explicit Page(std::string title);

    void heading(const std::string& text);
    void paragraph(const std::string& text);
    void list(const std::vector<std::string>& items);
    void add(const Table& table);
    void add(const Chart& chart);
    /// Pictures side by side.
    void add(const std::vector<PageImage>& images);

    [[nodiscard]] std::string to_html() const;

private:
    std::string title_, body_;
};

} // namespace scree::report
