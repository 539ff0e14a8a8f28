#include "surface/uv_search.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double kTolerance = 1e-9;
constexpr int kMostSteps = 16;
/// A root on the border may be overshot once and missed by rounding once; one beyond it is left
/// again and again.
constexpr int kMostAtBorder = 3;

} // namespace

std::optional<UvHit> find_uv(const FaceSurface& face, const ParameterPiece& piece, const Vec2& uv,
                             const Vec2& start)
{
    UvHit hit;
    hit.place = piece.clamp(start);
    int at_border = 0;
    for (int step = 0; step < kMostSteps; ++step) {
        hit.uv = face.uv_at(hit.place);
        const Vec2 missing = uv - hit.uv.uv;
        if (std::max(std::abs(missing.x), std::abs(missing.y)) <= kTolerance)
            return hit;
        const double determinant = hit.uv.by_p % hit.uv.by_q;
        if (!(std::abs(determinant) > 0))
            return std::nullopt;
        const Vec2 free(hit.place.x + (missing % hit.uv.by_q) / determinant,
                        hit.place.y + (hit.uv.by_p % missing) / determinant);
        const Vec2 next = piece.clamp(free);
        at_border = next == free ? 0 : at_border + 1;
        if (next == hit.place || at_border > kMostAtBorder)
            return std::nullopt;
        hit.place = next;
    }
    return std::nullopt;
}

} // namespace scree
