#include "bake/bake_words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

#include "bake/checks.h"
#include "bake/recipe.h"
#include "bake/terminal.h"
#include "math/error.h"
#include "texset/udim.h"

namespace scree::tool {

namespace {

constexpr const char* kPathKeys = "height,color,colormap,mesh,output,ocio-config";

} // namespace

void add_bake_options(CLI::App& command, BakeWords& words)
{
    BakeOptions& o = words.options;

    auto* files = command.add_option_group("Files");
    files->add_option("--height", o.height_file,
                      "height map (or normal map, see --input); <UDIM> in its name stands for the "
                      "numbers of tiles, 1001 and up, here and in --color");
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
        ->add_option(
            "--height-scale", o.height_scale,
            "world units a unit of the file; integers are [0,1] before it, signed ones [-1,1]")
        ->capture_default_str();
    surface->add_option("--height-offset", o.height_offset, "world units added to the heights")
        ->capture_default_str();
    surface->add_option(
        "--no-data", o.no_data_height,
        "file value (integers: in [0,1], signed in [-1,1]) that marks texels without data");
    surface
        ->add_option("--texel-size", words.texel_size,
                     "world size of a texel, one number or width and height")
        ->expected(1, 2)
        ->option_text("W [H]");
    surface
        ->add_option("--world-size", words.world_size,
                     "world size of the whole map, or of a tile [one unit wide, square texels]")
        ->expected(1, 2)
        ->option_text("W [H]");
    surface
        ->add_option("--wrap", words.wrap,
                     "beyond the edge: periodic, clamp, mirror or black; once, or for s and t "
                     "[periodic; of tiles clamp]")
        ->expected(1, 2)
        ->option_text("S [T]");
    surface->add_flag("--udim-wrap", o.udim_wrap,
                      "slopes at the border of a tile see the tile beyond it (with --mesh: where "
                      "the surface goes on, by itself)");
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

    add_mesh_options(command, words.mesh, o);

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
    set->add_option("--visibility", words.visibility,
                    "what tells the visible color: smith, from the slopes; corrected, with an "
                    "exponent fitted to what views see of the heights; tables of what they see "
                    "[smith; of --maps auto any]");
    set->add_option("--nodes", words.nodes,
                    "of tables: how many angles from the normal they hold, 1 to 6 [4]; the bake "
                    "lays them where the surface begins to hide. Or the angles, degrees. The most "
                    "that auto takes")
        ->delimiter(',')
        ->option_text("COUNT or ANGLE,..");
    set->add_option("--harmonics", words.harmonics,
                    "of tables: terms of the azimuth, 0 (the same from all sides) to 2 [1; of "
                    "auto at most 2]");
    set->add_option("--axes", words.axes,
                    "of tables: instead of harmonics, what goes with the view along two axes, for "
                    "walls, bricks and grooves; degrees of one from +s (right) towards +t (down), "
                    "or auto: where most slopes lie [of --maps auto tried, too]")
        ->check(angle_or_auto());
    set->add_option("--azimuths", o.table.azimuths, "of tables: directions that are swept")
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
    running->add_option("--threads", o.threads, "number of threads [all]")
        ->check(whole_number_from(0));
    running->add_flag("--quiet", words.quiet, "no progress, no summary, no warnings");
}

namespace {

std::optional<std::array<double, 2>> pair_of(const std::vector<double>& numbers)
{
    if (numbers.empty())
        return std::nullopt;
    return std::array<double, 2>{numbers.front(), numbers.back()};
}

/// Degrees; absent: auto.
std::optional<double> axis_named(const std::string& text)
{
    double degrees = 0;
    return CLI::detail::lexical_cast(text, degrees) ? std::optional(degrees) : std::nullopt;
}

/// One number as small as a count is one.
void take_nodes(const std::vector<double>& numbers, BakeOptions& options)
{
    if (numbers.empty())
        return;
    if (numbers.size() > 1 || numbers.front() > kMaxNodes) {
        options.table.node_angles_deg = numbers;
        options.move_nodes = false;
        return;
    }
    const double count = numbers.front();
    if (!(count >= 1) || count != std::floor(count))
        throw Error(fmt::format("--nodes {}: expected how many, 1 to {}, or their angles", count,
                                kMaxNodes));
    options.table.node_angles_deg = best_node_angles(static_cast<int>(count));
}

} // namespace

void interpret(CLI::App& command, BakeWords& words)
{
    if (!words.recipe.empty())
        apply_recipe(command, words.recipe, kPathKeys);
    BakeOptions& o = words.options;
    try {
        o.texel_size = pair_of(words.texel_size);
        o.world_size = pair_of(words.world_size);
        // The world height of a map given by its width alone follows from square texels, later.
        o.world_height_given = words.world_size.size() != 1;
        if (!words.wrap.empty()) {
            o.wrap_s = wrap_named(words.wrap.front());
            o.wrap_t = wrap_named(words.wrap.back());
        } else if (is_tiled(o.height_file)) {
            o.wrap_s = o.wrap_t = Wrap::clamp;
        }
        interpret_mesh(words.mesh, o);
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
        if (!words.visibility.empty())
            o.visibility = visibility_named(words.visibility);
        o.table.harmonics = words.harmonics.value_or(o.auto_maps ? 2 : 1);
        if (!words.axes.empty()) {
            if (words.harmonics && !o.auto_maps)
                throw Error("--axes and --harmonics: a table has one or the other");
            o.table.axes = !o.auto_maps;
            o.axis_deg = axis_named(words.axes);
        }
        take_nodes(words.nodes, o);
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
}

BakeOptions options_of_recipe(const std::filesystem::path& recipe)
{
    CLI::App command("bake", "bake");
    BakeWords words;
    add_bake_options(command, words);
    words.recipe = recipe.string();
    interpret(command, words);
    return words.options;
}

BakeOptions options_of_manifest(const Manifest& manifest, const InputFiles& files)
{
    CLI::App command("bake", "bake");
    BakeWords words;
    add_bake_options(command, words);
    for (const auto& [name, value] : manifest.options) {
        CLI::Option* option = command.get_option_no_throw("--" + name);
        if (option == nullptr)
            throw Error(fmt::format("the manifest of '{}' names an option --{}, which this version "
                                    "does not know; bake the set again",
                                    manifest.name, name));
        try {
            if (option->get_expected_max() > 1)
                option->add_result(CLI::detail::split(value, ' '));
            else
                option->add_result(value);
            option->run_callback();
        } catch (const CLI::ParseError& e) {
            throw Error(fmt::format("the manifest of '{}' is damaged: {}; bake the set again",
                                    manifest.name, e.what()));
        }
    }
    words.options.height_file = files.height;
    words.options.color_file = files.color;
    words.options.colormap_file = files.colormap;
    interpret(command, words);
    BakeOptions& o = words.options;
    o.name = manifest.name;
    // What the manifest says in numbers of its own holds, whatever the options were.
    o.height_scale = manifest.height_scale;
    o.height_offset = manifest.height_offset;
    o.wrap_s = wrap_named(manifest.wrap_s);
    o.wrap_t = wrap_named(manifest.wrap_t);
    if (!o.normal_input)
        o.reconstruction = reconstruction_named(manifest.reconstruction);
    o.texel_size = {manifest.texel_width, manifest.texel_height};
    o.world_size.reset();
    return o;
}

} // namespace scree::tool
