#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stats/cell.h"
#include "surface/limit_surface.h"
#include "texset/channels.h"
#include "texset/chunk_codec.h"
#include "visibility/view_components.h"

namespace scree {

enum class Wrap { periodic, clamp, mirror, black };
enum class PixelTypeChoice { automatic, half, float32 };
enum class Layout { scree, bumpslopes };
/// How the visible color is told.
enum class Visibility {
    smith,     ///< models whose exponent is Smith's, from the slopes
    corrected, ///< the same, the exponent fitted to what was measured on the heights
    tables,    ///< tables of what was measured
};
enum class NormalRange { automatic, unsigned_unit, signed_unit };

/// What a color map is a function of.
enum class MapBy {
    height,          ///< world units
    slope,           ///< the slope along an azimuth
    slope_magnitude, ///< sqrt(s^2 + t^2)
};

/// Everything a bake depends on; equal options and inputs give equal bytes.
struct BakeOptions {
    /// Height map, or normal map with `normal_input`; "<UDIM>" in its name stands for tiles.
    std::filesystem::path height_file;
    std::filesystem::path color_file; ///< empty: no color
    std::filesystem::path output;     ///< folder of the set
    std::string name;                 ///< of the set; empty: the height file's stem

    std::string height_channel;           ///< name or index; empty: the only channel
    double height_scale = 1;              ///< world units a unit of the (normalised) file value
    double height_offset = 0;             ///< world units
    std::optional<double> no_data_height; ///< file values equal to it are no data
    std::optional<std::array<double, 2>> texel_size; ///< world units, s and t
    std::optional<std::array<double, 2>> world_size; ///< of the whole map, world units
    bool world_height_given = true; ///< else square texels decide the height of world_size
    Wrap wrap_s = Wrap::periodic, wrap_t = Wrap::periodic;
    Reconstruction reconstruction = Reconstruction::bilinear;

    std::filesystem::path mesh_file; ///< the texture lies on its limit surface; empty: on a plane
    SurfaceOptions subdivision;      ///< of the mesh
    bool udim_wrap = false; ///< tiles on a plane: slopes at a border see the tile beyond it

    bool normal_input = false; ///< the height file holds tangent-space normals
    NormalRange normal_range = NormalRange::automatic;
    bool invert_x = false, invert_y = false;

    bool alpha_weight = false; ///< texels count by their alpha
    bool resample = false;     ///< color of another size is resampled to the height's
    std::string ocio_config, color_space;
    std::string working_space; ///< scene-linear, of the config; empty: its role scene_linear

    std::filesystem::path colormap_file; ///< color map instead of a color file; empty: none
    MapBy map_by = MapBy::height;
    double map_azimuth_deg = 0; ///< from +s towards +t, for MapBy::slope
    /// What the map's ends stand for, world units or slope; see placed() in mapped_color.h.
    std::optional<std::array<double, 2>> map_range;
    double map_tolerance = 0.01; ///< of the table T(mean, deviation), see color/filtered_map.h

    std::vector<Map> maps;  ///< empty: those the inputs allow
    bool auto_maps = false; ///< drop those of them that no view needs (pipeline/model_errors.h)
    /// Nodes of `table` go to where the surface begins to hide (moved_node_angles()).
    bool move_nodes = true;
    double max_view_angle_deg = 85; ///< from the normal; the steepest view that auto_maps looks at
    double model_tolerance = 0.01;  ///< of the visible color, relative, see pipeline/model_errors.h
    VisibilityPlan table{best_node_angles(kDefaultNodes), 0, 8}; ///< of Map::visible
    /// Of tables along axes, also those that auto_maps tries; absent: where most slopes lie
    /// (visibility/slope_survey.h).
    std::optional<double> axis_deg;
    int rank_terms = kDefaultRankTerms; ///< of a rank table, 1 to 8
    /// Absent: smith, of `auto_maps` whatever does.
    std::optional<Visibility> visibility;
    PixelTypeChoice pixel_type = PixelTypeChoice::automatic;
    double half_tolerance = 0.01; ///< see pipeline/storage_error.h
    Compression compression = Compression::zip;
    Layout layout = Layout::scree;
    int threads = 0;                             ///< 0: all there are
    std::map<std::string, std::string> as_given; ///< recorded in the manifest
};

/// Throws Error when options contradict each other or hold no sensible number.
void expect_sensible(const BakeOptions& options);

/// What a bake tells while it runs, and how it is told to stop.
struct BakeMonitor {
    std::function<void(const char* phase, double done)> progress; ///< done in [0, 1]
    const std::atomic<bool>* cancel = nullptr;

    /// Throws Cancelled when asked to stop.
    void report(const char* phase, double done) const;
};

/// Option values by the words of the command line. Throws Error naming the choices.
Wrap wrap_named(const std::string& name);
std::string wrap_name(Wrap wrap);
Reconstruction reconstruction_named(const std::string& name);
std::string reconstruction_name(Reconstruction reconstruction);
PixelTypeChoice pixel_type_choice_named(const std::string& name);
Layout layout_named(const std::string& name);
std::string layout_name(Layout layout);
NormalRange normal_range_named(const std::string& name);
Visibility visibility_named(const std::string& name);
bool input_is_normal(const std::string& name);
/// height, or slope: with an azimuth the slope along it, without its magnitude.
MapBy map_by_named(const std::string& name, bool azimuth_given);
/// "height", "slope" or "slope magnitude".
std::string map_by_name(MapBy by);

} // namespace scree
