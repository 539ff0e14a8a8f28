#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "pipeline/surface.h"
#include "texset/spool.h"
#include "visibility/height_grid.h"

namespace scree {

/// The heights of a surface with all their levels, kept as floats in unnamed files, for sweeps to
/// read anywhere: 16 bytes for 3 texels.
///
/// Heights are relative to their mean, so that floats hold a low relief on a high place.
class SpooledHeights : public HeightGrid {
public:
    /// Reads the surface once. A texel of weight 0 has no height.
    ///
    /// folder  where the files take their room
    /// Throws Error where there is no room, as the source does, and Cancelled.
    SpooledHeights(const Surface& surface, const std::filesystem::path& folder);

protected:
    void read_row(int level, int x, int y, int count, float* heights) const override;

private:
    std::vector<std::unique_ptr<Spool>> spools_; ///< a level
    std::vector<const float*> levels_;
};

} // namespace scree
