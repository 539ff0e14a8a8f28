#pragma once

#include <atomic>
#include <map>
#include <vector>

#include "pipeline/gutter.h"
#include "pipeline/moment_pyramid.h"
#include "pipeline/pool.h"
#include "pipeline/texture_values.h"
#include "texset/mip_file.h"

namespace scree {

/// Lays the texels of one map out as tiles, level by level.
///
/// Finished tile rows are handed out in an order that depends on the sizes alone.
class TextureRows : public TexelVisitor {
public:
    TextureRows(Map map, const MomentLayout& layout, const ValueScale& scale, const MipFile& file);

    void rows_begin(int level, int begin, int end) override;
    void texels(int level, int y, int x0, int count, MomentRow row) override;
    void rows_end(int level, int end) override;

    /// Gives texels of a row the mean of their neighbours, those across the map's edges included.
    ///
    /// Coverage stays as it is. The rows of the neighbours are not finished. Different rows, and
    /// texels that are not each other's neighbours, on different threads.
    void blend(int level, int y, const std::vector<GutterTexel>& texels);

    /// Finishes the tile rows inside rows [begin, end) of a level.
    ///
    /// begin  of a tile row
    void finish(int level, int begin, int end);

    /// The tile rows finished since the last call.
    std::vector<TileRow> take_finished();

    /// Takes back a row that is in the file; its memory is used again.
    void recycle(TileRow row);

    /// True once a number did not fit the file's half floats.
    [[nodiscard]] bool overflowed() const { return overflowed_; }

private:
    template <class Store>
    void store_texels(int level, int y, int x0, int count, MomentRow row);
    template <class Store>
    void blend_texels(int level, int y, const GutterTexel* texels, int count);
    TileRow& open_row(int level, int y);

    Map map_;
    MomentLayout layout_;
    ValueScale scale_;
    const MipFile& file_;
    std::vector<std::map<int, TileRow>> open_; ///< a level: tile rows being filled, by tile_y
    std::vector<TileRow> finished_;
    Pool<TileRow> used_; ///< of level 0; all other levels together are a third of it
    std::atomic<bool> overflowed_{false};
};

} // namespace scree
