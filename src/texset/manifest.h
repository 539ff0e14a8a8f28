#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "texset/channels.h"
#include "texset/mip_file.h"

namespace scree {

/// An input file, so that a set says what it was made of.
struct InputRecord {
    std::string role;   ///< "height", "normal", "color", "colormap" or "mesh"
    std::string file;   ///< name without folders
    std::string sha256; ///< of its bytes, in hex
    int width = 0, height = 0;
    std::string channels; ///< the ones used, comma separated
    std::string type;     ///< pixel type in the file, as OpenImageIO names it
    std::string color_space;
    int tile = 0; ///< UDIM number of what it belongs to; 0: to all
};

/// One texture of a set.
struct TextureRecord {
    Map map = Map::slope;
    std::string file;                  ///< of tiles with <UDIM> for their number
    std::vector<std::string> channels; ///< as MapInfo has them; of a rank table as many as it has
    PixelType type = PixelType::float32;
    /// Largest error that storing as half or float causes in what a reader recovers, over all
    /// levels (pipeline/storage_error.h); absent when the type was given instead of measured.
    std::optional<double> half_error, float_error;
};

/// The table T(mean, deviation) of a color map, NAME.map.exr (color/filtered_map.h).
///
/// Means and deviations are in the units a renderer has them in: of normalised height, as
/// NAME.height.exr, or of slope. Errors are shares of the map's color span.
struct MapTableRecord {
    int columns = 1, rows = 1;
    double low = 0, high = 1; ///< means at the centres of the first and the last column
    double widest = 1;        ///< deviation at the centre of the last row; 0 at that of the first
    double tolerance = 0;     ///< asked for, of rms_error
    double rms_error = 0;     ///< of interpolation, over the means, at the worst deviation
    double largest_error = 0; ///< of interpolation, at deviations of at least a column's width
    /// What taking visible heights as normal costs; absent for slopes.
    std::optional<double> shortcut_rms, shortcut_largest;
};

/// The color map of a set whose color follows from its heights or slopes.
struct ColorMapRecord {
    std::string by;                      ///< "height", "slope" or "slope magnitude"
    double azimuth_deg = 0;              ///< of "slope": the direction, from +s towards +t
    double first = 0, last = 1;          ///< ends of the map: world units, or slope
    std::optional<MapTableRecord> table; ///< absent where it was not asked for
};

/// How the color inside the texels of a level goes with their heights and slopes; shares are R^2,
/// explained over all variance, in [0, 1] (pipeline/color_fit.h). Absent: not baked.
struct ColorFit {
    double sigma = 0; ///< rms deviation of the color inside texels, scene-linear
    /// Of R, G, B with height: mean covariance over the root of the product of mean variances.
    std::optional<std::array<double, 3>> height_correlation;
    /// Of R, G, B with the slope: multiple correlation, >= 0.
    std::optional<std::array<double, 3>> slope_correlation;
    std::optional<double> height;              ///< R^2 of the linear model by height
    std::optional<double> slope;               ///< R^2 of the linear model by slope
    std::optional<double> rank1, rank2, rank4; ///< R^2 of 1, 2, 4 terms by height rank
    double residual = 0; ///< rms deviation that the best of them leaves, scene-linear
};

/// The exponent that shows color by height as it was measured to be seen, in place of Smith's
/// Lambda: gain max(Lambda - threshold, 0)^power, Lambda of the raw second moments of the slope
/// (pipeline/exponent_fit.h).
struct ExponentFit {
    double gain = 1, power = 1, threshold = 0;
};

/// What a way to tell the visible color leaves of a level (pipeline/model_errors.h).
struct LevelError {
    std::string model;
    double error = 0; ///< rms, of the worst elevation
};

/// What one MIP level holds; means are weighted with coverage. Absent: not baked.
struct LevelSummary {
    int width = 0, height = 0;
    double coverage = 1;
    std::optional<std::array<double, 2>> mean_slope; ///< E[s], E[t]
    std::optional<std::array<double, 2>> steepest;   ///< largest |E[s]|, |E[t]| of a texel
    std::optional<double> rms_slope;                 ///< sqrt(E[ss] + E[tt]), equal on all levels
    std::optional<double> slope_sigma;  ///< sqrt of the mean slope variance within texels
    std::optional<double> kurtosis;     ///< Mardia's, mean over texels whose slope varies
    std::optional<double> tau;          ///< mean K0 weight
    std::optional<double> height_sigma; ///< sqrt of the mean height variance within texels, world
    std::optional<std::array<double, 3>> mean_color;
    std::optional<ColorFit> color_fit;
    std::optional<ExponentFit> exponent;  ///< of the linear model by height
    std::vector<LevelError> model_errors; ///< empty where they were not measured
};

/// A way to show what a map holds, or to do without it, and what that costs
/// (pipeline/model_errors.h).
struct ModelRecord {
    std::string model;   ///< "mean color", "colorheight", "rank 2", ..., or "without tail", ...
    int channels = 0;    ///< that it reads, beside mean color and slope; < 0: that it saves
    double error = 0;    ///< rms over texels, of the worst elevation, and over levels
    int rank_terms = 0;  ///< of a rank table, else 0
    bool chosen = false; ///< of "without ...": the map was dropped
};

/// How `--maps auto` decided.
struct ModelChoice {
    double max_view_angle_deg = 0;
    double tolerance = 0;
    std::vector<ModelRecord> models;
};

/// How a table of visibility is laid out, NAME.visible.exr (visibility/view_components.h).
struct VisibilityRecord {
    std::vector<double> node_angles_deg; ///< from the normal, rising
    int harmonics = 0;                   ///< of the azimuth, 0 to 2
    int azimuths = 0;                    ///< that were swept
    std::optional<double> axis_deg;      ///< along axes instead: the first, from +s towards +t
};

/// The mesh that a set, or one of its tiles, was baked for (docs/surfaces.md).
struct MeshRecord {
    std::string scheme, boundary, uv_interpolation; ///< that took effect, as options are named
    int faces = 0;                                  ///< of the cage
    int charts = 0, mirrored_charts = 0;            ///< of the cage
    long long covered = 0;                          ///< texels of level 0 in its charts
    long long overlapped = 0, mirrored = 0;         ///< of those
    long long singular = 0;                         ///< in charts, but left out: no tangents
    double area = 0;                                ///< of its texels, world units^2
    double largest_displacement = 0;                ///< largest |height x curvature| of a texel
    std::array<int, 2> displaced_most{0, 0};        ///< where: column, row
    int displaced_tile = 0;                         ///< and in which tile; 0: there are none
    /// |height x curvature| that 99 % of the area stay below; of tiles the largest of theirs.
    double usual_displacement = 0;
};

/// One tile of a set of tiles.
struct TileRecord {
    int number = 1001; ///< UDIM
    int width = 0, height = 0;
    double texel_width = 1, texel_height = 1; ///< as Manifest has them
    long long no_data_texels = 0;
    std::optional<MeshRecord> mesh;
    std::vector<LevelSummary> levels;
};

/// What was baked, from what, with which options: NAME.scree.json.
///
/// Of a set of tiles width, height and size of texels are those of the largest, sums over all are
/// at the top, and levels are told tile by tile.
struct Manifest {
    static constexpr int kFormatVersion = 3;

