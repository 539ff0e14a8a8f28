#include "visibility/line_path.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

int whole(double position) { return static_cast<int>(std::floor(position)); }
float part(double position) { return static_cast<float>(position - std::floor(position)); }

} // namespace

LineNode LinePath::node(double past_centre, double drop, int column, float across) const
{
    const double along = past_centre * away_;
    const bool is_before = along < 0;
    return {is_before ? row_ - 1 : row_, column, static_cast<float>(is_before ? along + 1 : along),
            across, static_cast<float>(drop)};
}

void LinePath::add(double past_centre, int column, float across)
{
    nodes[node_count++] = node(past_centre, past_centre - last_, column, across);
    pieces[piece_count - 1].end = node_count;
    last_ = past_centre;
}

LinePath::LinePath(int row, int away, double enter, double centre, double leave, bool columns)
    : row_(row), away_(away)
{
    beginning = node(last_, 0, whole(enter), part(enter));
    // Counted the way lines go, columns of texel centres are even halves, of edges odd ones.
    const int sign = leave >= enter ? 1 : -1;
    const double from = sign * enter, to = sign * leave;
    pieces[piece_count++].texel = sign * whole((columns ? from : sign * centre) + 0.5);
    bool is_centre_past = false;
    const auto pass_centre = [&] {
        add(0, whole(centre), part(centre));
        is_centre_past = true;
    };
    for (int half = whole(2 * from) + 1; columns && half <= 2 * to; ++half) {
        const double past_centre = std::clamp((0.5 * half - from) / (to - from) - 0.5, -0.5, 0.5);
        if (past_centre > 0 && !is_centre_past)
            pass_centre();
        const bool is_edge = half % 2 != 0;
        add(past_centre, whole(0.5 * sign * half), is_edge ? 0.5F : 0.0F);
        if (is_edge) {
            pieces[piece_count] = {pieces[piece_count - 1].texel + sign, node_count, node_count};
            ++piece_count;
        }
    }
    if (!is_centre_past)
        pass_centre();
    add(0.5, whole(leave), part(leave));
}

} // namespace scree
