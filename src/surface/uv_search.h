#pragma once

#include <optional>

#include "surface/limit_surface.h"

namespace scree {

/// Where a face shows a point of the texture.
struct UvHit {
    Vec2 place{0, 0}; ///< parameters of the face
    UvPoint uv;
};

/// Newton's method, kept inside the piece. Takes a place whose texture coordinates are within 1e-9
/// of those asked for: 6e-5 of a texel of 65536.
///
/// start  parameters near the place; they need not be inside
/// returns nothing where the piece does not show the point, or the method does not converge from
///        there (folded texture coordinates)
std::optional<UvHit> find_uv(const FaceSurface& face, const ParameterPiece& piece, const Vec2& uv,
                             const Vec2& start);

} // namespace scree
