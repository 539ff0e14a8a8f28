#include "pipeline/bake.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "math/error.h"
#include "pipeline/file_source.h"
#include "pipeline/level_statistics.h"
#include "pipeline/storage_error.h"
#include "pipeline/survey.h"
#include "pipeline/warnings.h"
#include "pipeline/write_pass.h"
#include "texset/image_threads.h"
#include "texset/staged_folder.h"
#include "version.h"

namespace scree {

namespace {

std::vector<Map> choose_maps(const Source& source, const BakeOptions& options, bool complete)
{
    std::vector<Map> maps;
    if (options.layout == Layout::bumpslopes)
        return {Map::bumpslopes};
    maps = options.maps;
    if (maps.empty()) {
        maps = {Map::slope, Map::tail};
        if (source.has_heights())
            maps.push_back(Map::height);
        if (source.has_color())
            maps.insert(maps.end(), {Map::color, Map::colorslope});
        if (source.has_color() && source.has_heights())
            maps.push_back(Map::colorheight);
    }
    for (const Map map : maps) {
        MomentSet needs;
        require_moments(map, needs);
        if (needs.height && !source.has_heights())
            throw Error(fmt::format("--maps {}: needs heights, and a normal map has none",
                                    map_info(map).name));
        if (needs.color && !source.has_color())
            throw Error(
                fmt::format("--maps {}: needs a color map; give --color", map_info(map).name));
    }
    if (!complete)
        maps.push_back(Map::coverage);
    std::sort(maps.begin(), maps.end());
    maps.erase(std::unique(maps.begin(), maps.end()), maps.end());
    return maps;
}

MomentLayout moments_for(const std::vector<Map>& maps, const Source& source)
{
    MomentSet set;
    set.slope = false;
    for (const Map map : maps)
        require_moments(map, set);
    set.height = set.height && source.has_heights();
    return MomentLayout(set);
}

std::array<double, 2> texel_size(const Source& source, const BakeOptions& options)
{
    const auto w = static_cast<double>(source.width()), h = static_cast<double>(source.height());
    if (options.texel_size)
        return *options.texel_size;
    if (options.world_size) {
        const double texel_width = (*options.world_size)[0] / w;
        return {texel_width,
                options.world_height_given ? (*options.world_size)[1] / h : texel_width};
    }
    return {1 / w, 1 / w}; // the map is one unit wide, its texels square
}

Attributes attributes_of(Map map, const Manifest& manifest)
{
    Attributes attributes = {{"textureformat", std::string("Plain Texture")},
                             {"wrapmodes", manifest.wrap_s + "," + manifest.wrap_t},
                             {"Software", "scree " + manifest.program_version},
                             {"scree:set", manifest.name},
                             {"scree:map", map_info(map).name},
                             {"scree:meaning", map_info(map).meaning},
                             {"scree:axes", std::string("s right, t down")},
                             {"scree:texelWidth", manifest.texel_width},
                             {"scree:texelHeight", manifest.texel_height},
                             {"scree:reconstruction", manifest.reconstruction}};
    if (manifest.has_height) {
        attributes.emplace_back("scree:h0", manifest.h0);
        attributes.emplace_back("scree:h1", manifest.h1);
    }
    if (!manifest.working_space.empty())
        attributes.emplace_back("scree:workingSpace", manifest.working_space);
    return attributes;
}

/// Chooses a pixel type for every map, measuring when asked to.
std::vector<TextureRecord> choose_types(const std::vector<Map>& maps, Source& source,
                                        const Survey& found, const MomentLayout& layout,
                                        const TexelMoments& texels, const ValueScale& scale,
                                        const BakeOptions& options, const std::string& name,
                                        const BakeMonitor& monitor)
{
    std::vector<TextureRecord> textures;
    for (const Map map : maps) {
        TextureRecord texture;
        texture.map = map;
        texture.file = fmt::format("{}.{}.exr", name, map_info(map).name);
        texture.type =
            options.pixel_type == PixelTypeChoice::half ? PixelType::half : PixelType::float32;
        textures.push_back(texture);
    }
    if (options.pixel_type != PixelTypeChoice::automatic)
        return textures;

    std::vector<std::unique_ptr<StorageError>> errors;
    std::vector<TexelVisitor*> visitors;
    for (const Map map : maps) {
        errors.push_back(
            std::make_unique<StorageError>(map, layout, scale, source.width(), source.height()));
        visitors.push_back(errors.back().get());
    }
    StripReader strips(source, found, options, false);
    MomentPyramid pyramid(layout, source.width(), source.height(), visitors);
    measure_pass(strips, pyramid, texels, source.height(), monitor);
    for (size_t i = 0; i < textures.size(); ++i) {
        textures[i].half_error = errors[i]->half_error();
        textures[i].float_error = errors[i]->float_error();
        textures[i].type = *textures[i].half_error <= options.half_tolerance ? PixelType::half
                                                                             : PixelType::float32;
    }
    return textures;
}

/// Limits all threads, Scree's and those of the image libraries, while it exists.
class ThreadLimit {
public:
    explicit ThreadLimit(int asked)
        : threads_(asked > 0 ? asked
                             : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))),
          tbb_(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads_))
    {
        set_image_threads(threads_);
    }

