#include "texset/cpt_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "color/refined_map.h"
#include "math/error.h"
#include "texset/cpt_lines.h"

namespace scree {

namespace {

/// Of the largest color: how well knots follow lines that are straight in HSV.
constexpr double kHsvTolerance = 1e-5;

/// The color as the file's model has it.
Rgb modelled(const CptColor& color, bool hsv_model)
{
    if (color.hsv == hsv_model)
        return color.value;
    return hsv_model ? hsv_of_rgb(color.value) : rgb_of_hsv(color.value);
}

std::string place(const std::filesystem::path& path, const CptPiece& piece)
{
    return fmt::format("{}: line {}", path.string(), piece.line);
}

/// Pieces that follow on each other.
std::vector<Knot> knots_of_pieces(const CptLines& lines, const std::filesystem::path& path)
{
    std::vector<Knot> knots;
    for (const CptPiece& piece : lines.pieces) {
        double z0 = piece.z0;
        if (!knots.empty()) {
            const double before = knots.back().x;
            // Numbers are printed to some digits: a piece may start that much off.
            if (std::abs(z0 - before) > 1e-4 * (piece.z1 - z0))
                throw Error(fmt::format("{}: starts at z = {}, the line before ended at {}; the "
                                        "pieces must follow on each other",
                                        place(path, piece), z0, before));
            z0 = before;
        }
        knots.push_back({z0, modelled(piece.color0, lines.hsv_model)});
        knots.push_back({piece.z1, modelled(piece.color1, lines.hsv_model)});
    }
    return knots;
}

/// Categories: a jump halfway between neighbours.
std::vector<Knot> knots_of_categories(const CptLines& lines, const std::filesystem::path& path)
{
    std::vector<Knot> knots;
    for (const CptPiece& piece : lines.pieces) {
        const Rgb color = modelled(piece.color0, lines.hsv_model);
        if (!knots.empty()) {
            const double before = knots.back().x;
            if (!(before < piece.z0))
                throw Error(fmt::format("{}: z = {} after {}; the z of categories must rise",
                                        place(path, piece), piece.z0, before));
            const double halfway = before + (piece.z0 - before) / 2;
            knots.push_back({halfway, knots.back().color});
            knots.push_back({halfway, color});
        }
        knots.push_back({piece.z0, color});
    }
    return knots;
}

} // namespace

ColorMapFile read_cpt(const std::filesystem::path& path)
{
    const CptLines lines = read_cpt_lines(path);
    std::vector<Knot> knots =
        lines.categories ? knots_of_categories(lines, path) : knots_of_pieces(lines, path);
    const double first = knots.front().x, last = knots.back().x;
    const bool from_minus_one = first == -1 && last == 1;
    const bool normalised = !lines.categories && ((first == 0 && last == 1) || from_minus_one);
    const bool states_range = !normalised || lines.range;
    if (states_range && lines.below)
        knots.insert(knots.begin(), Knot{first, modelled(*lines.below, lines.hsv_model)});
    if (states_range && lines.above)
        knots.push_back({last, modelled(*lines.above, lines.hsv_model)});

    ColorMapFile file{ColorMap(std::move(knots)), states_range, {}, "sRGB", "cpt"};
    if (lines.hsv_model)
        file.map = refined(file.map, rgb_of_hsv, kHsvTolerance);
    const bool hinged = from_minus_one && (lines.hard_hinge || (lines.soft_hinge && lines.range));
    if (normalised && lines.range) {
        const auto [low, high] = *lines.range;
        file.map = hinged ? file.map.stretched(low, high, {0, lines.hinge})
                          : file.map.stretched(low, high);
    }
    const double hinge_at = states_range ? lines.hinge : 0;
    if (lines.hard_hinge && file.map.first() < hinge_at && hinge_at < file.map.last())
        file.hinge = ColorMap::Hinge{hinge_at, lines.hinge};
    return file;
}

} // namespace scree
