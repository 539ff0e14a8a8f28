#pragma once

#include <vector>

#include "reference/statistics.h"

namespace scree::test {

/// One level of reference::Statistics, held whole.
struct TrueLevel {
    int width = 0, height = 0;
    std::vector<reference::Texel> texels; ///< height x width

    const reference::Texel& at(int x, int y) const
    {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

/// All levels of reference::Statistics: for maps of a test's size.
struct Truth {
    double h0 = 0, h1 = 1;
    size_t valid_texels = 0;
    std::vector<TrueLevel> levels;
};

inline Truth brute_force(const reference::StatisticsInput& input, int rank_terms = 0)
{
    const reference::Statistics statistics(input, rank_terms);
    Truth truth{statistics.h0(), statistics.h1(), statistics.valid_texels(), {}};
    for (int l = 0; l < statistics.levels(); ++l)
        truth.levels.push_back({statistics.width(l), statistics.height(l),
                                statistics.rows(l, 0, statistics.height(l))});
    return truth;
}

} // namespace scree::test
