#include "bake/mesh_words.h"

#include <CLI/CLI.hpp>

#include "math/error.h"
#include "pipeline/mesh_options.h"

namespace scree::tool {

void add_mesh_options(CLI::App& command, MeshWords& words, BakeOptions& options)
{
    auto* mesh = command.add_option_group("Mesh");
    mesh->add_option("--mesh", options.mesh_file,
                     "cage of a subdivision surface (OBJ with UVs, heights in its units) that the "
                     "texture lies on: slopes are those on its limit surface [a plane]");
    mesh->add_option("--scheme", words.scheme,
                     "catmull-clark, or loop (triangles only) [catmull-clark]");
    mesh->add_option("--boundary", words.boundary,
                     "edges of one face: edge-and-corner, edge-only or none (no surface there) "
                     "[as the file says; edge-and-corner]");
    mesh->add_option("--uv-interpolation", words.uvs,
                     "where UVs are linear: all, boundaries, corners-plus2, corners-plus1, "
                     "corners-only, none [as the file says; all]");
}

void interpret_mesh(const MeshWords& words, BakeOptions& options)
{
    const bool any = !words.scheme.empty() || !words.boundary.empty() || !words.uvs.empty();
    if (any && options.mesh_file.empty())
        throw Error("--scheme, --boundary and --uv-interpolation speak of a mesh; give --mesh");
    SurfaceOptions& to = options.subdivision;
    if (!words.scheme.empty())
        to.scheme = scheme_named(words.scheme);
    if (!words.boundary.empty())
        to.rules.boundary = boundary_named(words.boundary);
    if (!words.uvs.empty())
        to.rules.uv = uv_interpolation_named(words.uvs);
}

} // namespace scree::tool
