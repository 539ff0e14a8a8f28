#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>
#include <memory>

#include "bake/checks.h"
#include "bake/set_inputs.h"
#include "bake/table.h"
#include "bake/terminal.h"
#include "tables/effective_brdf.h"
#include "tables/measured_brdf.h"
#include "tables/traced_brdf.h"

namespace scree::tool {

namespace {

constexpr const char* kUsualSize = "32x32x16";

struct BrdfWords {
    TableWords table;
    SetWords set;
    int level = -1; ///< none
    EffectiveBrdfOptions brdf;
    bool reference = false, compare = false;
    int samples = 64;
    std::string parametrization = "hybrid", size = kUsualSize, spacing = "angle", second = "fitted";
};

BrdfParametrization parametrization_named(const std::string& word)
{
    for (const auto each :
         {BrdfParametrization::half_difference, BrdfParametrization::orthographic})
        if (word == name_of(each))
            return each;
    return BrdfParametrization::hybrid;
}

BrdfSpacing spacing_named(const std::string& word)
{
    if (word == "even")
        return BrdfSpacing::even;
    return word == "root" ? BrdfSpacing::root : BrdfSpacing::angle;
}

BrdfGrid grid_of(const BrdfWords& words)
{
    return {parametrization_named(words.parametrization),
            sizes_named("--size", words.size, 1024, kUsualSize), spacing_named(words.spacing),
            words.second == "fitted"};
}

BrdfSource traced_source(const BrdfWords& words, const BakeMonitor& monitor)
{
    const SetReader set(words.set.path, words.set.tile);
    if (words.level >= 0)
        expect_level(words.set.path, set.manifest(), words.level);
    Original original = read_set_inputs(set.manifest(), words.set, monitor).original;
    const auto surface = std::make_shared<reference::DisplacedSurface>(
        surface_for_rays(std::move(original.relief), words.set, "leave out --reference"));
    const auto traced = [&](uint64_t seed) {
        auto brdf = std::make_shared<TracedBrdf>(
            *surface, TracedBrdfOptions{static_cast<double>(words.brdf.base_alpha),
                                        static_cast<double>(words.brdf.f0), words.samples, seed});
        return [surface, brdf](const filter::Directions<double>& w) { return (*brdf)(w); };
    };
    return {traced(1), traced(2)};
}

/// Reads what is to be tabulated.
BrdfSource source_of(const BrdfWords& words, const BakeMonitor& monitor)
{
    if (words.reference)
        return traced_source(words, monitor);
    const auto baked =
        std::make_shared<EffectiveBrdf>(words.set.path, words.level, words.brdf, words.set.tile);
    return {[baked](const filter::Directions<double>& w) { return (*baked)(w); }, {}};
}

/// What the table is of, given or not.
std::map<std::string, std::string> all_options(const BrdfWords& words)
{
    std::map<std::string, std::string> options = {
        {"parametrization", words.parametrization},
        {"size", words.size},
        {"spacing", words.spacing},
        {"second", words.second},
        {"base-alpha", fmt::format("{:g}", words.brdf.base_alpha)},
        {"f0", fmt::format("{:g}", words.brdf.f0)}};
    if (words.reference)
        options["samples"] = std::to_string(words.samples);
    else
        options["turns"] = std::to_string(words.brdf.turns);
    return options;
}

void run(const CLI::App& command, const BrdfWords& words)
{
    if (words.level < 0 && !words.reference)
        throw UsageError("--level is required, but with --reference");
    const BrdfGrid grid = grid_of(words);
    make_table(command, brdf_manifest(grid).kind, words.table,
               [&](const std::function<void(double)>& progress) {
                   const BakeMonitor reading{
                       [&progress](const char* /*phase*/, double /*done*/) { progress(0); },
                       &stop_asked()};
                   MeasuredBrdf made =
                       measured_brdf(grid, source_of(words, reading), words.compare, progress);
                   TableManifest manifest = brdf_manifest(grid);
                   manifest.options = all_options(words);
                   manifest.figures = std::move(made.figures);
                   return MadeTable{std::move(manifest), std::move(made.values)};
               });
}

} // namespace

void add_brdf_table(CLI::App& table)
{
    auto words = std::make_shared<BrdfWords>();
    auto* command =
        table.add_subcommand("brdf", "the BRDF of a level of a texture set, isotropic: R, G, B");
    add_tile_option(*command, words->set.tile);
    command->add_option("--set", words->set.path, "folder or manifest of a texture set")
        ->required();
    command->add_option("--level", words->level, "level whose texels are averaged")
        ->check(whole_number_from(0));
    command->add_option("--parametrization", words->parametrization, "what its axes are")
        ->check(CLI::IsMember({"half-difference", "orthographic", "hybrid"}))
        ->capture_default_str();
    command->add_option("--size", words->size, "nodes along the three axes")
        ->option_text("AxBxC [" + std::string(kUsualSize) + "]");
    command
        ->add_option("--spacing", words->spacing,
                     "nodes of the first two axes: even; root: of the first at squares of even "
                     "steps; angle: "
                     "as root, lengths as sines of angles")
        ->check(CLI::IsMember({"angle", "root", "even"}))
        ->capture_default_str();
    command
        ->add_option("--second", words->second,
                     "second axis: whole, or fitted to directions above the surface")
        ->check(CLI::IsMember({"whole", "fitted"}))
        ->capture_default_str();
    command
        ->add_option("--base-alpha", words->brdf.base_alpha, "Beckmann roughness of a facet [0.3]")
        ->check(number_from_to(0.001, 1));
    command->add_option("--f0", words->brdf.f0, "reflectance at normal incidence [0.04]")
        ->check(number_from_to(0, 1));
    auto* turns =
        command->add_option("--turns", words->brdf.turns, "turns of the surface to average [16]")
            ->check(whole_number_from_to(1, 4096));
    command->add_flag("--compare", words->compare,
                      "measure the other two parametrizations with as many nodes");

    auto* rays = command->add_option_group("Reference");
    auto* reference = rays->add_flag("--reference", words->reference,
                                     "trace the surface the set was baked from, not what is baked")
                          ->excludes(turns);
    rays->add_option("--samples", words->samples, "along each side of the map: 64 is 64x64")
        ->needs(reference)
        ->check(whole_number_from_to(2, 1024))
        ->capture_default_str();
    add_input_options(*rays, words->set);
    add_table_options(*command, words->table);
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
