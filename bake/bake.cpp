#include "pipeline/bake.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "bake/commands.h"
#include "bake/recipe.h"
#include "bake/set_tables.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"

namespace scree::tool {

namespace {

/// The words of the command line, before they become BakeOptions.
struct BakeWords {
    BakeOptions options;
    std::string recipe;
    std::vector<double> texel_size, world_size, map_range;
    std::optional<double> map_azimuth;
    std::string map_by = "height";
    std::vector<std::string> wrap, maps;
    std::string input = "height", normal_range = "auto", reconstruction = "bilinear";
    std::string pixel_type = "auto", compression = "zip", layout = "scree";
    bool quiet = false;
};

constexpr const char* kPathKeys = "height,color,colormap,output,ocio-config";
/// What says how to run a bake and not what to bake; not recorded in the manifest.
constexpr const char* kNotRecorded =
    ",recipe,output,threads,quiet,help,height,color,colormap,ocio-config,";

void add_options(CLI::App& command, BakeWords& words)
{
    BakeOptions& o = words.options;
    command.add_option("recipe", words.recipe, "TOML file with any of the options below")
        ->option_text("RECIPE.toml");

    auto* files = command.add_option_group("Files");
    files->add_option("--height", o.height_file, "height map (or normal map, see --input)");
    files->add_option("--color", o.color_file, "color texture of the same size");
    files->add_option(
        "--colormap", o.colormap_file,
        "instead: color by height or slope; a 1-D LUT (spi1d, csp, cube, clf, ...), a "
        "GMT .cpt, or the first row of an image");
    files->add_option("-o,--output", o.output, "folder of the texture set; replaced as a whole");
    files->add_option("--name", o.name, "name of the set [the height file's]");

    auto* surface = command.add_option_group("Surface");
    surface->add_option("--input", words.input, "height, or normal: a tangent-space normal map")
        ->capture_default_str();
    surface->add_option("--height-channel", o.height_channel,
                        "channel with the heights, by name or number");
    surface
        ->add_option("--height-scale", o.height_scale,
                     "world units a unit of the file; integers are [0,1] before it")
        ->capture_default_str();
    surface->add_option("--height-offset", o.height_offset, "world units added to the heights")
        ->capture_default_str();
    surface->add_option("--no-data", o.no_data_height,
                        "file value (integers: in [0,1]) that marks texels without data");
    surface
        ->add_option("--texel-size", words.texel_size,
                     "world size of a texel, one number or width and height")
        ->expected(1, 2)
        ->option_text("W [H]");
    surface
        ->add_option("--world-size", words.world_size,
                     "world size of the whole map [one unit wide, square texels]")
        ->expected(1, 2)
        ->option_text("W [H]");
    surface
        ->add_option("--wrap", words.wrap,
                     "beyond the edge: periodic, clamp, mirror or black; once, or for s and t "
                     "[periodic]")
        ->expected(1, 2)
        ->option_text("S [T]");
    surface
        ->add_option("--reconstruction", words.reconstruction,
                     "slopes from heights: bilinear (exact), central, sobel (as maketx)")
        ->capture_default_str();
    surface
        ->add_option("--normal-range", words.normal_range,
                     "normal maps: unsigned [0,1], signed [-1,1], or auto: for a "
                     "float file whichever has vectors of unit length, else unsigned")
        ->capture_default_str();
    surface->add_flag("--invert-x", o.invert_x, "normal maps: red points left");
    surface->add_flag("--invert-y", o.invert_y,
                      "normal maps: green points up the image (OpenGL, glTF, Blender)");

    auto* color = command.add_option_group("Color and weight");
    color->add_option("--ocio-config", o.ocio_config,
                      "OpenColorIO config [$OCIO, or a small one that Scree carries]");
    color->add_option("--color-space", o.color_space,
                      "color space of the color file [its header's, or the config's file rules; of "
                      "a .cpt sRGB, of a LUT the role scene_linear]");
    color->add_option("--working-space", o.working_space,
                      "scene-linear space that colors are averaged and stored in [the config's "
                      "scene_linear role]");
    color->add_flag("--alpha-weight", o.alpha_weight,
                    "texels count by their alpha; alpha 0 is no data");
    color->add_flag("--resample", o.resample, "fit a color texture of another size to the heights");

    auto* map = command.add_option_group("Color map");
    map->add_option("--map-by", words.map_by,
                    "what --colormap is a function of: height, or slope (its steepness; along a "
                    "direction with --map-azimuth)")
        ->capture_default_str();
    map->add_option("--map-azimuth", words.map_azimuth,
                    "the direction of --map-by slope, degrees from +s (right) towards +t (down)");
    map->add_option("--map-range", words.map_range,
                    "heights (world units) or slopes that the map's ends stand for [what its file "
                    "states; else the lowest and the highest height]")
        ->expected(2)
        ->option_text("LOW HIGH");
    map->add_option("--map-tolerance", o.map_tolerance,
                    "rms interpolation error of the table NAME.map.exr, as a share of its colors")
        ->capture_default_str();

    auto* set = command.add_option_group("Texture set");
    set->add_option("--maps", words.maps,
                    "which maps to bake: " + map_names() +
                        "; or auto: those that a view needs [all the inputs allow]")
        ->delimiter(',');
    set->add_option("--rank-terms", o.rank_terms,
                    "terms of the rank table, 1 to 8; the most that auto takes")
        ->capture_default_str();
    set->add_option("--max-view-angle", o.max_view_angle_deg,
                    "for auto: steepest view, degrees from the normal")
        ->capture_default_str();
    set->add_option("--model-tolerance", o.model_tolerance,
                    "for auto: rms error of the visible color, relative, that may be")
        ->capture_default_str();
    set->add_option("--pixel-type", words.pixel_type,
                    "half, float, or auto: half where its measured error is small enough")
        ->capture_default_str();
    set->add_option("--half-tolerance", o.half_tolerance,
                    "error of the recovered covariance, relative, up to which auto takes half")
        ->capture_default_str();
    set->add_option("--compression", words.compression, "none, rle, zips, zip or piz")
        ->capture_default_str();
    set->add_option("--layout", words.layout, "scree, or bumpslopes: one file as of maketx")
        ->capture_default_str();

    auto* running = command.add_option_group("Running");
    running->add_option("--threads", o.threads, "number of threads [all]");
    running->add_flag("--quiet", words.quiet, "no progress, no summary, no warnings");
}

std::optional<std::array<double, 2>> pair_of(const std::vector<double>& numbers)
{
    if (numbers.empty())
        return std::nullopt;
    return std::array<double, 2>{numbers.front(), numbers.back()};
}

/// The world height of a map given by its width alone follows from square texels, later.
void interpret(BakeWords& words)
{
    BakeOptions& o = words.options;
    try {
        o.texel_size = pair_of(words.texel_size);
        o.world_size = pair_of(words.world_size);
        o.world_height_given = words.world_size.size() != 1;
        if (!words.wrap.empty()) {
            o.wrap_s = wrap_named(words.wrap.front());
            o.wrap_t = wrap_named(words.wrap.back());
        }
        o.normal_input = input_is_normal(words.input);
        o.normal_range = normal_range_named(words.normal_range);
        o.reconstruction = reconstruction_named(words.reconstruction);
        o.pixel_type = pixel_type_choice_named(words.pixel_type);
        o.compression = compression_named(words.compression);
        o.layout = layout_named(words.layout);
        for (const auto& name : words.maps)
            if (name == "auto")
                o.auto_maps = true;
            else
                o.maps.push_back(map_named(name));
        if (!words.map_range.empty())
            o.map_range = {words.map_range.front(), words.map_range.back()};
        o.map_by = map_by_named(words.map_by, words.map_azimuth.has_value());
        o.map_azimuth_deg = words.map_azimuth.value_or(0);
        expect_sensible(o);
    } catch (const Error& e) {
        // Which of the two a word came from is no longer known.
        throw UsageError(words.recipe.empty()
                             ? e.what()
                             : fmt::format("{}, or the command line: {}", words.recipe, e.what()));
    }
    if (o.name.find('/') != std::string::npos)
        throw UsageError(fmt::format("--name '{}': expected the beginning of a file name, without "
                                     "folders; the folder goes to -o",
                                     o.name));
    if (o.height_file.empty())
        throw UsageError("no height map; give --height FILE, or a recipe that names one "
                         "(see scree bake --help)");
    if (o.output.empty())
        throw UsageError("no output folder; give -o DIR");
    if (o.threads < 0)
        throw UsageError("--threads must be 0 (all) or more");
}

/// What the manifest records: every option that was given, by its long name.
std::map<std::string, std::string> given_options(const CLI::App& command)
{
    std::map<std::string, std::string> given;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name =
            option->get_lnames().empty() ? option->get_name() : option->get_lnames().front();
        if (option->count() == 0 ||
            std::string(kNotRecorded).find("," + name + ",") != std::string::npos)
            continue;
        std::string value;
        for (const auto& word : option->results())
            value += (value.empty() ? "" : " ") + word;
        given[name] = value;
    }
    return given;
}

void print_summary(const Manifest& manifest, const std::filesystem::path& folder)
{
    fmt::print("{}: {}x{}, {} levels\n", folder.string(), manifest.width, manifest.height,
               manifest.levels.size());
    size_t width = 0;
    for (const TextureRecord& texture : manifest.textures)
        width = std::max(width, texture.file.size());
    for (const TextureRecord& texture : manifest.textures) {
        std::error_code ignored;
        const auto bytes = std::filesystem::file_size(folder / texture.file, ignored);
        fmt::print("  {:{}} {:5} {:10.1f} kB", texture.file, width, pixel_type_name(texture.type),
                   static_cast<double>(bytes) / 1000);
        if (texture.half_error)
            fmt::print("  (error as half {:.1e}, as float {:.1e})", *texture.half_error,
                       *texture.float_error);
        fmt::print("\n");
    }
}

void run(CLI::App& command, BakeWords& words)
{
    if (!words.recipe.empty())
        apply_recipe(command, words.recipe, kPathKeys);
    interpret(words);
    words.options.as_given = given_options(command);
    note_for_supervisor({words.options.height_file.string(), words.options.color_file.string(),
                         words.options.colormap_file.string()},
                        words.options.output);

    Manifest manifest;
    {
        Progress progress(words.quiet);
        BakeMonitor monitor;
        monitor.progress = [&progress](const char* phase, double done) {
            progress.show(phase, done);
        };
        monitor.cancel = &stop_asked();
        manifest = bake(words.options, monitor);
    }
    if (words.quiet)
        return;
    for (const auto& warning : manifest.warnings)
        fmt::print(stderr, "scree: warning: {}\n", warning);
    print_summary(manifest, words.options.output);
    print_color_map(manifest);
    print_model_choice(manifest);
}

} // namespace

void add_bake(CLI::App& app)
{
    auto words = std::make_shared<BakeWords>();
    auto* command = app.add_subcommand("bake", "bake heights and colors into a texture set");
    add_options(*command, *words);
    command->footer("Examples:\n"
                    "  scree bake --height rock.exr --color rock.png --world-size 2 -o rock\n"
                    "  scree bake configs/film.toml --height dem.tif --height-scale 32767 "
                    "--texel-size 30 -o dem");
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
