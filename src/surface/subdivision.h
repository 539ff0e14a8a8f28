#pragma once

#include <optional>

namespace scree {

/// How a cage becomes a smooth surface.
enum class Scheme {
    catmull_clark, ///< faces of any number of corners
    loop,          ///< triangles only
};

/// What the surface does at edges of the cage that have one face.
enum class BoundaryRule {
    none,            ///< faces at a boundary have no surface
    edge_only,       ///< the boundary is a smooth curve; corners are rounded
    edge_and_corner, ///< the same, but vertices of a single face stay where they are
};

/// Where texture coordinates are interpolated linearly; elsewhere as smoothly as positions.
enum class UvRule {
    none,          ///< nowhere; the borders of charts are smooth curves
    corners_only,  ///< at corners of charts
    corners_plus1, ///< also where several charts meet, and at darts
    corners_plus2, ///< also at concave corners
    boundaries,    ///< along the borders of charts
    all,           ///< everywhere: bilinear inside each face of the cage
};

/// How a sharpness falls from one subdivision to the next.
enum class CreaseRule { uniform, chaikin };

/// Weights of triangles in Catmull-Clark subdivision.
enum class TriangleRule { catmull_clark, smooth };

/// The rules of a surface, named as OpenSubdiv names them; what is empty is taken from elsewhere.
struct SubdivisionRules {
    std::optional<BoundaryRule> boundary;
    std::optional<UvRule> uv;
    std::optional<CreaseRule> creases;
    std::optional<TriangleRule> triangles;
};

/// The rules that hold: those asked for, else those of the file, else the defaults
/// (SurfaceOptions). None is empty.
inline SubdivisionRules rules_in_effect(const SubdivisionRules& asked, const SubdivisionRules& file)
{
    const auto chosen = [](auto first, auto second, auto otherwise) {
        return first ? *first : second.value_or(otherwise);
    };
    return {chosen(asked.boundary, file.boundary, BoundaryRule::edge_and_corner),
            chosen(asked.uv, file.uv, UvRule::all),
            chosen(asked.creases, file.creases, CreaseRule::uniform),
            chosen(asked.triangles, file.triangles, TriangleRule::catmull_clark)};
}

} // namespace scree
