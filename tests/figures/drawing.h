#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/svg.h"

namespace scree::test {

// What the programs that draw a figure of docs/ share. Places are CSS pixels, y down; the functions
// give elements of an SVG document.

/// The document around what is drawn: white paper, letters of 12 pixels.
std::string drawing(double width, double height, const std::string& elements);

/// Words with their middle at a place. more  further attributes, such as font-weight="bold"
std::string centred_text(const report::Spot& at, const std::string& words,
                         const std::string& more = "");

std::string filled_rectangle(const report::Spot& corner, double width, double height,
                             const std::string& fill);

/// Values below this have the color, and are named so in the key.
struct ColorStep {
    const char* fill;
    double below; ///< rising; of the last step it does not count
    const char* label;
};

/// The first step above a value; of NaN and of values above all steps the last one.
size_t step_of(const std::vector<ColorStep>& steps, double value);

/// A map of colored cells.
///
/// corner         upper left
/// width, height  of a cell
/// color          of (column, row), row 0 uppermost; empty: the cell stays as it is
std::string cell_map(const report::Spot& corner, double width, double height, int columns, int rows,
                     const std::function<std::string(int, int)>& color);

/// A square of each color with its label, in a row; `step` pixels from one to the next.
std::string color_key(report::Spot corner, double step, const std::vector<ColorStep>& colors);

/// The main() of such a program: one word, the file to write.
int draw_to_file(int argc, char** argv, const std::function<std::string()>& draw);

} // namespace scree::test
