#pragma once

#include <array>
#include <map>
#include <vector>

#include "pipeline/gutter.h"
#include "pipeline/moment_pyramid.h"
#include "pipeline/options.h"
#include "pipeline/texture_rows.h"

namespace scree {

/// Gives the textures of a set their gutter (pipeline/gutter.h), at every level.
///
/// Stands between a MomentPyramid and the textures, which get their texels through it. A tile row
/// is handed out once the rows below that its gutter needs are made, kGutterRings of them and one
/// that needs it; where the map is periodic along t the first tile row of a level waits for the
/// last. So a level holds two or three tile rows rather than one. Along a wrap that is not periodic
/// nothing lies beyond the edge.
class GutterRows : public TexelVisitor {
public:
    /// width, height  of level 0
    /// textures       whose gutter is to be made, and others that hold none
    GutterRows(int width, int height, Wrap wrap_s, Wrap wrap_t, std::vector<TextureRows*> textures);

    void rows_begin(int level, int begin, int end) override;
    void texels(int level, int y, int x0, int count, MomentRow row) override;
    void rows_end(int level, int end) override;

private:
    struct Level {
        int width = 0, height = 0;
        /// Rows of ring r are grown from row 0, or, periodic, from row r on; up to this one.
        std::array<int, kGutterRings + 1> grown{};
        std::map<int, std::vector<Ring>> rings; ///< of the rows still needed
    };
    /// One row's texels of a ring.
    struct GrownRow {
        int y = 0;
        std::vector<GutterTexel> texels;
    };
    [[nodiscard]] RingRows rows_around(Level& level, int y) const;
    void grow(int level, int ring, bool complete);
    void forget(Level& level) const;

    bool periodic_s_, periodic_t_;
    std::vector<TextureRows*> textures_;
    std::vector<Level> levels_;
};

} // namespace scree
