#include "judge/validation.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "bake/checks.h"
#include "bake/commands.h"
#include "bake/recipe.h"
#include "bake/set_inputs.h"
#include "bake/terminal.h"
#include "bake/text_file.h"
#include "judge/statistics_report.h"
#include "judge/validation_json.h"
#include "judge/validation_page.h"
#include "judge/view_report.h"
#include "pipeline/thread_limit.h"
#include "texset/writable.h"

namespace scree::tool {

namespace {

struct ValidateWords {
    SetWords set;
    std::filesystem::path recipe, report, json;
    ValidationPlan plan;
    std::vector<double> light = {};
    bool statistics_only = false;
    int threads = 0;
    bool quiet = false;
};

constexpr const char* kPathKeys = "inputs,ocio-config,report,json";

void add_options(CLI::App& command, ValidateWords& words)
{
    ViewPlan& view = words.plan.view;
    Tolerances& tolerances = words.plan.tolerances;
    command.add_option("--recipe", words.recipe,
                       "TOML file whose table [validate] holds any of the options below");

    auto* files = command.add_option_group("Files");
    add_set_options(command, *files, words.set);
    files->add_option("--report", words.report,
                      "writes an HTML page with tables, charts, pictures");
    files->add_option("--json", words.json, "writes all figures as JSON; - for the terminal");

    auto* views = command.add_option_group("Views");
    views->add_flag("--statistics-only", words.statistics_only,
                    "compare the statistics, cast no rays");
    views->add_option("--view-angles", view.angles_deg, "degrees from the normal")
        ->delimiter(',')
        ->check(number_from_to(0, 89))
        ->capture_default_str();
    views->add_option("--azimuths", view.azimuths, "of each angle")
        ->check(whole_number_from_to(1, 64))
        ->capture_default_str();
    views
        ->add_option("--light", words.light,
                     "one light instead of three: degrees from the normal, and from +s (right) "
                     "towards +t (down)")
        ->expected(2)
        ->check(number_from_to(0, 89).application_index(0))
        ->check(finite_number().application_index(1))
        ->option_text("ANGLE AZIMUTH");
    views->add_option("--footprints", view.footprints, "of each level")
        ->check(whole_number_from_to(1, 1000000))
        ->capture_default_str();
    views->add_option("--samples", view.grid, "along each side of a footprint: 32 is 32x32")
        ->check(whole_number_from_to(2, 1024))
        ->capture_default_str();
    views->add_option("--seed", view.seed, "of the samples")->capture_default_str();
    views->add_option("--base-alpha", view.material.base_alpha, "Beckmann roughness of a facet")
        ->check(number_from_to(0.001, 1))
        ->capture_default_str();
    views->add_option("--f0", view.material.f0, "share of the light that a facet mirrors")
        ->check(number_from_to(0, 1))
        ->capture_default_str();

    auto* limits = command.add_option_group("Tolerances");
    limits
        ->add_option("--statistics-tolerance", tolerances.statistics,
                     "of the statistics, in multiples of what storage explains")
        ->check(number_above_zero())
        ->capture_default_str();
    const char* relative = "rms error, relative, of the worst view angle [not judged]";
    limits->add_option("--color-tolerance", tolerances.color, relative)->check(number_above_zero());
    limits->add_option("--radiance-tolerance", tolerances.radiance, relative)
        ->check(number_above_zero());
    limits
        ->add_option("--masking-tolerance", tolerances.masking,
                     "rms error of G1 of the worst view angle [not judged]")
        ->check(number_above_zero());
    limits
        ->add_option("--slope-tolerance", tolerances.slope,
                     "rms error of the visible slope over the map's rms slope [not judged]")
        ->check(number_above_zero());
    limits
        ->add_option("--covariance-tolerance", tolerances.covariance,
                     "rms error of its covariance over the square of that [not judged]")
        ->check(number_above_zero());

    limits
        ->add_option("--tables-tolerance", tolerances.tables,
                     "rms error of the tables of visibility, area and color, of the worst node "
                     "[not judged]")
        ->check(number_above_zero());

    auto* running = command.add_option_group("Running");
    running->add_option("--threads", words.threads, "number of threads [all]")
        ->check(whole_number_from(0));
    running->add_flag("--quiet", words.quiet,
                      "no progress, no tables; the exit status says it all");
}

void print(const Validation& validation, const Manifest& manifest)
{
    fmt::print("{}: {}x{}, {} levels\n\n", manifest.name, manifest.width, manifest.height,
               manifest.levels.size());
    fmt::print("{}\n", to_text(statistics_table(validation.statistics)));
    if (validation.views) {
        const ViewCheck& views = *validation.views;
        fmt::print("{}\n{}\n", to_text(color_table(views)), to_text(slope_table(views)));
        const report::Table models = model_table(views);
        if (!models.rows.empty())
            fmt::print("{}\n", to_text(models));
        fmt::print("reference: {} samples, {} rays in {:.1f} s, {:.2f} million samples a second\n",
                   views.samples, views.rays, views.seconds,
                   static_cast<double>(views.samples) / views.seconds / 1e6);
    }
    if (validation.tables) {
        report::Table nodes = node_table(*validation.tables);
        nodes.rows.resize(validation.tables->all.size()); // the page has every level
        fmt::print("{}\n", to_text(nodes));
    }
    if (!validation.without_views.empty())
        fmt::print("what views see was not compared: {}\n", validation.without_views);
    for (const std::string& flag : validation.flags)
        fmt::print("note: {}\n", flag);
}

Validation validated(const ValidateWords& words, SetReader& set)
{
    Progress progress(words.quiet);
    const BakeMonitor monitor = monitor_of(progress);
    SetInputs inputs = read_set_inputs(set.manifest(), words.set, monitor);
    ValidationPlan plan = words.plan;
    plan.views = !words.statistics_only;
    plan.images = !words.report.empty();
    return validate(set, std::move(inputs.original), inputs.options, plan, monitor);
}

/// The first few, for an error's one line; the page and the JSON have all.
std::string some_of(const std::vector<std::string>& exceeded)
{
    constexpr size_t kMost = 3;
    std::string words;
    for (size_t i = 0; i < std::min(exceeded.size(), kMost); ++i)
        words += (i > 0 ? "; " : "") + exceeded[i];
    if (exceeded.size() > kMost)
        words += fmt::format("; and {} more (see --json or --report)", exceeded.size() - kMost);
    return words;
}

void run(CLI::App& command, ValidateWords& words)
{
    if (!words.recipe.empty())
        apply_validate_table(command, words.recipe, kPathKeys);
    if (!words.light.empty())
        words.plan.view.lights_deg = {{words.light[0], words.light[1]}};
    if (!words.report.empty())
        expect_writable(words.report);
    if (!words.json.empty() && words.json != "-")
        expect_writable(words.json);
    const ThreadLimit limit(words.threads);
    SetReader set(words.set.path, words.set.tile);
    const Validation validation = validated(words, set);
    if (!words.report.empty())
        write_text(to_page(validation, words.plan, set.manifest()), words.report);
    const std::string json = to_json(validation, words.plan, set.manifest());
    if (words.json == "-")
        fmt::print("{}", json);
    else if (!words.json.empty())
        write_text(json, words.json);
    if (!words.quiet && words.json != "-")
        print(validation, set.manifest());
    if (!validation.exceeded.empty())
        throw Error(fmt::format("{}: out of tolerance: {}", words.set.path.string(),
                                some_of(validation.exceeded)));
}

} // namespace

void add_validate(CLI::App& app)
{
    auto words = std::make_shared<ValidateWords>();
    auto* command = app.add_subcommand(
        "validate", "compare a set with the surface it was baked from, by brute force");
    add_options(*command, *words);
    command->footer("Examples:\n"
                    "  scree validate rock.set --inputs textures --report rock.html\n"
                    "  scree validate rock.set --statistics-only --quiet && echo good");
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
