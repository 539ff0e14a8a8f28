#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "bake/commands.h"
#include "bake/made_folder.h"
#include "bake/terminal.h"
#include "sample/field.h"
#include "texset/image_file.h"

namespace scree::tool {

namespace {

struct SampleWords {
    std::string kind;
    std::vector<int> size = {512, 512};
    std::filesystem::path folder;
    bool quiet = false;
};

/// A recipe that bakes the sample with the scale and wrap it was made for.
void write_recipe(const SampleInfo& info, const std::filesystem::path& file)
{
    std::ofstream out(file);
    out << fmt::format("# {}: {}\n", info.kind, info.description)
        << fmt::format("height = \"{0}.height.exr\"\ncolor = \"{0}.color.exr\"\nname = \"{0}\"\n",
                       info.kind)
        << fmt::format("world-size = [{}, {}]\nwrap = [\"{}\", \"{}\"]\n", info.world_width,
                       info.world_height, info.wrap_s, info.wrap_t);
    out.close();
    if (!out)
        throw Error(
            fmt::format("{}: cannot be written; is there room on the disk?", file.string()));
}

void print_known(const KnownAnswers& known)
{
    auto line = [](const char* what, double value) {
        if (!std::isnan(value))
            fmt::print("  {:28} {:.9g}\n", what, value);
    };
    line("mean slope s", known.mean_s);
    line("mean slope t", known.mean_t);
    line("slope variance ss", known.var_ss);
    line("slope variance tt", known.var_tt);
    line("slope covariance st", known.cov_st);
    line("mean height", known.mean_height);
    line("standard deviation of height", known.std_height);
}

void run(const SampleWords& words)
{
    std::unique_ptr<SampleField> field;
    try {
        field = make_sample(words.kind, words.size.front(), words.size.back());
    } catch (const std::invalid_argument& e) {
        throw UsageError(e.what());
    }
    const SampleInfo& info = field->info();
    const MadeFolder folder(words.folder);

    ImageFile height(words.folder / (info.kind + ".height.exr"), info.width_texels,
                     info.height_texels, {"Y"});
    ImageFile color(words.folder / (info.kind + ".color.exr"), info.width_texels,
                    info.height_texels, {"R", "G", "B"});
    const auto width = static_cast<size_t>(info.width_texels);
    std::vector<float> heights(width), rgb(3 * width);
    Progress progress(words.quiet);
    for (int y = 0; y < info.height_texels; ++y) {
        if (stop_asked())
            throw Cancelled();
        field->row(y, heights.data(), rgb.data());
        height.write_row(heights.data());
        color.write_row(rgb.data());
        if (info.height_texels >= 4096)
            progress.show("sample", static_cast<double>(y + 1) / info.height_texels);
    }
    height.close();
    color.close();
    const auto recipe = words.folder / (info.kind + ".toml");
    write_recipe(info, recipe);
    if (words.quiet)
        return;
    fmt::print("{}: {}, {}x{} texels, {:g} x {:g} world units\n", words.folder.string(),
               info.description, info.width_texels, info.height_texels, info.world_width,
               info.world_height);
    print_known(info.bilinear);
    fmt::print("bake it: scree bake {} -o {}\n", recipe.string(),
               (words.folder / (info.kind + ".set")).string());
}

std::string kinds()
{
    std::string list;
    for (const auto& kind : sample_kinds())
        list += (list.empty() ? "" : ", ") + kind;
    return list;
}

} // namespace

void add_sample(CLI::App& app)
{
    auto words = std::make_shared<SampleWords>();
    auto* command = app.add_subcommand("sample", "a ready height and color pair, to try things on");
    command->add_option("kind", words->kind, kinds())->required();
    command->add_option("-o,--output", words->folder, "folder for the two images and a recipe")
        ->required();
    command->add_option("--size", words->size, "width and height in texels, or one number")
        ->expected(1, 2)
        ->capture_default_str();
    command->add_flag("--quiet", words->quiet, "no progress, no summary");
    command->callback([words] { run(*words); });
}

} // namespace scree::tool
