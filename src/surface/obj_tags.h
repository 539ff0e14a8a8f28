#pragma once

#include <string>
#include <vector>

#include "surface/mesh.h"

namespace scree {

/// A line "t NAME ints/reals/strings ..." of an OBJ file, as OpenSubdiv's own meshes have them.
struct ObjTag {
    std::string name;
    std::vector<int> ints;
    std::vector<double> reals;
    std::vector<std::string> strings;
};

/// Applies subdivision tags to a mesh that has its vertices and faces.
///
/// crease       pairs of vertices (from 0) and one sharpness for all or one a pair
/// corner       vertices and one sharpness for all or one each
/// hole         faces
/// interpolateboundary             0 none, 1 edge and corner, 2 edge only
/// facevaryinginterpolateboundary  0 none, 1 corners only, 2, 3 corners plus 1, 2, 4 boundaries,
///                                 5 all; facevaryinginterpolate is taken for the same
/// creasemethod                    normal, chaikin
/// smoothtriangles                 catmark, smooth
///
/// returns names of tags that are not known and were left out, each once
/// throws Error: arguments too few, unknown or out of range
std::vector<std::string> apply_tags(const std::vector<ObjTag>& tags, Mesh& mesh);

} // namespace scree
