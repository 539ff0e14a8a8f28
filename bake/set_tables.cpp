#include "bake/set_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::tool {

namespace {

std::string cell(const std::optional<double>& value, const char* format)
{
    return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string triple(const std::optional<std::array<double, 3>>& rgb)
{
    return rgb ? fmt::format("{:.2f} {:.2f} {:.2f}", (*rgb)[0], (*rgb)[1], (*rgb)[2]) : "-";
}

size_t column_width(const LevelError& error) { return std::max<size_t>(error.model.size(), 7); }

void print_visibility(const VisibilityRecord& table)
{
    fmt::print("  visibility from {} azimuths at {:g} degrees from the normal, ", table.azimuths,
               fmt::join(table.node_angles_deg, ", "));
    if (table.axis_deg)
        fmt::print("along axes at {:.4g} and {:.4g} degrees from +s\n", *table.axis_deg,
                   *table.axis_deg + 90);
    else
        fmt::print("{} harmonic{}\n", table.harmonics, table.harmonics == 1 ? "" : "s");
}

std::string columns_of_tile(const TileRecord& tile)
{
    const bool known = !tile.levels.empty();
    return fmt::format("{:>12} {:>6} {:>10} {:>10} {:>10}",
                       fmt::format("{}x{}", tile.width, tile.height), tile.levels.size(),
                       tile.no_data_texels,
                       known ? fmt::format("{:.3f}", tile.levels.front().coverage) : "-",
                       known ? cell(tile.levels.back().rms_slope, "{:.4g}") : "-");
}

} // namespace

void print_mesh(const Manifest& m)
{
    if (!m.mesh)
        return;
    const MeshRecord& mesh = *m.mesh;
    if (!mesh.scheme.empty()) // sets of before format 3 do not say
        fmt::print("  {} subdivision, boundary {}, UVs linear: {}\n", mesh.scheme, mesh.boundary,
                   mesh.uv_interpolation);
    fmt::print("  charts: {}, mirrored: {}; {} texels in them, {:g} square world units; overlapped "
               "{}, mirrored {}, without tangents {}\n",
               mesh.charts, mesh.mirrored_charts, mesh.covered, mesh.area, mesh.overlapped,
               mesh.mirrored, mesh.singular);
    if (!(mesh.largest_displacement > 0))
        return;
    fmt::print("  height times curvature: {:.2g} at most, at texel {}, {}{}; below {:.2g} on 99 % "
               "of the area\n",
               mesh.largest_displacement, mesh.displaced_most[0], mesh.displaced_most[1],
               mesh.displaced_tile == 0 ? "" : fmt::format(" of tile {}", mesh.displaced_tile),
               mesh.usual_displacement);
}

void print_tiles(const Manifest& m)
{
    if (m.tiles.empty())
        return;
    fmt::print("\ntile {:>12} {:>6} {:>10} {:>10} {:>10}\n", "size", "levels", "no data",
               "coverage", "rms");
    for (const TileRecord& tile : m.tiles)
        fmt::print("{} {}\n", tile.number, columns_of_tile(tile));
}

void print_head(const Manifest& m)
{
    if (m.tiles.empty())
        fmt::print("{}  {}x{}, {} levels, scree {}\n", m.name, m.width, m.height, m.levels.size(),
                   m.program_version);
    else
        fmt::print("{}  {} tiles, {}x{} the largest, scree {}\n", m.name, m.tiles.size(), m.width,
                   m.height, m.program_version);
    for (const auto& input : m.inputs) {
        const std::string what =
            input.role == "mesh"
                ? fmt::format("faces: {}", m.mesh ? m.mesh->faces : 0)
                : fmt::format("{}x{} {}, channels {}{}{}", input.width, input.height, input.type,
                              input.channels, input.color_space.empty() ? "" : ", ",
                              input.color_space);
        fmt::print("  {:8} {} ({}) sha256 {:.12}...\n", input.role, input.file, what, input.sha256);
    }
    fmt::print("  wrap {} {}, texel {:g} x {:g} {} units, {} slopes\n", m.wrap_s, m.wrap_t,
               m.texel_width, m.texel_height, m.mesh ? "texture" : "world", m.reconstruction);
    print_mesh(m);
    if (m.has_height)
        fmt::print("  height {:g} to {:g}, mean h0 {:g}, standard deviation h1 {:g}\n",
                   m.height_min, m.height_max, m.h0, m.h1);
    if (!m.working_space.empty())
        fmt::print("  colors in {}\n", m.working_space);
    if (m.visibility)
        print_visibility(*m.visibility);
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
        for (const auto& channel : texture.channels)
            channels += (channels.empty() ? "" : " ") + channel;
        fmt::print("{:{}} {:6} {:10} {:10} {}\n", texture.file, width,
                   pixel_type_name(texture.type), cell(texture.half_error, "{:.1e}"),
                   cell(texture.float_error, "{:.1e}"), channels);
    }
}

