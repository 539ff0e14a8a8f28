#pragma once

#include <string>

#include "pipeline/options.h"

namespace CLI {
class App;
}

namespace scree::tool {

/// What the command line says of the mesh a texture lies on.
struct MeshWords {
    std::string scheme;        ///< empty: catmull-clark
    std::string boundary, uvs; ///< empty: as the file says
};

/// Adds a group of options; --mesh goes into `options` by itself.
void add_mesh_options(CLI::App& command, MeshWords& words, BakeOptions& options);

/// Makes options of the rest. Throws Error for unknown words.
void interpret_mesh(const MeshWords& words, BakeOptions& options);

} // namespace scree::tool
