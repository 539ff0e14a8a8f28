#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bake/commands.h"
#include "texset/manifest.h"

namespace scree::tool {

namespace {

struct InfoWords {
    std::string set;
    bool json = false;
};

std::string cell(const std::optional<double>& value, const char* format)
{
    return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

void print_head(const Manifest& m)
{
    fmt::print("{}  {}x{}, {} levels, scree {}\n", m.name, m.width, m.height, m.levels.size(),
               m.program_version);
    for (const auto& input : m.inputs)
        fmt::print("  {:8} {} ({}x{} {}, channels {}{}{}) sha256 {:.12}...\n", input.role,
                   input.file, input.width, input.height, input.type, input.channels,
                   input.color_space.empty() ? "" : ", ", input.color_space, input.sha256);
    fmt::print("  wrap {} {}, texel {:g} x {:g} world units, {} slopes\n", m.wrap_s, m.wrap_t,
               m.texel_width, m.texel_height, m.reconstruction);
    if (m.has_height)
        fmt::print("  height {:g} to {:g}, mean h0 {:g}, standard deviation h1 {:g}\n",
                   m.height_min, m.height_max, m.h0, m.h1);
    if (!m.working_space.empty())
        fmt::print("  colors in {}\n", m.working_space);
    if (m.no_data_texels > 0)
        fmt::print("  {} texels without data\n", m.no_data_texels);
}

void print_textures(const Manifest& m)
{
    size_t width = 0;
    for (const auto& texture : m.textures)
        width = std::max(width, texture.file.size());
    fmt::print("\n{:{}} {:6} {:10} {:10} channels\n", "texture", width, "type", "half err",
               "float err");
    for (const auto& texture : m.textures) {
        std::string channels;
        for (const auto& channel : map_info(texture.map).channels)
            channels += (channels.empty() ? "" : " ") + channel;
        fmt::print("{:{}} {:6} {:10} {:10} {}\n", texture.file, width,
                   pixel_type_name(texture.type), cell(texture.half_error, "{:.1e}"),
                   cell(texture.float_error, "{:.1e}"), channels);
    }
}

/// Means over the texels of a level; "inside" is what lies within its texels.
void print_levels(const Manifest& m)
{
    fmt::print("\n{:>5} {:>12} {:>21} {:>9} {:>9} {:>8} {:>6} {:>10} {:>20}\n", "level", "size",
               "mean slope s, t", "rms", "sigma in", "kurtosis", "tau", "height std",
               "corr(R G B, height)");
    for (size_t l = 0; l < m.levels.size(); ++l) {
        const LevelSummary& level = m.levels[l];
        // What rounding leaves of a mean of 0 would only distract.
        auto mean = [&level](size_t axis) {
            const double slope = (*level.mean_slope)[axis];
            return std::abs(slope) > 1e-12 * *level.rms_slope ? slope : 0.0;
        };
        const std::string slope =
            level.mean_slope ? fmt::format("{:.3g}, {:.3g}", mean(0), mean(1)) : "-";
        const auto& correlation = level.color_height_correlation;
        const std::string rgb = correlation ? fmt::format("{:.2f} {:.2f} {:.2f}", (*correlation)[0],
                                                          (*correlation)[1], (*correlation)[2])
                                            : "-";
        fmt::print("{:>5} {:>12} {:>21} {:>9} {:>9} {:>8} {:>6} {:>10} {:>20}\n", l,
                   fmt::format("{}x{}", level.width, level.height), slope,
                   cell(level.rms_slope, "{:.4g}"), cell(level.slope_sigma, "{:.4g}"),
                   cell(level.kurtosis, "{:.3g}"), cell(level.tau, "{:.2f}"),
                   cell(level.height_sigma, "{:.4g}"), rgb);
    }
    fmt::print("\nrms: whole slope, the same at every level; sigma in, kurtosis, tau, height std, "
               "corr: inside a texel.\nkurtosis: Mardia's, 8 Gaussian, 16 K0. height std in world "
               "units.\n");
}

void run(const InfoWords& words)
{
    const Manifest manifest = read_manifest(words.set);
    if (words.json) {
        fmt::print("{}", to_json(manifest));
        return;
    }
    print_head(manifest);
    print_textures(manifest);
    print_levels(manifest);
    for (const auto& warning : manifest.warnings)
        fmt::print("warning when baked: {}\n", warning);
}

} // namespace

void add_info(CLI::App& app)
{
    auto words = std::make_shared<InfoWords>();
    auto* command = app.add_subcommand("info", "what a texture set holds, level by level");
    command->add_option("set", words->set, "folder or manifest of a texture set")->required();
    command->add_flag("--json", words->json, "the manifest, machine readable");
    command->callback([words] { run(*words); });
}

} // namespace scree::tool
