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

/// What the passes of one bake share.
struct Setup {
    Setup(Source& from, const BakeOptions& given, const BakeMonitor& watch)
        : source(from), options(given), monitor(watch), found(survey(from, watch)),
          maps(choose_maps(from, given, found.complete)), layout(moments_for(maps, from)),
          texel(texel_size(from, given)),
          texels(layout, found, given, from.width(), texel[0], texel[1]), scale{found.h0, found.h1,
                                                                                from.has_heights()}
    {}

    Source& source;
    const BakeOptions& options;
    const BakeMonitor& monitor;
    Survey found;
    std::vector<Map> maps;
    MomentLayout layout;
    std::array<double, 2> texel;
    TexelMoments texels;
    ValueScale scale;
};

/// All that is known before the first texel is written.
void describe(const Setup& setup, Manifest& manifest)
{
    const BakeOptions& options = setup.options;
    const bool has_heights = setup.source.has_heights();
    manifest.program_version = kVersion;
    manifest.width = setup.source.width();
    manifest.height = setup.source.height();
    manifest.wrap_s = wrap_name(options.wrap_s);
    manifest.wrap_t = wrap_name(options.wrap_t);
    manifest.texel_width = setup.texel[0];
    manifest.texel_height = setup.texel[1];
    manifest.height_scale = options.height_scale;
    manifest.height_offset = options.height_offset;
    manifest.reconstruction =
        has_heights ? reconstruction_name(options.reconstruction) : "given normals";
    manifest.layout = layout_name(options.layout);
    manifest.has_height = has_heights;
    manifest.h0 = setup.found.h0;
    manifest.h1 = setup.found.h1;
    manifest.height_min = setup.found.height_min;
    manifest.height_max = setup.found.height_max;
    manifest.no_data_texels = setup.found.no_data_texels;
    manifest.half_tolerance = options.half_tolerance;
    manifest.compression = compression_name(options.compression);
    manifest.options = options.as_given;
}

/// One texture a map, of the type that was given, or float.
std::vector<TextureRecord> textures_for(const Setup& setup, const std::string& name)
{
    std::vector<TextureRecord> textures;
    for (const Map map : setup.maps) {
        TextureRecord texture;
        texture.map = map;
        texture.file = fmt::format("{}.{}.exr", name, map_info(map).name);
        texture.type = setup.options.pixel_type == PixelTypeChoice::half ? PixelType::half
                                                                         : PixelType::float32;
        textures.push_back(texture);
    }
    return textures;
}

/// Measures what half and float cost and takes half where it costs little.
void measure_types(const Setup& setup, std::vector<TextureRecord>& textures)
{
    const int width = setup.source.width(), height = setup.source.height();
    std::vector<std::unique_ptr<StorageError>> errors;
    std::vector<TexelVisitor*> visitors;
    for (const TextureRecord& texture : textures) {
        errors.push_back(
            std::make_unique<StorageError>(texture.map, setup.layout, setup.scale, width, height));
        visitors.push_back(errors.back().get());
    }
    StripReader strips(setup.source, setup.found, setup.options, false);
    MomentPyramid pyramid(setup.layout, width, height, visitors);
    measure_pass(strips, pyramid, setup.texels, height, setup.monitor);
    for (size_t i = 0; i < textures.size(); ++i) {
        TextureRecord& texture = textures[i];
        texture.half_error = errors[i]->half_error();
        texture.float_error = errors[i]->float_error();
        const bool half_will_do = *texture.half_error <= setup.options.half_tolerance;
        texture.type = half_will_do ? PixelType::half : PixelType::float32;
    }
}

/// Writes all textures; returns the summaries of their levels.
std::vector<LevelSummary> write_textures(const Setup& setup, const Manifest& manifest,
                                         const std::filesystem::path& folder)
{
    const int width = setup.source.width(), height = setup.source.height();
    std::vector<TextureOutput> outputs;
    LevelStatistics statistics(setup.layout, width, height, setup.found.h1);
    std::vector<TexelVisitor*> visitors = {&statistics};
    for (const TextureRecord& texture : manifest.textures) {
        TextureOutput output{
            texture.map,
            std::make_unique<MipFile>(folder / texture.file,
                                      MipLayout{width, height, map_info(texture.map).channels,
                                                texture.type, setup.options.compression,
                                                attributes_of(texture.map, manifest)}),
            nullptr};
        output.rows =
            std::make_unique<TextureRows>(texture.map, setup.layout, setup.scale, *output.file);
        visitors.push_back(output.rows.get());
        outputs.push_back(std::move(output));
    }
    StripReader strips(setup.source, setup.found, setup.options, true);
    MomentPyramid pyramid(setup.layout, width, height, visitors);
    write_pass(strips, pyramid, setup.texels, outputs, height, setup.monitor);
    return statistics.summaries();
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
    const Setup setup(source, options, monitor);
    describe(setup, manifest);
    manifest.textures = textures_for(setup, manifest.name);
    if (options.pixel_type == PixelTypeChoice::automatic)
        measure_types(setup, manifest.textures);
    manifest.levels = write_textures(setup, manifest, folder.path());

    for (auto& warning : rejects_warnings(setup.found.rejects))
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
    FileSource source(options);
    StagedFolder folder(options.output);
    source.spool_in(folder.path());
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
