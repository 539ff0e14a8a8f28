#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kernel/visibility_table.h"
#include "support/files.h"

namespace scree::test {

/// NAME.visible.exr: visibility tables of a set.
struct VisibleTables {
    std::vector<float> cosines; ///< of the nodes, falling
    int harmonics = 0;          ///< -1: along axes
    float axis_cosine = 0.8F, axis_sine = -0.6F;
    std::vector<Image> levels;

    /// Channels of a texel by their names, in the order the C++ front wants them.
    std::vector<float> values(size_t level, int x, int y) const;

    /// The front's view of that; points into both.
    filter::VisibilityTable<float> table(const std::vector<float>& values) const;
};

/// "1A" "1B" "1G" "1R" "1c1A" .. "1s1R" "2A" .., along axes "1A" .. "1xnA" .. "1ypR" "2A" ..: as
/// OpenEXR sorts them.
std::vector<std::string> visible_channels(int nodes, int harmonics);

/// Numbers at random, levels that have nothing to do with each other, so that a lookup in the wrong
/// place shows: a and beta in [-0.3, 0.3], harmonics less.
VisibleTables random_visible_tables(int width, int height, const std::vector<float>& cosines,
                                    int harmonics);

void write_visible_tables(const std::filesystem::path& file, const VisibleTables& tables);

VisibleTables read_visible_tables(const std::filesystem::path& file);

} // namespace scree::test
