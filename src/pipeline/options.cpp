#include "pipeline/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/error.h"
#include "pipeline/named_choice.h"
#include "stats/ranks.h"
#include "texset/udim.h"

namespace scree {

namespace {

const Choices<Wrap> kWraps = {{"periodic", Wrap::periodic},
                              {"clamp", Wrap::clamp},
                              {"mirror", Wrap::mirror},
                              {"black", Wrap::black}};
const Choices<Reconstruction> kReconstructions = {{"bilinear", Reconstruction::bilinear},
                                                  {"central", Reconstruction::central},
                                                  {"sobel", Reconstruction::sobel}};
const Choices<Layout> kLayouts = {{"scree", Layout::scree}, {"bumpslopes", Layout::bumpslopes}};

void expect_tolerance(double tolerance, const char* option)
{
    if (!(tolerance > 0) || !std::isfinite(tolerance))
        throw Error(fmt::format("{} {}: must be above 0, and finite", option, tolerance));
}

/// Maps that are named decide; they must not leave out what tells the visible color.
void expect_map_of(const std::optional<Visibility>& given, Visibility way, Map map,
                   const std::vector<Map>& maps)
{
    if (given == way && !maps.empty() && std::find(maps.begin(), maps.end(), map) == maps.end())
        throw Error(
            fmt::format("--maps leaves out {}, which --visibility asks for; add it, or give "
                        "--visibility without --maps",
                        map_info(map).name));
}

/// As VisibilityPlan has them. A tenth of a degree apart, so that no step between them is endless.
void expect_nodes(const std::vector<double>& angles_deg)
{
    constexpr double kLeastStep = 0.1, kLast = 89.9;
    if (angles_deg.empty() || angles_deg.size() > kMaxNodes)
        throw Error(
            fmt::format("--nodes: {} of them; must be 1 to {}", angles_deg.size(), kMaxNodes));
    double before = 0;
    for (const double angle : angles_deg) {
        if (!(angle >= before + kLeastStep && angle <= kLast))
            throw Error(fmt::format("--nodes: {} after {}; expected rising angles from the normal, "
                                    "degrees, {} or more apart, {} at most",
                                    angle, before, kLeastStep, kLast));
        before = angle;
    }
}

/// Whether something is asked for that is measured on the heights.
bool measures_views(const BakeOptions& options)
{
    const auto has = [&options](Map map) {
        return std::find(options.maps.begin(), options.maps.end(), map) != options.maps.end();
    };
    return options.auto_maps || has(Map::visible) || has(Map::exponent) ||
           options.visibility.value_or(Visibility::smith) != Visibility::smith;
}

/// What a mesh does without: whatever is measured on a plane.
void expect_mesh(const BakeOptions& options)
{
    if (options.mesh_file.empty())
        return;
    if (options.texel_size || options.world_size)
        throw Error("--mesh: its own size is that of the texture on it; leave out --texel-size and "
                    "--world-size");
    if (options.layout == Layout::bumpslopes)
        throw Error("--mesh goes with --layout scree; bumpslopes holds slopes over the texture");
    if (measures_views(options))
        throw Error("--mesh: what views see is measured on planes only; name the --maps, without "
                    "auto, visible and exponent, and leave --visibility at smith");
}

/// What tiles do without, and what only they have.
void expect_tiles(const BakeOptions& options)
{
    const bool tiled = is_tiled(options.height_file);
    if (is_tiled(options.name))
        throw Error(fmt::format("--name {}: numbers of tiles go into the names of textures by "
                                "themselves; leave out <UDIM>",
                                options.name));
    if (options.udim_wrap && options.normal_input)
        throw Error("--udim-wrap: a normal map has its slopes; leave it out");
    if (options.udim_wrap && !tiled)
        throw Error("--udim-wrap speaks of tiles; give --height a name with <UDIM>");
    if (options.udim_wrap && !options.mesh_file.empty())
        throw Error("--udim-wrap and --mesh: the mesh knows which borders meet; leave out "
                    "--udim-wrap");
    if (options.udim_wrap && (options.wrap_s == Wrap::periodic || options.wrap_t == Wrap::periodic))
        throw Error("--udim-wrap and --wrap periodic: a tile meets its neighbours or itself; give "
                    "one of them");
    if (!options.color_file.empty() && tiled != is_tiled(options.color_file))
        throw Error(fmt::format("{} and {}: <UDIM> is in one of the names; name the tiles of both",
                                options.height_file.string(), options.color_file.string()));
    if (tiled && measures_views(options))
        throw Error("<UDIM>: what views see is measured on single maps only; name the --maps, "
                    "without auto, visible and exponent, and leave --visibility at smith");
}

void expect_range(double low, double high)
{
    constexpr double kLargest = 1e30; // squares of differences stay far from the largest double
    if (!(low < high))
        throw Error(
            fmt::format("--map-range: {} to {} is no range; give the lower end first", low, high));
    if (!(std::abs(low) <= kLargest && std::abs(high) <= kLargest))
        throw Error(fmt::format("--map-range: {} to {} is wider than any surface ({:g})", low, high,
                                kLargest));
}

} // namespace

void expect_sensible(const BakeOptions& options)
{
    if (options.texel_size && options.world_size)
        throw Error("--texel-size and --world-size say the same thing; give one of them");
    auto expect_positive = [](const auto& size, const char* option) {
        if (size)
            for (const double side : *size)
                if (!(side > 0) || !std::isfinite(side))
                    throw Error(
                        fmt::format("{}: {} is no size; give world units above 0", option, side));
    };
    expect_mesh(options);
    expect_tiles(options);
    expect_positive(options.texel_size, "--texel-size");
    expect_positive(options.world_size, "--world-size");
    if (!std::isfinite(options.height_scale) || !std::isfinite(options.height_offset))
        throw Error("--height-scale and --height-offset must be finite");
    if (!(options.half_tolerance >= 0) || !std::isfinite(options.half_tolerance))
        throw Error("--half-tolerance must be 0 or more, and finite");
    if (!options.color_file.empty() && !options.colormap_file.empty())
        throw Error("--color and --colormap both say what color the surface has; give one of them");
    if (options.map_range)
        expect_range((*options.map_range)[0], (*options.map_range)[1]);
    if (options.colormap_file.empty() && (options.map_range || options.map_by != MapBy::height))
        throw Error("--map-range and --map-by speak of a color map; give --colormap");
    if (!std::isfinite(options.map_azimuth_deg))
        throw Error("--map-azimuth must be finite");
    expect_tolerance(options.map_tolerance, "--map-tolerance");
    if (options.auto_maps && !options.maps.empty())
        throw Error("--maps auto chooses by itself; give auto, or the maps to bake");
    if (!(options.max_view_angle_deg >= 0 && options.max_view_angle_deg < 90))
        throw Error(fmt::format("--max-view-angle {}: must be 0 (from above) to below 90 degrees",
                                options.max_view_angle_deg));
    expect_tolerance(options.model_tolerance, "--model-tolerance");
    if (options.rank_terms < 1 || options.rank_terms > kMaxRankTerms)
        throw Error(fmt::format("--rank-terms must be 1 to {}", kMaxRankTerms));
    const VisibilityPlan& table = options.table;
    expect_nodes(table.node_angles_deg);
    if (table.harmonics < 0 || table.harmonics > kMaxHarmonics)
        throw Error(fmt::format("--harmonics {}: must be 0 to {}", table.harmonics, kMaxHarmonics));
    if (table.azimuths <= 2 * table.harmonics || table.azimuths > kMaxAzimuths)
        throw Error(fmt::format("--azimuths {}: must be {} (more than twice the harmonics) to {}",
                                table.azimuths, 2 * table.harmonics + 1, kMaxAzimuths));
    if (table.axes && table.azimuths < 5)
        throw Error(fmt::format("--azimuths {}: must be 5 or more for --axes", table.azimuths));
    if (options.axis_deg && !std::isfinite(*options.axis_deg))
        throw Error("--axes: must be auto, or an angle in degrees");
    if (options.layout == Layout::bumpslopes && options.visibility)
        throw Error("--visibility goes with --layout scree; bumpslopes holds no colors");
    expect_map_of(options.visibility, Visibility::tables, Map::visible, options.maps);
    expect_map_of(options.visibility, Visibility::corrected, Map::exponent, options.maps);
    if (options.layout == Layout::bumpslopes && (!options.maps.empty() || options.auto_maps))
        throw Error("--maps goes with --layout scree; bumpslopes is one file of its own");
    if (options.layout == Layout::bumpslopes && !options.colormap_file.empty())
        throw Error("--colormap goes with --layout scree; bumpslopes holds no colors");
}

void BakeMonitor::report(const char* phase, double done) const
{
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
        throw Cancelled();
    if (progress)
        progress(phase, done);
}

Wrap wrap_named(const std::string& name) { return named("--wrap", name, kWraps); }

std::string wrap_name(Wrap wrap) { return name_of(wrap, kWraps); }

Reconstruction reconstruction_named(const std::string& name)
{
    return named("--reconstruction", name, kReconstructions);
}

std::string reconstruction_name(Reconstruction reconstruction)
{
    return name_of(reconstruction, kReconstructions);
}

PixelTypeChoice pixel_type_choice_named(const std::string& name)
{
    return named<PixelTypeChoice>("--pixel-type", name,
                                  {{"auto", PixelTypeChoice::automatic},
                                   {"half", PixelTypeChoice::half},
                                   {"float", PixelTypeChoice::float32}});
}

Layout layout_named(const std::string& name) { return named("--layout", name, kLayouts); }

std::string layout_name(Layout layout) { return name_of(layout, kLayouts); }

NormalRange normal_range_named(const std::string& name)
{
    return named<NormalRange>("--normal-range", name,
                              {{"auto", NormalRange::automatic},
                               {"unsigned", NormalRange::unsigned_unit},
                               {"signed", NormalRange::signed_unit}});
}

Visibility visibility_named(const std::string& name)
{
    return named<Visibility>("--visibility", name,
                             {{"smith", Visibility::smith},
                              {"corrected", Visibility::corrected},
                              {"tables", Visibility::tables}});
}

MapBy map_by_named(const std::string& name, bool azimuth_given)
{
    const bool by_slope = named<bool>("--map-by", name, {{"height", false}, {"slope", true}});
    if (azimuth_given && !by_slope)
        throw Error("--map-azimuth is a direction of the slope; give --map-by slope");
    if (!by_slope)
        return MapBy::height;
    return azimuth_given ? MapBy::slope : MapBy::slope_magnitude;
}

std::string map_by_name(MapBy by)
{
    return name_of<MapBy>(by, {{"height", MapBy::height},
                               {"slope", MapBy::slope},
                               {"slope magnitude", MapBy::slope_magnitude}});
}

bool input_is_normal(const std::string& name)
{
    return named<bool>("--input", name, {{"height", false}, {"normal", true}});
}

} // namespace scree
