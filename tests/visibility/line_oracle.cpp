#include "visibility/line_oracle.h"

#include <algorithm>

namespace scree::test {

namespace {

struct Node {
    long double away; ///< from the viewer, world units
    long double height;
};

/// Part of a piece, [0, 1], that no nearer node hides, times what it shows of itself.
long double seen_of_piece(const Node& near, const Node& far, const std::vector<Node>& nearer,
                          long double cotangent)
{
    const long double run = far.away - near.away;
    const long double rise = far.height - near.height;
    long double from = 0, to = 1;
    for (const Node& node : nearer) {
        // A point at u is hidden where the sight from it runs below the node:
        // near.height + u rise + (near.away + u run - node.away) cot < node.height.
        const long double at_near = near.height + (near.away - node.away) * cotangent - node.height;
        const long double slope = rise + run * cotangent;
        if (slope > 0)
            from = std::max(from, -at_near / slope);
        else if (slope < 0)
            to = std::min(to, -at_near / slope);
        else if (at_near < 0)
            return 0;
    }
    // W = cos theta - sin theta (slope towards the viewer), over cos theta; towards him is -away.
    const long double facing = 1 + rise / run / cotangent;
    return std::max(0.0L, to - from) * run * std::max(0.0L, facing);
}

} // namespace

long double seen_of_line(const Profile& height_at, int place, int away, int reach,
                         long double length, long double cotangent)
{
    std::vector<Node> nodes;
    for (int half = -2 * reach - 1; half <= 1; ++half)
        nodes.push_back({half * length / 2, height_at(place + 0.5 * half * away)});
    const size_t n = nodes.size();
    long double seen = 0;
    for (size_t far = n - 2; far < n; ++far) {
        const std::vector<Node> nearer(nodes.begin(), nodes.begin() + static_cast<long>(far));
        seen += seen_of_piece(nodes[far - 1], nodes[far], nearer, cotangent);
    }
    return seen / length;
}

} // namespace scree::test
