#pragma once

#include <string>
#include <vector>

#include "sample/field.h"
#include "support/memory_source.h"

namespace scree::test {

/// A built-in sample in memory, to bake from.
inline MemorySource sample_source(const SampleField& field, int width, int height)
{
    MemorySource source;
    source.map_width = width;
    source.map_height = height;
    std::vector<float> heights(static_cast<size_t>(width)), rgb(3 * heights.size());
    for (int y = 0; y < height; ++y) {
        field.row(y, heights.data(), rgb.data());
        source.heights.insert(source.heights.end(), heights.begin(), heights.end());
        for (size_t x = 0; x < heights.size(); ++x)
            source.colors.push_back({rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2]});
    }
    return source;
}

} // namespace scree::test
