#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "judge/set_texel.h"
#include "judge/shading.h"
#include "texset/manifest.h"

namespace scree {

/// The texels of a baked set, read as a renderer would.
class SetReader {
public:
    /// set   its folder, or its manifest
    /// tile  UDIM number of a tile; 0: the set is one map
    /// Throws Error when a texture that the manifest names is missing, damaged, or of another size.
    explicit SetReader(const std::filesystem::path& set, int tile = 0);
    ~SetReader();
    SetReader(SetReader&&) noexcept;

    [[nodiscard]] const Manifest& manifest() const { return manifest_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const SetColors& colors() const { return colors_; }

    /// Row `y` of a level; white where the set has no colors.
    [[nodiscard]] std::vector<SetTexel> row(int level, int y);

private:
    struct Texture;
    std::filesystem::path folder_;
    Manifest manifest_;
    SetColors colors_;
    bool has_color_ = false;
    std::vector<Texture> textures_;
};

} // namespace scree
