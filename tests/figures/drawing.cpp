#include "figures/drawing.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <map>

namespace scree::test {

using report::Spot;

std::string drawing(double width, double height, const std::string& elements)
{
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                       "font-family=\"sans-serif\" font-size=\"12\">\n{2}{3}</svg>\n",
                       width, height, filled_rectangle({0, 0}, width, height, "#ffffff"), elements);
}

std::string centred_text(const Spot& at, const std::string& words, const std::string& more)
{
    return report::svg_text(at, words, "text-anchor=\"middle\"" + (more.empty() ? "" : " " + more));
}

std::string filled_rectangle(const Spot& corner, double width, double height,
                             const std::string& fill)
{
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       corner.x, corner.y, width, height, fill);
}

size_t step_of(const std::vector<ColorStep>& steps, double value)
{
    size_t i = 0;
    while (i + 1 < steps.size() && !(value < steps[i].below))
        ++i;
    return i;
}

std::string cell_map(const Spot& corner, double width, double height, int columns, int rows,
                     const std::function<std::string(int, int)>& color)
{
    // Neighbours of one color in a stroke, all strokes of one color in a path.
    std::map<std::string, std::string> paths;
    for (int row = 0; row < rows; ++row)
        for (int column = 0, end = 0; column < columns; column = end) {
            const std::string here = color(column, row);
            for (end = column + 1; end < columns && color(end, row) == here;)
                ++end;
            if (!here.empty())
                paths[here] += fmt::format("M{} {}h{}", column, row, end - column);
        }
    std::string svg = fmt::format("<g transform=\"translate({} {}) scale({} {})\" fill=\"none\" "
                                  "shape-rendering=\"crispEdges\">\n",
                                  corner.x, corner.y + height / 2, width, height);
    for (const auto& [stroke, path] : paths)
        svg += fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", stroke, path);
    return svg + "</g>\n";
}

std::string color_key(Spot corner, double step, const std::vector<ColorStep>& colors)
{
    std::string svg;
    for (const ColorStep& color : colors) {
        svg += filled_rectangle(corner, 14, 14, color.fill) +
               report::svg_text({corner.x + 20, corner.y + 12}, color.label, "");
        corner.x += step;
    }
    return svg;
}

int draw_to_file(int argc, char** argv, const std::function<std::string()>& draw)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s OUTPUT.svg\n", argv[0]);
        return 2;
    }
    std::ofstream out(argv[1]);
    out << draw();
    out.close();
    if (out.fail()) {
        std::fprintf(stderr, "%s: cannot be written\n", argv[1]);
        return 1;
    }
    return 0;
}

} // namespace scree::test
