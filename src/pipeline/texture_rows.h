#pragma once

#include <atomic>
#include <map>
#include <vector>

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

    /// The tile rows finished since the last call.
    std::vector<TileRow> take_finished();

    /// Takes back a row that is in the file; its memory is used again.
    void recycle(TileRow row);

    /// True once a number did not fit the file's half floats.
    [[nodiscard]] bool overflowed() const { return overflowed_; }

private:
    template <class Store>
    void store_texels(int level, int y, int x0, int count, MomentRow row);
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
