#include "tables/brdf_table.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <map>
#include <memory>

#include "bake/checks.h"
#include "bake/table.h"
#include "bake/terminal.h"
#include "tables/effective_brdf.h"

namespace scree::tool {

namespace {

struct BrdfWords {
    TableWords table;
    std::filesystem::path set;
    int level = 0;
    EffectiveBrdfOptions brdf;
    std::string parametrization = "hybrid", size = "32x32x16", spacing = "angle", second = "fitted";
};

/// "AxBxC", each 2 to 1024. Throws UsageError.
std::array<int, 3> size_named(const std::string& word)
{
    constexpr int kLeast = 2, kMost = 1024;
    std::array<int, 3> size{};
    const char* at = word.data();
    const char* end = at + word.size();
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto [next, failed] = std::from_chars(at, end, size[axis]);
        const bool ends = axis == 2 ? next == end : next != end && *next == 'x';
        if (failed != std::errc() || size[axis] < kLeast || size[axis] > kMost || !ends)
            throw UsageError(fmt::format("--size: expected three numbers from {} to {}, such as "
                                         "32x32x16, got '{}'",
                                         kLeast, kMost, word));
        at = axis == 2 ? next : next + 1;
    }
    return size;
}

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

void run(const CLI::App& command, const BrdfWords& words)
{
    const BrdfGrid grid{parametrization_named(words.parametrization), size_named(words.size),
                        spacing_named(words.spacing), words.second == "fitted"};
    make_table(command, brdf_manifest(grid).kind, words.table,
               [&](const std::function<void(double)>& progress) {
                   const EffectiveBrdf brdf(words.set, words.level, words.brdf);
                   return MadeTable{brdf_manifest(grid), brdf_table(grid, brdf, progress)};
               });
}

} // namespace

void add_brdf_table(CLI::App& table)
{
    auto words = std::make_shared<BrdfWords>();
    auto* command =
        table.add_subcommand("brdf", "the BRDF of a level of a texture set, isotropic: R, G, B");
    command->add_option("--set", words->set, "folder or manifest of a texture set")->required();
    command->add_option("--level", words->level, "level whose texels are averaged")
        ->required()
        ->check(whole_number_from(0));
    command->add_option("--parametrization", words->parametrization, "what its axes are")
        ->check(CLI::IsMember({"half-difference", "orthographic", "hybrid"}))
        ->capture_default_str();
    command->add_option("--size", words->size, "nodes along the three axes")
        ->option_text("AxBxC [32x32x16]");
    command
        ->add_option(
            "--spacing", words->spacing,
            "nodes at even steps; of the first axis at squares; or so of angles, of lengths too")
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
    command->add_option("--turns", words->brdf.turns, "turns of the surface to average [16]")
        ->check(whole_number_from_to(1, 4096));
    add_table_options(*command, words->table);
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
