#include "pipeline/gutter.h"

#include <cstring>

namespace scree {

namespace {

uint8_t sources_of(const RingRows& rows, int width, bool periodic, int x, int wanted)
{
    const Ring* const lines[] = {rows.above, rows.row, rows.below};
    unsigned sources = 0;
    for (size_t i = 0; i < kNeighbours.size(); ++i) {
        const Ring* line = lines[kNeighbours[i].dy + 1];
        int column = x + kNeighbours[i].dx;
        if (periodic)
            column = column < 0 ? width - 1 : column == width ? 0 : column;
        if (line != nullptr && column >= 0 && column < width && line[column] == wanted)
            sources |= 1U << i;
    }
    return static_cast<uint8_t>(sources);
}

} // namespace

void grow_ring(const RingRows& rows, int width, bool periodic, Ring ring,
               std::vector<GutterTexel>& grown)
{
    if (std::memchr(rows.row, kBeyondGutter, static_cast<size_t>(width)) == nullptr)
        return;
    for (int x = 0; x < width; ++x) {
        if (rows.row[x] != kBeyondGutter)
            continue;
        const uint8_t sources = sources_of(rows, width, periodic, x, ring - 1);
        if (sources == 0)
            continue;
        rows.row[x] = ring;
        grown.push_back({x, sources});
    }
}

} // namespace scree
