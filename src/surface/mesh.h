#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "surface/subdivision.h"

namespace scree {

/// The edge between two vertices, kept sharp for so many subdivisions; 10 and above: for ever.
struct Crease {
    int from = 0, to = 0;
    double sharpness = 0;
};

/// The same for a vertex.
struct SharpCorner {
    int vertex = 0;
    double sharpness = 0;
};

/// A cage: polygons with texture coordinates, which may differ from face to face at one vertex.
/// Indices count from 0.
struct Mesh {
    std::string name;           ///< what messages call it: the file
    std::vector<Vec3> vertices; ///< world units, finite
    std::vector<Vec2> uvs;      ///< u to the right, v UP, as OBJ has them; finite

    std::vector<int> face_sizes;    ///< corners of each face, 3 and up
    std::vector<int> face_vertices; ///< of all corners of all faces, in order, counterclockwise
                                    ///< seen from outside
    std::vector<int> face_uvs;      ///< the same, into `uvs`

    std::vector<Crease> creases;
    std::vector<SharpCorner> corners;
    std::vector<int> holes; ///< faces that count for their neighbours but have no surface
    SubdivisionRules rules; ///< as the file asks for them
};

} // namespace scree
