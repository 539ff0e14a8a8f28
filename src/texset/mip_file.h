#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "texset/attributes.h"
#include "texset/chunk_codec.h"

namespace scree {

enum class PixelType { half, float32 };
std::string pixel_type_name(PixelType type);
size_t pixel_bytes(PixelType type);

/// What a MIP-mapped texture file looks like.
struct MipLayout {
    int width = 0, height = 0; ///< of level 0, texels
    std::vector<std::string> channels;
    PixelType type = PixelType::float32;
    Compression compression = Compression::zip;
    Attributes attributes;
};

constexpr int kTileSize = 64;

/// All tiles of one row of tiles of one level, before and after compression.
///
/// Chunk after chunk as OpenEXR lays them out: scan lines of the tile, in each the channels sorted
/// by name, in each the pixels of the tile.
struct TileRow {
    int level = 0;
    int tile_y = 0;
    std::vector<uint8_t> bytes;  ///< all chunks, each at its uncompressed offset
    std::vector<size_t> offsets; ///< of the chunks in `bytes`, one more for the end
    std::vector<size_t> sizes;   ///< of the chunks as they are to be written
};

/// Writes a tiled (64x64), MIP-mapped OpenEXR texture, tiles of all levels in any order.
///
/// The order of write() calls is the order in the file (line order RANDOM_Y), so a baker that
/// finishes coarse tiles between fine ones keeps none of them. Levels are rounded down to 1x1.
/// Every function throws Error, naming the file, when the disk or OpenEXR refuses.
class MipFile {
public:
    MipFile(std::filesystem::path path, MipLayout layout);
    ~MipFile();
    MipFile(const MipFile&) = delete;
    MipFile& operator=(const MipFile&) = delete;

    [[nodiscard]] int levels() const;
    [[nodiscard]] int level_width(int level) const;
    [[nodiscard]] int level_height(int level) const;
    [[nodiscard]] const MipLayout& layout() const { return layout_; }

    /// Makes `row` an uncompressed row of tiles of that level, its content undefined.
    void prepare(TileRow& row, int level, int tile_y) const;

    /// Where scan line `y` (of the level) of channel `channel` (index into layout().channels)
    /// begins in tile `tile_x`; `pixels` gets the tile's width.
    uint8_t* line(TileRow& row, int tile_x, int y, int channel, int& pixels) const;

    /// Compresses one tile of a row. Thread safe for different tiles.
    void encode(TileRow& row, int tile_x) const;

    /// Appends the row's tiles to the file. One thread at a time.
    void write(const TileRow& row);

    /// Completes the file; without it, or with tiles missing, the file is not readable.
    void close();

private:
    struct Context;
    [[nodiscard]] int tile_width(int level, int tile_x) const;
    [[nodiscard]] int tile_height(int level, int tile_y) const;

    std::filesystem::path path_;
    MipLayout layout_;
    std::vector<int> sorted_place_; ///< of layout_.channels[i] among the sorted channels
    std::unique_ptr<Context> context_;
};

} // namespace scree