void print_levels(const Manifest& m)
{
    fmt::print("\n{:>5} {:>12} {:>21} {:>9} {:>9} {:>8} {:>6} {:>10}\n", "level", "size",
               "mean slope s, t", "rms", "sigma in", "kurtosis", "tau", "height std");
    for (size_t l = 0; l < m.levels.size(); ++l) {
        const LevelSummary& level = m.levels[l];
        // What rounding leaves of a mean of 0 would only distract.
        auto mean = [&level](size_t axis) {
            const double slope = (*level.mean_slope)[axis];
            return std::abs(slope) > 1e-12 * *level.rms_slope ? slope : 0.0;
        };
        const std::string slope =
            level.mean_slope ? fmt::format("{:.3g}, {:.3g}", mean(0), mean(1)) : "-";
        fmt::print("{:>5} {:>12} {:>21} {:>9} {:>9} {:>8} {:>6} {:>10}\n", l,
                   fmt::format("{}x{}", level.width, level.height), slope,
                   cell(level.rms_slope, "{:.4g}"), cell(level.slope_sigma, "{:.4g}"),
                   cell(level.kurtosis, "{:.3g}"), cell(level.tau, "{:.2f}"),
                   cell(level.height_sigma, "{:.4g}"));
    }
    fmt::print("\nrms: whole slope, the same at every level; sigma in, kurtosis, tau, height std: "
               "inside a texel.\nkurtosis: Mardia's, 8 Gaussian, 16 K0. height std in world "
               "units.\n");
}

void print_color_fit(const Manifest& m)
{
    const bool any = std::any_of(m.levels.begin(), m.levels.end(),
                                 [](const LevelSummary& level) { return level.color_fit; });
    if (!any)
        return;
    fmt::print("\n{:>5} {:>9}  {:>17}  {:>14} {:>7} {:>6} {:>6} {:>6} {:>6} {:>9}\n", "level",
               "color std", "corr with height", "with slope", "R2: h", "slope", "rank 1", "rank 2",
               "rank 4", "left");
    for (size_t l = 0; l < m.levels.size(); ++l) {
        if (!m.levels[l].color_fit)
            continue;
        const ColorFit& fit = *m.levels[l].color_fit;
        fmt::print("{:>5} {:>9.4g}  {:>17}  {:>14} {:>7} {:>6} {:>6} {:>6} {:>6} {:>9.4g}\n", l,
                   fit.sigma, triple(fit.height_correlation), triple(fit.slope_correlation),
                   cell(fit.height, "{:.3f}"), cell(fit.slope, "{:.3f}"), cell(fit.rank1, "{:.3f}"),
                   cell(fit.rank2, "{:.3f}"), cell(fit.rank4, "{:.3f}"), fit.residual);
    }
    fmt::print("\ncolor std: deviation of the color inside a texel. R2: share of its variance that "
               "a model explains: linear in\nheight (colorheight), in slope (colorslope), 1, 2, 4 "
               "terms by height rank (rank). left: deviation the best leaves.\n");
}

void print_model_errors(const Manifest& m)
{
    if (m.levels.empty() || m.levels.back().model_errors.empty())
        return;
    fmt::print("\n{:>5}", "level");
    for (const LevelError& error : m.levels.back().model_errors)
        fmt::print(" {:>{}}", error.model, column_width(error));
    fmt::print("\n");
    for (size_t l = 0; l < m.levels.size(); ++l) {
        fmt::print("{:>5}", l);
        for (const LevelError& error : m.levels[l].model_errors)
            fmt::print(" {:>{}.2g}", error.error, column_width(error));
        fmt::print("\n");
    }
    fmt::print(
        "\nwhat each way to tell the visible color leaves (rms, relative, of the worst "
        "elevation), measured on the heights:\nmean color, rank and colorheight with "
        "Smith's exponent, colorheight with a fitted exponent, visible NODESxTERMS, or NODES "
        "along axes.\n");
}

void print_color_map(const Manifest& m)
{
    if (!m.color_map)
        return;
    const ColorMapRecord& map = *m.color_map;
    fmt::print("\ncolor map by {}{}, {:g} to {:g}\n", map.by,
               map.by == "slope" ? fmt::format(" along {:g} degrees", map.azimuth_deg) : "",
               map.first, map.last);
    if (!map.table)
        return;
    const MapTableRecord& table = *map.table;
    fmt::print(
        "  table {}x{}: means {:.4g} to {:.4g}, deviations to {:.4g}{}; interpolation error "
        "{:.2g} (rms), {:.2g} (largest){}\n",
        table.columns, table.rows, table.low, table.high, table.widest,
        map.by == "height" ? " (normalised heights)" : "", table.rms_error, table.largest_error,
        table.rms_error > table.tolerance
            ? fmt::format(", above the tolerance of {:g}: no larger table is made", table.tolerance)
            : "");
    if (table.shortcut_rms)
        fmt::print("  visible heights taken as normal: {:.2g} (rms), {:.2g} (largest)\n",
                   *table.shortcut_rms, *table.shortcut_largest);
}

void print_model_choice(const Manifest& m)
{
    if (!m.model_choice)
        return;
    const ModelChoice& choice = *m.model_choice;
    fmt::print("\nmodels for views to {:g} degrees, tolerance {:g}; what each costs in visible "
               "color (rms, relative)\n",
               choice.max_view_angle_deg, choice.tolerance);
    bool within = true;
    for (const ModelRecord& model : choice.models) {
        const bool drops = model.channels < 0; // "without ..."
        const char* decision =
            drops ? (model.chosen ? "dropped" : "kept") : (model.chosen ? "chosen" : "");
        within = within && (drops || !model.chosen || model.error <= choice.tolerance);
        fmt::print("  {:20} {:+3} channels  error {:<8.2g} {}\n", model.model, model.channels,
                   model.error, decision);
    }
    if (!within)
        fmt::print("  none is within the tolerance; the cheapest within it of the most accurate is "
                   "chosen\n");
}

} // namespace scree::tool
