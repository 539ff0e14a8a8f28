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
    std::string role;   ///< "height", "normal" or "color"
    std::string file;   ///< name without folders
    std::string sha256; ///< of its bytes, in hex
    int width = 0, height = 0;
    std::string channels; ///< the ones used, comma separated
    std::string type;     ///< pixel type in the file, as OpenImageIO names it
    std::string color_space;
};

/// One texture of a set.
struct TextureRecord {
    Map map = Map::slope;
    std::string file;
    PixelType type = PixelType::float32;
    /// Largest error that storing as half or float causes in what a reader recovers, over all
    /// levels (pipeline/storage_error.h); absent when the type was given instead of measured.
    std::optional<double> half_error, float_error;
};

/// What one MIP level holds; means are weighted with coverage. Absent: not baked.
struct LevelSummary {
    int width = 0, height = 0;
    double coverage = 1;
    std::optional<std::array<double, 2>> mean_slope; ///< E[s], E[t]
    std::optional<double> rms_slope;                 ///< sqrt(E[ss] + E[tt]), equal on all levels
    std::optional<double> slope_sigma;  ///< sqrt of the mean slope variance within texels
    std::optional<double> kurtosis;     ///< Mardia's, mean over texels whose slope varies
    std::optional<double> tau;          ///< mean K0 weight
    std::optional<double> height_sigma; ///< sqrt of the mean height variance within texels, world
    /// Correlation of R, G, B with height within texels: mean covariance over the root of the
    /// product of mean variances.
    std::optional<std::array<double, 3>> color_height_correlation;
    std::optional<std::array<double, 3>> mean_color;
};

/// What was baked, from what, with which options: NAME.scree.json.
struct Manifest {
    static constexpr int kFormatVersion = 1;

    std::string name;
    std::string program_version;
    std::vector<InputRecord> inputs;
    int width = 0, height = 0;
    std::string wrap_s, wrap_t;
    double texel_width = 1, texel_height = 1; ///< world units
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
    std::vector<TextureRecord> textures;
    std::vector<LevelSummary> levels;
    std::map<std::string, std::string> options; ///< as given, by long name
    std::vector<std::string> warnings;
};

/// Throws Error when the file cannot be written whole.
void write_manifest(const Manifest& manifest, const std::filesystem::path& folder);

/// Reads the manifest of a set: its folder, or the .scree.json file itself.
/// Throws Error when there is none or several, or it is damaged or of a later format.
Manifest read_manifest(const std::filesystem::path& set);

/// The manifest as JSON text.
std::string to_json(const Manifest& manifest);

/// Names of the files of the set in `folder`, manifest included; empty when there is no set.
std::set<std::string> files_of_set(const std::filesystem::path& folder);

} // namespace scree
