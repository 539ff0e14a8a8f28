#pragma once

#include <array>
#include <string>
#include <vector>

#include "color/map_table.h"
#include "judge/set_texel.h"
#include "judge/shading.h"

namespace scree {

/// What the textures of all methods hold for one footprint; each method reads a part of it.
struct FootprintData {
    SetTexel set;                      ///< of a set with all maps
    filter::SlopeMoments<float> sobel; ///< of a set with Sobel slopes, as maketx --bumpslopes has
    /// Mean of the unit normals of the level-0 texels: the shorter, the more they differ.
    Vec3f normal{0, 0, 1};
    /// Parts of set.visible (four nodes, two harmonics), each as a file of its own would hold it:
    /// two nodes, the second and the last, and all of them, without harmonics; all with one.
    std::array<float, 8> visible_2x1{};
    std::array<float, 16> visible_4x1{};
    std::array<float, 48> visible_4x3{};
    std::array<float, 80> visible_axes{}; ///< of a set with tables of four nodes along axes
};

/// Where tables of visibility have their nodes, which a bake decides on: cosines of their angles
/// from the normal.
struct VisibilityNodes {
    std::array<float, 4> four{};          ///< of tables without axes
    std::array<float, 2> two{};           ///< the second and the last of them
    std::array<float, 4> along_axes{};    ///< of tables along axes
    float axis_cosine = 1, axis_sine = 0; ///< of the first axis' angle from +s towards +t
};

/// What all footprints share.
struct MethodSetting {
    Material material;
    /// Colors by normalised height, averaged over normal laws: what the published visible-height
    /// model looks up. Never null.
    const MapTable* height_colors = nullptr;
    VisibilityNodes nodes{};
};

/// A texture that methods read.
enum class MethodTexture {
    normal,
    slope,
    sobel,
    tail,
    height,
    color,
    colorheight,
    colorslope,
    rank,
    exponent, ///< a level has one value: no bytes a texel
    visible_2x1,
    visible_4x1,
    visible_4x3,
    visible_4x5,
    visible_axes
};

struct Reading {
    MethodTexture texture;
    int channels;
};

/// What methods have in common, for a legend.
enum class MethodFamily {
    plain,         ///< nothing hides anything, and the color is the same from everywhere
    masked,        ///< Smith's masking
    correlated,    ///< and color that goes with height or slope, as Scree bakes it
    measured,      ///< Smith's masking, and color as views see it of the heights themselves
    supersampling, ///< no lookup: the surface itself
};

/// A way to shade a footprint from one lookup in its textures.
struct Method {
    std::string name;
    MethodFamily family;
    std::string what; ///< a sentence for readers: what it knows, and its source
    std::vector<Reading> reads;

    /// The color seen along wo.
    Rgbf (*color)(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo);
    /// Radiance over irradiance towards wo under a light along wi; both unit, z > 0.
    Rgbf (*radiance)(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo,
                     const Vec3f& wi);
};

/// All methods, the plainest first. A new one is a row of this table.
const std::vector<Method>& methods();

} // namespace scree