private:
    int threads_;
    tbb::global_control tbb_;
};

Manifest bake_into(StagedFolder& folder, Source& source, const BakeOptions& options,
                   Manifest manifest, const BakeMonitor& monitor)
{
    const Survey found = survey(source, monitor);
    const auto maps = choose_maps(source, options, found.complete);
    const MomentLayout layout = moments_for(maps, source);
    const auto texel = texel_size(source, options);
    const TexelMoments texels(layout, found, options, source.width(), texel[0], texel[1]);
    const ValueScale scale{found.h0, found.h1, source.has_heights()};

    manifest.program_version = kVersion;
    manifest.width = source.width();
    manifest.height = source.height();
    manifest.wrap_s = wrap_name(options.wrap_s);
    manifest.wrap_t = wrap_name(options.wrap_t);
    manifest.texel_width = texel[0];
    manifest.texel_height = texel[1];
    manifest.height_scale = options.height_scale;
    manifest.height_offset = options.height_offset;
    manifest.reconstruction =
        source.has_heights() ? reconstruction_name(options.reconstruction) : "given normals";
    manifest.layout = layout_name(options.layout);
    manifest.has_height = source.has_heights();
    manifest.h0 = found.h0;
    manifest.h1 = found.h1;
    manifest.height_min = found.height_min;
    manifest.height_max = found.height_max;
    manifest.no_data_texels = found.no_data_texels;
    manifest.half_tolerance = options.half_tolerance;
    manifest.compression = compression_name(options.compression);
    manifest.options = options.as_given;
    manifest.textures =
        choose_types(maps, source, found, layout, texels, scale, options, manifest.name, monitor);

    std::vector<TextureOutput> outputs;
    LevelStatistics statistics(layout, source.width(), source.height(), found.h1);
    std::vector<TexelVisitor*> visitors = {&statistics};
    for (const TextureRecord& texture : manifest.textures) {
        MipLayout mip{source.width(), source.height(),     map_info(texture.map).channels,
                      texture.type,   options.compression, attributes_of(texture.map, manifest)};
        TextureOutput output{texture.map,
                             std::make_unique<MipFile>(folder.path() / texture.file, mip), nullptr};
        output.rows = std::make_unique<TextureRows>(texture.map, layout, scale, *output.file);
        visitors.push_back(output.rows.get());
        outputs.push_back(std::move(output));
    }
    StripReader strips(source, found, options, true);
    MomentPyramid pyramid(layout, source.width(), source.height(), visitors);
    write_pass(strips, pyramid, texels, outputs, source.height(), monitor);

    manifest.levels = statistics.summaries();
    for (auto& warning : rejects_warnings(found.rejects))
        manifest.warnings.push_back(std::move(warning));
    for (auto& warning : scale_warnings(manifest, options))
        manifest.warnings.push_back(std::move(warning));
    write_manifest(manifest, folder.path());
    monitor.report("bake", 1);
    folder.publish();
    return manifest;
}

} // namespace

Manifest bake(Source& source, const BakeOptions& options, Manifest manifest,
              const BakeMonitor& monitor)
{
    expect_sensible(options);
    const ThreadLimit limit(options.threads);
    StagedFolder folder(options.output); // first, so that a bad -o fails before the work
    return bake_into(folder, source, options, std::move(manifest), monitor);
}

Manifest bake(const BakeOptions& options, const BakeMonitor& monitor)
{
    expect_sensible(options);
    if (options.height_file.empty())
        throw Error("no height map; give --height FILE (see scree bake --help)");
    const ThreadLimit limit(options.threads);
    StagedFolder folder(options.output);
    FileSource source(options, folder.path());
    Manifest manifest;
    manifest.name = options.name.empty() ? options.height_file.stem().string() : options.name;
    manifest.inputs = source.records();
    manifest.working_space = source.working_space();
    manifest.warnings = source.notes();
    manifest.quantum = source.quantum();
    manifest.integer_bits = source.integer_bits();
    return bake_into(folder, source, options, std::move(manifest), monitor);
}

} // namespace scree
