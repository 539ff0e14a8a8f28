#include "tables/linear_light_table.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

#include "bake/table.h"
#include "bake/terminal.h"

namespace scree::tool {

namespace {

struct LinearLightWords {
    TableWords table;
    std::string coordinates = "cone", resolution;
};

std::string usual_word(LinearLightCoordinates coordinates)
{
    const LinearLightResolution size = usual_resolution(coordinates);
    return fmt::format("{}x{}x{}", size.views, size.normals, size.azimuths);
}

void run(const CLI::App& command, const LinearLightWords& words)
{
    const auto coordinates = words.coordinates == "angles" ? LinearLightCoordinates::angles
                                                           : LinearLightCoordinates::cone;
    LinearLightResolution size = usual_resolution(coordinates);
    if (!words.resolution.empty()) {
        const auto [views, normals, azimuths] =
            sizes_named("--resolution", words.resolution, 4096, usual_word(coordinates));
        size = {views, normals, azimuths};
    }
    make_table(
        command, "linear-light", words.table, [&](const std::function<void(double)>& progress) {
            TableManifest manifest = linear_light_manifest(coordinates, size);
            manifest.options = {
                {"coordinates", words.coordinates},
                {"resolution", fmt::format("{}x{}x{}", size.views, size.normals, size.azimuths)}};
            return MadeTable{std::move(manifest),
                             linear_light_table(coordinates, size, progress).values};
        });
}

} // namespace

void add_linear_light_table(CLI::App& table)
{
    auto words = std::make_shared<LinearLightWords>();
    auto* command =
        table.add_subcommand("linear-light", "where the reflection of a linear light is brightest");
    command
        ->add_option("--coordinates", words->coordinates,
                     "cone: one number, from which Phi, k and tan^2 alpha follow, over coordinates "
                     "that no jump of Phi crosses; angles: the three over cos theta_v, cos "
                     "theta_n, phi_n")
        ->check(CLI::IsMember({"cone", "angles"}))
        ->capture_default_str();
    command
        ->add_option("--resolution", words->resolution,
                     fmt::format("texels along the three axes [{}; over angles {}]",
                                 usual_word(LinearLightCoordinates::cone),
                                 usual_word(LinearLightCoordinates::angles)))
        ->option_text("VxNxP");
    add_table_options(*command, words->table);
    command->callback([command, words] { run(*command, *words); });
}

} // namespace scree::tool
