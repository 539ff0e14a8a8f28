#include "pipeline/surface.h"

#include <utility>

#include "math/error.h"

namespace scree {

namespace {

std::array<double, 2> texel_size(const Source& source, const BakeOptions& options)
{
    const auto w = static_cast<double>(source.width()), h = static_cast<double>(source.height());
    if (!options.mesh_file.empty())
        return {1 / w, 1 / h}; // of the texture: the mesh knows how large that is
    if (options.texel_size)
        return *options.texel_size;
    if (options.world_size) {
        const double texel_width = (*options.world_size)[0] / w;
        return {texel_width,
                options.world_height_given ? (*options.world_size)[1] / h : texel_width};
    }
    return {1 / w, 1 / w}; // the map is one unit wide, its texels square
}

} // namespace

Surface::Surface(Source& from, const BakeOptions& given, const BakeMonitor& watch, Survey survey,
                 const ColorMapInput* color_map)
    : source(from), options(given), monitor(watch), found(std::move(survey)),
      texel(texel_size(from, given))
{
    if (color_map == nullptr)
        return;
    if (given.map_by == MapBy::height && !from.has_heights())
        throw Error("--colormap: goes by height, and a normal map has none; give --map-by slope");
    mapped = placed(*color_map, given, found);
}

} // namespace scree
