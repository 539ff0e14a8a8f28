#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "texset/cpt_colors.h"

namespace scree {

/// One line of colors of a .cpt.
struct CptPiece {
    int line = 0;
    double z0 = 0, z1 = 0; ///< equal for a category
    CptColor color0, color1;
};

/// What a .cpt says, line by line, before it is put together.
struct CptLines {
    std::vector<CptPiece> pieces;
    bool categories = false; ///< the pieces are categories, all of them
    bool hsv_model = false;
    bool hard_hinge = false, soft_hinge = false;
    double hinge = 0; ///< height that z = 0 stands for, where there is a hinge
    std::optional<std::array<double, 2>> range;
    std::optional<CptColor> below, above; ///< the B and F lines
};

/// Throws Error naming the file and the line.
CptLines read_cpt_lines(const std::filesystem::path& path);

} // namespace scree
