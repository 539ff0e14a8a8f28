#include "pipeline/texture_rows.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "pipeline/texture_blend.h"

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

namespace {

/// Whether a map has anything to blend. Coverage tells where there is data; the exponent is the
/// same all over a level.
bool has_gutter(Map map) { return map != Map::coverage && map != Map::exponent; }

/// A line of a level as stored, and those above and below, across the map's edges too.
template <class Store>
class StoredLines {
public:
    /// open  tile rows of the level that are being filled
    StoredLines(const MipFile& file, std::map<int, TileRow>& open, int level, int y)
        : file_(file), width_(file.level_width(level))
    {
        const int height = file.level_height(level);
        for (int k = 0; k < 3; ++k) {
            lines_[k] = (y + k - 1 + height) % height;
            const auto found = open.find(lines_[k] / kTileSize);
            tiles_[k] = found == open.end() ? nullptr : &found->second;
        }
    }

    [[nodiscard]] double mean_of_sources(const GutterTexel& texel, int channel) const
    {
        double sum = 0;
        int sources = 0;
        for (size_t i = 0; i < kNeighbours.size(); ++i) {
            if ((texel.sources >> i & 1U) == 0)
                continue;
            const auto [dx, dy] = kNeighbours[i];
            Bits bits = 0;
            std::memcpy(&bits, place((texel.x + dx + width_) % width_, 1 + dy, channel),
                        sizeof bits);
            sum += Store::value(bits);
            ++sources;
        }
        return sum / sources;
    }

    /// Stores a number in the middle line.
    void put(int x, int channel, typename Store::Bits bits) const
    {
        std::memcpy(place(x, 1, channel), &bits, sizeof bits);
    }

private:
    using Bits = typename Store::Bits;

    [[nodiscard]] uint8_t* place(int x, int k, int channel) const
    {
        int pixels = 0;
        uint8_t* line = file_.line(*tiles_[k], x / kTileSize, lines_[k], channel, pixels);
        return line + static_cast<size_t>(x % kTileSize) * sizeof(Bits);
    }

    const MipFile& file_;
    int width_;
    int lines_[3];
    TileRow* tiles_[3]; ///< null where a line is not open: no source lies there
};

} // namespace

void TextureRows::blend(int level, int y, const std::vector<GutterTexel>& texels)
{
    if (!has_gutter(map_))
        return;
    const int total = static_cast<int>(texels.size());
    for (int done = 0; done < total; done += kTileSize) {
        const int count = std::min(kTileSize, total - done);
        if (file_.layout().type == PixelType::half)
            blend_texels<StoreHalf>(level, y, texels.data() + done, count);
        else
            blend_texels<StoreFloat>(level, y, texels.data() + done, count);
    }
}

template <class Store>
void TextureRows::blend_texels(int level, int y, const GutterTexel* texels, int count)
{
    using Bits = typename Store::Bits;
    const int channels = static_cast<int>(file_.layout().channels.size());
    const StoredLines<Store> lines(file_, open_[static_cast<size_t>(level)], level, y);
    double means[kMostChannels][kTileSize];
    Bits values[kMostChannels][kTileSize];
    const double* mean_of[kMostChannels];
    Bits* stored[kMostChannels];
    for (int c = 0; c < channels; ++c) {
        mean_of[c] = means[c];
        stored[c] = values[c];
        for (int i = 0; i < count; ++i)
            means[c][i] = lines.mean_of_sources(texels[i], c);
    }
    store_blend<Store>(map_, channels, mean_of, count, stored);
    for (int c = 0; c < channels; ++c)
        for (int i = 0; i < count; ++i)
            lines.put(texels[i].x, c, values[c][i]);
}

void TextureRows::rows_end(int level, int end) { finish(level, 0, end); }

void TextureRows::finish(int level, int begin, int end)
{
    auto& open = open_[static_cast<size_t>(level)];
    auto row = open.lower_bound(begin / kTileSize);
    while (row != open.end() &&
           std::min((row->first + 1) * kTileSize, file_.level_height(level)) <= end) {
        finished_.push_back(std::move(row->second));
        row = open.erase(row);
    }
}

void TextureRows::recycle(TileRow row)
{
    if (row.level == 0)
        used_.give(std::move(row));
}

std::vector<TileRow> TextureRows::take_finished() { return std::exchange(finished_, {}); }

} // namespace scree
