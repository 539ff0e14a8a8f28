#include "report/svg.h"

#include <fmt/format.h>

#include "report/markup.h"
#include "report/numbers.h"

namespace scree::report {

std::string svg_text(const Spot& at, const std::string& words, const std::string& attributes)
{
    return fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", coordinate(at.x), coordinate(at.y),
                       attributes, escaped(words));
}

std::string svg_lines(Spot at, double line_height, const std::vector<std::string>& lines,
                      const std::string& attributes)
{
    std::string svg;
    for (const auto& words : lines) {
        svg += svg_text(at, words, attributes);
        at.y += line_height;
    }
    return svg;
}

std::string svg_line(const Spot& from, const Spot& to, const std::string& attributes)
{
    return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", coordinate(from.x),
                       coordinate(from.y), coordinate(to.x), coordinate(to.y), attributes);
}

} // namespace scree::report