    std::string name;
    std::string program_version;
    std::vector<InputRecord> inputs;
    int width = 0, height = 0;
    std::string wrap_s, wrap_t;
    double texel_width = 1, texel_height = 1; ///< world units; of a mesh texture units
    double height_scale = 1, height_offset = 0;
    std::string reconstruction;
    std::string layout;
    std::string working_space; ///< OCIO name; empty without color
    bool has_height = false;
    double h0 = 0, h1 = 1; ///< mean and standard deviation of the height, world units
    double height_min = 0, height_max = 0;
    int integer_bits = 0; ///< of the height file, 0 for floating point
    double quantum = 0;   ///< one step of an integer height file, world units
    long long no_data_texels = 0;
    double half_tolerance = 0;
    std::string compression;
    std::optional<MeshRecord> mesh; ///< absent: a plane
    std::optional<ColorMapRecord> color_map;
    std::optional<ModelChoice> model_choice; ///< of --maps auto
    std::optional<VisibilityRecord> visibility;
    std::vector<TextureRecord> textures;
    std::vector<LevelSummary> levels;           ///< empty for tiles
    std::vector<TileRecord> tiles;              ///< empty: the set is one map
    std::map<std::string, std::string> options; ///< as given, by long name
    std::vector<std::string> warnings;
};

/// Throws Error when the file cannot be written whole.
void write_manifest(const Manifest& manifest, const std::filesystem::path& folder);

/// Reads the manifest of a set: its folder, or the .scree.json file itself.
/// Throws Error when there is none or several, or it is damaged or of a later format.
Manifest read_manifest(const std::filesystem::path& set);

/// What the manifest of a set says of one of its tiles, as if that were a set of its own, or of a
/// set that is one map.
///
/// tile  its number; 0: none is meant
/// Throws Error for a tile that is not there, and where the set has tiles and none is meant.
Manifest manifest_of_map(const Manifest& set, int tile);

/// The manifest as JSON text.
std::string to_json(const Manifest& manifest);

/// Files of a texture: of tiles, one of each.
std::vector<std::string> files_of(const TextureRecord& texture, const Manifest& manifest);

/// Names of the files of the set in `folder`, manifest included; empty when there is no set.
std::set<std::string> files_of_set(const std::filesystem::path& folder);

} // namespace scree
