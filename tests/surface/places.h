#pragma once

#include <random>

#include "surface/limit_surface.h"

namespace scree::test {

inline SurfaceOptions options_of(Scheme scheme, BoundaryRule boundary, UvRule uv)
{
    SurfaceOptions options;
    options.scheme = scheme;
    options.rules.boundary = boundary;
    options.rules.uv = uv;
    options.rules.creases = CreaseRule::uniform;
    options.rules.triangles = TriangleRule::catmull_clark;
    return options;
}

/// Calls visit(face, piece index, piece, place) for places all over the mesh but within 1 % of the
/// corners, where Bfr and Far may stop refining differently.
template <class Visit>
void at_places(const LimitSurface& surface, int places, const Visit& visit)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> law(0.01, 0.99);
    for (int index = 0; index < surface.face_count(); ++index) {
        const FaceSurface face = surface.face(index);
        for (size_t i = 0; i < face.pieces().size(); ++i)
            for (int k = 0; k < places; ++k) {
                Vec2 at(law(engine), law(engine));
                if (face.pieces()[i].triangle && at.x + at.y > 0.99)
                    at = at * 0.5;
                visit(face, index, i, face.pieces()[i],
                      face.pieces()[i].origin + at * face.pieces()[i].size);
            }
    }
}

} // namespace scree::test
