#include "pipeline/texture_rows.h"

#include <algorithm>
#include <utility>

namespace scree {

TextureRows::TextureRows(Map map, const MomentLayout& layout, const ValueScale& scale,
                         const MipFile& file)
    : map_(map), layout_(layout), scale_(scale), file_(file),
      open_(static_cast<size_t>(file.levels()))
{}

void TextureRows::rows_begin(int level, int begin, int end)
{
    auto& open = open_[static_cast<size_t>(level)];
    for (int tile_y = begin / kTileSize; tile_y <= (end - 1) / kTileSize; ++tile_y) {
        if (open.count(tile_y) != 0)
            continue;
        TileRow row = level == 0 ? used_.take() : TileRow();
        file_.prepare(row, level, tile_y);
        open.emplace(tile_y, std::move(row));
    }
}

TileRow& TextureRows::open_row(int level, int y)
{
    return open_[static_cast<size_t>(level)].find(y / kTileSize)->second;
}

void TextureRows::texels(int level, int y, int x0, int count, MomentRow row)
{
    if (file_.layout().type == PixelType::half)
        store_texels<StoreHalf>(level, y, x0, count, row);
    else
        store_texels<StoreFloat>(level, y, x0, count, row);
}

template <class Store>
void TextureRows::store_texels(int level, int y, int x0, int count, MomentRow row)
{
    using Bits = typename Store::Bits;
    static_assert(kBlockColumns % kTileSize == 0, "a block is whole tiles");
    const int channels = static_cast<int>(file_.layout().channels.size());
    TileRow& tiles = open_row(level, y);
    Bits values[kMostChannels][kTileSize];
    Bits* stored[kMostChannels];
    for (int c = 0; c < channels; ++c)
        stored[c] = values[c];
    for (int x = x0; x < x0 + count; x += kTileSize) {
        const int pixels = std::min(kTileSize, x0 + count - x);
        texture_values<Store>(map_, layout_, level, row.from(x - x0), pixels, scale_, stored);
        for (int c = 0; c < channels; ++c) {
            int tile_pixels = 0;
            uint8_t* line = file_.line(tiles, x / kTileSize, y, c, tile_pixels);
            std::memcpy(line, values[c], static_cast<size_t>(pixels) * sizeof(Bits));
        }
        if constexpr (sizeof(Bits) == 2) {
            constexpr Bits kExponent = 0x7c00; // all ones: infinite
            int infinite = 0;
            for (int c = 0; c < channels; ++c)
                for (int i = 0; i < pixels; ++i)
                    infinite += (values[c][i] & kExponent) == kExponent;
            if (infinite > 0)
                overflowed_ = true;
        }
    }
}

void TextureRows::rows_end(int level, int end)
{
    auto& open = open_[static_cast<size_t>(level)];
    while (!open.empty()) {
        const int tile_y = open.begin()->first;
        if (std::min((tile_y + 1) * kTileSize, file_.level_height(level)) > end)
            break;
        finished_.push_back(std::move(open.begin()->second));
        open.erase(open.begin());
    }
}

void TextureRows::recycle(TileRow row)
{
    if (row.level == 0)
        used_.give(std::move(row));
}

std::vector<TileRow> TextureRows::take_finished() { return std::exchange(finished_, {}); }

} // namespace scree
