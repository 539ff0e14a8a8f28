#pragma once

#include <filesystem>
#include <memory>

#include "texset/manifest.h"

namespace scree {

/// Where a texture is looked up, and how that changes from pixel to pixel: the footprint is the
/// parallelogram of the two changes, filtered over its ellipse.
struct TexturePlace {
    float s = 0, t = 0; ///< 0 to 1 over the map, row 0 at t = 0
    float ds_dx = 0, dt_dx = 0, ds_dy = 0, dt_dy = 0;
};

/// What of its filter a renderer chooses.
struct TextureFilter {
    int anisotropy = 32;   ///< longest over shortest axis of an ellipse; beyond, it is blurred
    bool is_tiled = false; ///< the maps repeat, whatever their wrap
    int cache_megabytes = 256;
};

/// The textures of a set as a renderer reads them: through OpenImageIO's TextureSystem, filtered
/// between texels and levels. Any number of threads may look up at once.
class TextureLookup {
public:
    /// folder  of the set
    /// Throws Error, naming the file, when a texture of the manifest cannot be opened, or has other
    /// channels.
    TextureLookup(const std::filesystem::path& folder, const Manifest& manifest,
                  const TextureFilter& filter = {});
    ~TextureLookup();
    TextureLookup(TextureLookup&&) noexcept;
    TextureLookup& operator=(TextureLookup&&) noexcept;

    [[nodiscard]] bool has(Map map) const;

    /// Number of channels of a map of the set.
    [[nodiscard]] int channels(Map map) const;

    /// Channels [first, first + count) of a map of the set, in the order of its record.
    ///
    /// result  gets count numbers
    /// Throws Error, naming the file, when it is damaged.
    void read(Map map, const TexturePlace& place, int first, int count, float* result) const;

private:
    struct System;
    std::unique_ptr<System> system_;
};

} // namespace scree
