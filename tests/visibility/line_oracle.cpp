#include "visibility/line_oracle.h"

#include <algorithm>

namespace scree::test {

long double seen_of_piece(const std::vector<ProfileNode>& nodes, std::size_t far,
                          long double cotangent)
{
    const ProfileNode& begin = nodes[far - 1];
    const long double run = nodes[far].away - begin.away;
    const long double rise = nodes[far].height - begin.height;
    long double from = 0, to = 1; // visible, of the piece
    for (std::size_t i = 0; i < far; ++i) {
        // A point at u is hidden where the sight from it runs below the node:
        // begin.height + u rise + (begin.away + u run - node.away) cot < node.height.
        const ProfileNode& node = nodes[i];
        const long double at_begin =
            begin.height + (begin.away - node.away) * cotangent - node.height;
        const long double slope = rise + run * cotangent;
        if (slope > 0)
            from = std::max(from, -at_begin / slope);
        else if (slope < 0)
            to = std::min(to, -at_begin / slope);
        else if (at_begin < 0)
            return 0;
    }
    // W = cos theta - sin theta (slope towards the viewer), over cos theta; towards him is -away.
    const long double shown = run + rise / cotangent;
    return std::max(0.0L, to - from) * std::max(0.0L, shown);
}

} // namespace scree::test
