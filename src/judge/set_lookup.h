#pragma once

#include <filesystem>
#include <vector>

#include "judge/set_reader.h"
#include "texset/texture_lookup.h"

namespace scree {

/// A baked set as a renderer meets it: filtered lookups, in the maps that its best way to tell the
/// visible color needs. Any number of threads may look up at once.
class SetLookup {
public:
    /// set   its folder, or its manifest
    /// tile  UDIM number of a tile; 0: the set is one map
    /// Throws Error as SetReader and TextureLookup do.
    explicit SetLookup(const std::filesystem::path& set, const TextureFilter& filter = {},
                       int tile = 0);

    [[nodiscard]] const Manifest& manifest() const { return reader_.manifest(); }
    [[nodiscard]] const SetColors& colors() const { return reader_.colors(); }

    /// White where the set has no colors.
    [[nodiscard]] SetTexel at(const TexturePlace& place) const;

private:
    SetReader reader_;
    TextureLookup textures_;
    std::vector<Map> maps_;
};

} // namespace scree
