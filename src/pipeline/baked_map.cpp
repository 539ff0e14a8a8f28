#include "pipeline/baked_map.h"

namespace scree {

namespace {

BakeOptions options_of_tile(BakeOptions options, int tile)
{
    options.height_file = file_of_tile(options.height_file, tile);
    options.color_file = file_of_tile(options.color_file, tile);
    return options;
}

} // namespace

BakedMap::BakedMap(Source& source, const BakeOptions& options) : options_(options), given_(&source)
{}

BakedMap::BakedMap(const BakeOptions& options, int tile)
    : options_(options_of_tile(options, tile)), number_(tile),
      files_(std::make_unique<FileSource>(options_))
{}

Source& BakedMap::source() const
{
    if (mesh_)
        return *mesh_;
    if (files_)
        return *files_;
    return *given_;
}

void BakedMap::lay_on(const BakedMesh& mesh, const std::filesystem::path& folder,
                      const BakeMonitor& monitor)
{
    mesh_ = std::make_unique<MeshSource>(source(), mesh, tile(), folder, monitor);
}

} // namespace scree
