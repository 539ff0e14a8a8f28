#pragma once

#include <Imath/ImathVec.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernel/filter.h"
#include "pipeline/options.h"
#include "shaders/visible_tables.h"
#include "support/files.h"

namespace scree::test {

/// The maps of a set baked in float32, as read back: levels, 0 the finest; the table of a color map
/// is one level, and empty where the set has none.
struct SampleSet {
    float world_width = 0, world_height = 0;
    std::vector<Image> slope, height, color, colorheight, colorslope, rank, tail;
    Image map;
    filter::ColorMapTable<float> map_table; ///< as the manifest has it
    std::string map_by;                     ///< likewise
    float map_azimuth_rad = 0;
    VisibleTables visible;       ///< no levels where the set has none
    std::vector<Image> exponent; ///< likewise
};

/// Any set with height and color.
SampleSet read_set(const std::filesystem::path& folder);

/// A built-in sample, baked in float32 as "test" into a folder.
///
/// colored_by  a color map by that, instead of the sample's own colors
void bake_sample_into(const std::filesystem::path& folder, const std::string& kind, int width,
                      int height, std::optional<MapBy> colored_by = {});

/// The same, only to be looked at.
SampleSet bake_sample(const std::string& kind, int width, int height,
                      std::optional<MapBy> colored_by = {});

/// The value of a channel by its name; fails the test when there is none.
float value(const Image& image, int x, int y, const std::string& channel);

/// R, G and B of a texel.
Imath::V3f rgb(const Image& image, int x, int y);

/// Slopes of a texel, as looked up and made of that; heights are scaled.
filter::SlopeMoments<float> slope_moments_of(const SampleSet& set, size_t level, int x, int y,
                                             float height_scale = 1);
filter::Slopes<float> slopes_of(const SampleSet& set, size_t level, int x, int y,
                                float height_scale = 1);

/// How scree_visible_color() in OSL tells the color, its parameters.
struct ColorLook {
    int color_model = 1; ///< 0 mean color, 1 linear in height, 2 height rank, 3 color map, 4
                         ///< visibility tables, 5 linear in height with the measured exponent
    bool slope_color = false;
    float light_exponent = 0;
    float height_scale = 1;
    Imath::V3f light{0, 0, 0}; ///< unit, of models 4 and 5; 0 leaves it out
};

/// What the kernel's C++ front makes of a texel; channels are read by their names.
Imath::V3f visible_color(const SampleSet& set, size_t level, int x, int y, const Imath::V3f& view,
                         const ColorLook& look);

} // namespace scree::test
