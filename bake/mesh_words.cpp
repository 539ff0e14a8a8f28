#include "bake/mesh_words.h"

#include <CLI/CLI.hpp>

#include "pipeline/named_choice.h"

namespace scree::tool {

void add_mesh_options(CLI::App& command, MeshWords& words, BakeOptions& options)
{
    auto* mesh = command.add_option_group("Mesh");
    mesh->add_option("--mesh", options.mesh_file,
                     "cage of a subdivision surface (OBJ with UVs, heights in its units) that the "
                     "texture lies on: slopes are those on its limit surface [a plane]");
    mesh->add_option("--scheme", words.scheme, "catmull-clark, or loop (triangles only)")
        ->capture_default_str();
    mesh->add_option("--boundary", words.boundary,
                     "edges of one face: edge-and-corner, edge-only or none (no surface there) "
                     "[as the file says; edge-and-corner]");
    mesh->add_option("--uv-interpolation", words.uvs,
                     "where UVs are linear: all, boundaries, corners-plus2, corners-plus1, "
                     "corners-only, none [as the file says; all]");
}

void interpret_mesh(const MeshWords& words, BakeOptions& options)
{
    SurfaceOptions& to = options.subdivision;
    to.scheme = named<Scheme>("--scheme", words.scheme,
                              {{"catmull-clark", Scheme::catmull_clark}, {"loop", Scheme::loop}});
    if (!words.boundary.empty())
        to.rules.boundary = named<BoundaryRule>("--boundary", words.boundary,
                                                {{"edge-and-corner", BoundaryRule::edge_and_corner},
                                                 {"edge-only", BoundaryRule::edge_only},
                                                 {"none", BoundaryRule::none}});
    if (!words.uvs.empty())
        to.rules.uv = named<UvRule>("--uv-interpolation", words.uvs,
                                    {{"all", UvRule::all},
                                     {"boundaries", UvRule::boundaries},
                                     {"corners-plus2", UvRule::corners_plus2},
                                     {"corners-plus1", UvRule::corners_plus1},
                                     {"corners-only", UvRule::corners_only},
                                     {"none", UvRule::none}});
}

} // namespace scree::tool
