#include "chart/chart.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "bake/bake_words.h"
#include "bake/checks.h"
#include "bake/commands.h"
#include "bake/made_folder.h"
#include "bake/supervisor.h"
#include "bake/terminal.h"
#include "bake/text_file.h"
#include "chart/report.h"
#include "sample/field.h"
#include "texset/writable.h"

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

struct ChartWords {
    std::vector<std::string> assets;
    BakeOptions files; ///< of --height and --color
    fs::path output;
    ChartOptions options;
    int size = 512;
    bool svg = false, quiet = false;
};

/// Where the results go: all begin with `stem`.
struct ChartFiles {
    fs::path page, numbers, stem;
};

ChartFiles files_for(const fs::path& output)
{
    const fs::path page = output.extension() == ".html" ? output : output / "chart.html";
    fs::path stem = page;
    stem.replace_extension();
    fs::path numbers = stem;
    numbers += ".csv";
    return {page, numbers, stem};
}

bool is_sample(const std::string& name)
{
    const auto kinds = sample_kinds();
    return std::find(kinds.begin(), kinds.end(), name) != kinds.end();
}

/// What a word names, or --height and --color: null for a sample.
std::unique_ptr<BakeOptions> options_named(const std::string& word)
{
    if (is_sample(word))
        return nullptr;
    if (fs::path(word).extension() == ".toml")
        return std::make_unique<BakeOptions>(options_of_recipe(word));
    std::string kinds;
    for (const auto& kind : sample_kinds())
        kinds += (kinds.empty() ? "" : ", ") + kind;
    throw UsageError(fmt::format("'{}': expected a sample ({}) or a recipe that ends in .toml; "
                                 "images go to --height and --color",
                                 word, kinds));
}

/// An asset that was asked for, and what is to be read for it.
struct AssetWish {
    std::string sample;
    std::unique_ptr<BakeOptions> options; ///< null: the sample

    [[nodiscard]] std::string name() const { return options ? asset_name(*options) : sample; }
};

/// The names of charts and the numbers' first column tell assets apart.
void expect_own_names(const std::vector<AssetWish>& wishes)
{
    std::set<std::string> names;
    for (const AssetWish& wish : wishes)
        if (!names.insert(wish.name()).second)
            throw UsageError(fmt::format("two assets are called '{}', and so would their charts "
                                         "be; leave one out, or name it in a recipe: name = "
                                         "\"...\"",
                                         wish.name()));
}

std::vector<AssetWish> wishes_of(const ChartWords& words)
{
    std::vector<AssetWish> wishes;
    for (const auto& word : words.assets)
        wishes.push_back({word, options_named(word)});
    if (!words.files.height_file.empty())
        wishes.push_back({"", std::make_unique<BakeOptions>(words.files)});
    else if (!words.files.color_file.empty())
        throw UsageError("--color without --height; give the height map too");
    if (wishes.empty())
        for (const char* sample : {"fractal", "bricks"})
            wishes.push_back({sample, nullptr});
    expect_own_names(wishes);
    return wishes;
}

AssetChart chart_of(const AssetWish& wish, const ChartWords& words, const BakeMonitor& monitor)
{
    if (!wish.options)
        return make_chart(sample_asset(wish.sample, words.size), words.options, monitor);
    note_for_supervisor({wish.options->height_file.string(), wish.options->color_file.string(),
                         wish.options->colormap_file.string()},
                        "");
    return make_chart(asset_of(*wish.options, monitor), words.options, monitor);
}

std::vector<AssetChart> charts_of(const ChartWords& words)
{
    std::vector<AssetChart> charts;
    for (const AssetWish& wish : wishes_of(words)) {
        Progress progress(words.quiet);
        charts.push_back(chart_of(wish, words, monitor_of(progress)));
        if (!words.quiet)
            fmt::print("{}\n", to_text(chart_table(charts.back())));
    }
    return charts;
}

void write(const std::vector<AssetChart>& charts, const ChartWords& words, const ChartFiles& files)
{
    write_text(to_csv(chart_numbers(charts, words.options)), files.numbers);
    if (words.svg)
        for (const AssetChart& chart : charts)
            for (const NamedChart& named : error_charts(chart))
                write_text(report::to_svg(named.chart),
                           fmt::format("{}-{}.svg", files.stem.string(), named.name));
    write_text(chart_page(charts, words.options).to_html(), files.page);
}

void run(const ChartWords& words)
{
    const ChartFiles files = files_for(words.output);
    const MadeFolder folder(fs::absolute(files.page).parent_path());
    expect_writable(files.page);
    expect_writable(files.numbers);
    write(charts_of(words), words, files);
    if (!words.quiet)
        fmt::print("{}\n{}\n", files.page.string(), files.numbers.string());
}

} // namespace

void add_chart(CLI::App& app)
{
    auto words = std::make_shared<ChartWords>();
    ChartOptions& o = words->options;
    auto* command =
        app.add_subcommand("chart", "speed against accuracy of all methods, on one page");
    command
        ->add_option("asset", words->assets,
                     "samples (see scree sample) or recipes of scree bake [fractal bricks]")
        ->option_text("ASSET...");
    command
        ->add_option("-o,--output", words->output, "folder for chart.html and chart.csv, or X.html")
        ->required();
    command->add_option("--height", words->files.height_file, "one more asset: its height map");
    command
        ->add_option("--height-scale", words->files.height_scale,
                     "its world units a unit of the file")
        ->check(finite_number())
        ->capture_default_str();
    command->add_option("--height-channel", words->files.height_channel,
                        "its channel with the heights");
    command->add_option("--color", words->files.color_file, "its color texture");
    command->add_option("--size", words->size, "of the samples, texels a side")
        ->check(whole_number_from_to(4, 1 << 14))
        ->capture_default_str();
    command->add_option("--footprints", o.footprints, "a level, at most")
        ->check(whole_number_from(1))
        ->capture_default_str();
    command
        ->add_option("--samples", o.grid, "of the truth: a grid of so many a side, per footprint")
        ->check(whole_number_from_to(2, 1024))
        ->capture_default_str();
    command->add_option("--seed", o.seed, "of the choice of footprints and samples")
        ->capture_default_str();
    command->add_option("--base-alpha", o.material.base_alpha, "Beckmann roughness of the facets")
        ->check(number_from_to(0.001, 1))
        ->capture_default_str();
    command->add_option("--f0", o.material.f0, "reflectance of the facets")
        ->check(number_from_to(0, 1))
        ->capture_default_str();
    command->add_flag("--svg", words->svg, "each chart in a file of its own, too");
    command->add_option("--threads", o.threads, "number of threads, but for timing [all]")
        ->check(whole_number_from(0));
    command->add_flag("--quiet", words->quiet, "no progress, no tables");
    command->callback([words] { run(*words); });
}

} // namespace scree::tool
