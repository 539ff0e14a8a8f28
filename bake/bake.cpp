#include "pipeline/bake.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "bake/bake_words.h"
#include "bake/commands.h"
#include "bake/given_options.h"
#include "bake/open_files.h"
#include "bake/set_tables.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"

namespace scree::tool {

namespace {

/// What says how to run a bake and not what to bake.
const std::set<std::string> kNotRecorded = {"recipe", "output", "threads",  "quiet", "help",
                                            "height", "color",  "colormap", "mesh",  "ocio-config"};

std::uintmax_t bytes_of(const TextureRecord& texture, const Manifest& manifest,
                        const std::filesystem::path& folder)
{
    std::error_code ignored;
    std::uintmax_t bytes = 0;
    for (const std::string& file : files_of(texture, manifest))
        bytes += std::filesystem::file_size(folder / file, ignored);
    return bytes;
}

void print_summary(const Manifest& manifest, const std::filesystem::path& folder)
{
    if (manifest.tiles.empty())
        fmt::print("{}: {}x{}, {} levels\n", folder.string(), manifest.width, manifest.height,
                   manifest.levels.size());
    else
        fmt::print("{}: {} tiles, {}x{} the largest\n", folder.string(), manifest.tiles.size(),
                   manifest.width, manifest.height);
    size_t width = 0;
    for (const TextureRecord& texture : manifest.textures)
        width = std::max(width, texture.file.size());
    for (const TextureRecord& texture : manifest.textures) {
        fmt::print("  {:{}} {:5} {:10.1f} kB", texture.file, width, pixel_type_name(texture.type),
                   static_cast<double>(bytes_of(texture, manifest, folder)) / 1000);
        if (texture.half_error)
            fmt::print("  (error as half {:.1e}, as float {:.1e})", *texture.half_error,
                       *texture.float_error);
        fmt::print("\n");
    }
}

void run(CLI::App& command, BakeWords& words)
{
    interpret(command, words);
    if (words.options.output.empty())
        throw UsageError("no output folder; give -o DIR");
    words.options.as_given = given_options(command, kNotRecorded);
    note_for_supervisor({words.options.height_file.string(), words.options.color_file.string(),
                         words.options.colormap_file.string(), words.options.mesh_file.string()},
                        words.options.output);

    allow_many_open_files();
    Manifest manifest;
    {
        Progress progress(words.quiet);
        manifest = bake(words.options, monitor_of(progress));
    }
    if (words.quiet)
        return;
    for (const auto& warning : manifest.warnings)
        fmt::print(stderr, "scree: warning: {}\n", warning);
    print_summary(manifest, words.options.output);
    print_mesh(manifest);
    print_color_map(manifest);
    print_model_choice(manifest);
}

} // namespace

void add_bake(CLI::App& app)
{
    auto words = std::make_shared<BakeWords>();
    auto* command = app.add_subcommand("bake", "bake heights and colors into a texture set");
    command->add_option("recipe", words->recipe, "TOML file with any of the options below")
        ->option_text("RECIPE.toml");
    add_bake_options(*command, *words);
    command->footer("Examples:\n"
                    "  scree bake --height rock.exr --color rock.png --world-size 2 -o rock\n"
                    "  scree bake configs/film.toml --height dem.tif --height-scale 32767 "
                    "--texel-size 30 -o dem\n"
                    "  scree bake --height 'skin.<UDIM>.exr' --color 'skin.<UDIM>.png' --mesh "
                    "body.obj --height-scale 0.02 -o skin");
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
