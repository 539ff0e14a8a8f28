#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

#include "bake/commands.h"
#include "bake/set_inputs.h"
#include "bake/set_tables.h"
#include "texset/manifest.h"

namespace scree::tool {

namespace {

struct InfoWords {
    std::string set;
    int tile = 0; ///< 0: the whole set
    bool json = false;
};

void run(const InfoWords& words)
{
    Manifest manifest = read_manifest(words.set);
    if (words.tile != 0)
        manifest = manifest_of_map(manifest, words.tile);
    if (words.json) {
        fmt::print("{}", to_json(manifest));
        return;
    }
    print_head(manifest);
    print_textures(manifest);
    print_tiles(manifest);
    if (!manifest.levels.empty())
        print_levels(manifest);
    print_color_fit(manifest);
    print_model_errors(manifest);
    print_color_map(manifest);
    print_model_choice(manifest);
    for (const auto& warning : manifest.warnings)
        fmt::print("warning when baked: {}\n", warning);
}

} // namespace

void add_info(CLI::App& app)
{
    auto words = std::make_shared<InfoWords>();
    auto* command = app.add_subcommand("info", "what a texture set holds, level by level");
    command->add_option("set", words->set, "folder or manifest of a texture set")->required();
    add_tile_option(*command, words->tile);
    command->add_flag("--json", words->json, "the manifest, machine readable");
    command->callback([words] { run(*words); });
}

} // namespace scree::tool
