#include "tables/linear_light_table.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "bake/table.h"
#include "bake/terminal.h"

namespace scree::tool {

namespace {

struct LinearLightWords {
    TableWords table;
    std::string resolution = "32x128x64";
};

/// "VxNxP", each 2 to 4096. Throws UsageError.
LinearLightResolution resolution_named(const std::string& word)
{
    constexpr int kLeast = 2, kMost = 4096;
    LinearLightResolution size;
    const char* at = word.data();
    const char* end = at + word.size();
    bool valid = true;
    for (int* number : {&size.views, &size.normals, &size.azimuths}) {
        const auto [next, failed] = std::from_chars(at, end, *number);
        valid = valid && failed == std::errc() && *number >= kLeast && *number <= kMost;
        const bool last = number == &size.azimuths;
        valid = valid && (last ? next == end : next != end && *next == 'x');
        if (!valid)
            throw UsageError(fmt::format("--resolution: expected three numbers from {} to {}, "
                                         "such as 32x128x64, got '{}'",
                                         kLeast, kMost, word));
        at = last ? next : next + 1;
    }
    return size;
}

void run(const CLI::App& command, const LinearLightWords& words)
{
    const LinearLightResolution size = resolution_named(words.resolution);
    make_table(command, "linear-light", words.table,
               [&size](const std::function<void(double)>& progress) {
                   return MadeTable{linear_light_manifest(size),
                                    linear_light_table(size, progress).values};
               });
}

} // namespace

void add_linear_light_table(CLI::App& table)
{
    auto words = std::make_shared<LinearLightWords>();
    auto* command = table.add_subcommand(
        "linear-light", "where the reflection of a linear light is brightest: Phi, k, tan^2 alpha");
    command
        ->add_option("--resolution", words->resolution,
                     "texels along cos theta_v, cos theta_n and phi_n")
        ->option_text("VxNxP [32x128x64]");
    add_table_options(*command, words->table);
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
