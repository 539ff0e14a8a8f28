#include "texset/mip_file.h"

#include <OpenEXR/openexr_attr.h>
#include <OpenEXR/openexr_chunkio.h>
#include <OpenEXR/openexr_context.h>
#include <OpenEXR/openexr_encode.h>
#include <OpenEXR/openexr_part.h>
#include <OpenEXR/openexr_std_attr.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "math/error.h"
#include "stats/pyramid.h"

namespace scree {

std::string pixel_type_name(PixelType type) { return type == PixelType::half ? "half" : "float"; }

size_t pixel_bytes(PixelType type) { return type == PixelType::half ? 2 : 4; }

namespace {

exr_compression_t exr_compression(Compression compression)
{
    switch (compression) {
    case Compression::none:
        return EXR_COMPRESSION_NONE;
    case Compression::rle:
        return EXR_COMPRESSION_RLE;
    case Compression::zips:
        return EXR_COMPRESSION_ZIPS;
    case Compression::zip:
        return EXR_COMPRESSION_ZIP;
    case Compression::piz:
        return EXR_COMPRESSION_PIZ;
    }
    return EXR_COMPRESSION_NONE;
}

/// OpenEXR's last message on this thread: it comes before the error code returns.
thread_local std::string last_message;

void remember_message(exr_const_context_t /*context*/, exr_result_t /*code*/, const char* message)
{
    last_message = message == nullptr ? "" : message;
}

std::string last_words(exr_result_t code)
{
    std::string words = last_message.empty() ? exr_get_default_error_message(code) : last_message;
    last_message.clear();
    return words;
}

} // namespace

struct MipFile::Context {
    exr_context_t exr = nullptr;

    ~Context()
    {
        if (exr != nullptr)
            exr_finish(&exr);
    }
};

namespace {

/// Throws when an OpenEXR call on this file fails.
class Check {
public:
    explicit Check(const std::filesystem::path& path) : path_(path) {}

    void operator()(exr_result_t code, const char* doing) const
    {
        if (code == EXR_ERR_SUCCESS)
            return;
        throw Error(fmt::format("{}: {}: {}; is there room on the disk?", path_.string(), doing,
                                last_words(code)));
    }

private:
    const std::filesystem::path& path_;
};

void set_attribute(exr_context_t exr, const std::string& name, const AttributeValue& value,
                   const Check& check)
{
    struct Setter {
        exr_context_t exr;
        const char* name;
        exr_result_t operator()(const std::string& v) const
        {
            return exr_attr_set_string(exr, 0, name, v.c_str());
        }
        exr_result_t operator()(int v) const { return exr_attr_set_int(exr, 0, name, v); }
        exr_result_t operator()(float v) const { return exr_attr_set_float(exr, 0, name, v); }
        exr_result_t operator()(double v) const { return exr_attr_set_double(exr, 0, name, v); }
    };
    check(std::visit(Setter{exr, name.c_str()}, value), "cannot set a header attribute");
}

} // namespace

MipFile::MipFile(std::filesystem::path path, MipLayout layout)
    : path_(std::move(path)), layout_(std::move(layout)), context_(std::make_unique<Context>())
{
    const Check check(path_);
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.error_handler_fn = remember_message;
    check(exr_start_write(&context_->exr, path_.c_str(), EXR_WRITE_FILE_DIRECTLY, &init),
          "cannot create the file");

    exr_context_t exr = context_->exr;
    int part = 0;
    check(exr_add_part(exr, nullptr, EXR_STORAGE_TILED, &part), "cannot add a part");
    check(exr_initialize_required_attr_simple(exr, part, layout_.width, layout_.height,
                                              exr_compression(layout_.compression)),
          "cannot set the header");
    check(exr_set_lineorder(exr, part, EXR_LINEORDER_RANDOM_Y), "cannot set the line order");
    check(exr_set_tile_descriptor(exr, part, kTileSize, kTileSize, EXR_TILE_MIPMAP_LEVELS,
                                  EXR_TILE_ROUND_DOWN),
          "cannot set the tiles");

    // Channels go into the file sorted by name.
    std::vector<int> order(layout_.channels.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](int a, int b) {
        return layout_.channels[static_cast<size_t>(a)] < layout_.channels[static_cast<size_t>(b)];
    });
    sorted_place_.resize(order.size());
    const exr_pixel_type_t type =
        layout_.type == PixelType::half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    for (size_t place = 0; place < order.size(); ++place) {
        const auto channel = static_cast<size_t>(order[place]);
        sorted_place_[channel] = static_cast<int>(place);
        check(exr_add_channel(exr, part, layout_.channels[channel].c_str(), type,
                              EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
              "cannot add a channel");
    }
    for (const auto& [name, value] : layout_.attributes)
        set_attribute(exr, name, value, check);
    check(exr_write_header(exr), "cannot write the header");
}

MipFile::~MipFile() = default;

int MipFile::levels() const { return level_count(layout_.width, layout_.height); }

int MipFile::level_width(int level) const { return std::max(1, layout_.width >> level); }

int MipFile::level_height(int level) const { return std::max(1, layout_.height >> level); }

int MipFile::tile_width(int level, int tile_x) const
{
    return std::min(kTileSize, level_width(level) - tile_x * kTileSize);
}

int MipFile::tile_height(int level, int tile_y) const
{
    return std::min(kTileSize, level_height(level) - tile_y * kTileSize);
}

void MipFile::prepare(TileRow& row, int level, int tile_y) const
{
    const int tiles = (level_width(level) + kTileSize - 1) / kTileSize;
    const size_t pixel = layout_.channels.size() * pixel_bytes(layout_.type);
    row.level = level;
    row.tile_y = tile_y;
    row.offsets.assign(1, 0);
    row.sizes.clear();
    for (int tile_x = 0; tile_x < tiles; ++tile_x) {
        const auto pixels = static_cast<size_t>(tile_width(level, tile_x)) *
                            static_cast<size_t>(tile_height(level, tile_y));
        row.sizes.push_back(pixels * pixel);
        row.offsets.push_back(row.offsets.back() + row.sizes.back());
    }
    row.bytes.resize(row.offsets.back());
}

uint8_t* MipFile::line(TileRow& row, int tile_x, int y, int channel, int& pixels) const
{
    pixels = tile_width(row.level, tile_x);
    const auto line_in_tile = static_cast<size_t>(y - row.tile_y * kTileSize);
    const size_t place = line_in_tile * layout_.channels.size() +
                         static_cast<size_t>(sorted_place_[static_cast<size_t>(channel)]);
    return row.bytes.data() + row.offsets[static_cast<size_t>(tile_x)] +
           place * static_cast<size_t>(pixels) * pixel_bytes(layout_.type);
}

namespace {

/// Runs OpenEXR's own encoder on one chunk, in place; returns its new size.
size_t encode_with_openexr(exr_context_t exr, PixelType type, const TileRow& row, int tile_x,
                           uint8_t* bytes, size_t size, const Check& check)
{
    struct Encoder {
        explicit Encoder(exr_context_t context) : exr(context) {}
        ~Encoder() { exr_encoding_destroy(exr, &pipe); }
        Encoder(const Encoder&) = delete;
        Encoder& operator=(const Encoder&) = delete;
        exr_context_t exr;
        exr_encode_pipeline_t pipe = EXR_ENCODE_PIPELINE_INITIALIZER;
    } encoder(exr);
    exr_encode_pipeline_t& pipe = encoder.pipe;

    exr_chunk_info_t chunk;
    check(exr_write_tile_chunk_info(exr, 0, tile_x, row.tile_y, row.level, row.level, &chunk),
          "cannot address a tile");
    check(exr_encoding_initialize(exr, 0, &chunk, &pipe), "cannot start the encoder");
    const auto element = static_cast<int16_t>(pixel_bytes(type));
    const int line_bytes = element * chunk.width;
    for (int c = 0; c < pipe.channel_count; ++c) {
        exr_coding_channel_info_t& channel = pipe.channels[c];
        channel.encode_from_ptr = bytes + static_cast<ptrdiff_t>(c) * line_bytes;
        channel.user_pixel_stride = element;
        channel.user_line_stride = line_bytes * pipe.channel_count;
        channel.user_bytes_per_element = element;
        channel.user_data_type = channel.data_type;
    }
    check(exr_encoding_choose_default_routines(exr, 0, &pipe), "cannot choose an encoder");
    pipe.yield_until_ready_fn = nullptr; // writing is write()'s work
    pipe.write_fn = nullptr;
    check(exr_encoding_run(exr, 0, &pipe), "cannot compress a tile");
    if (pipe.compressed_bytes >= size)
        return size;
    std::memcpy(bytes, pipe.compressed_buffer, pipe.compressed_bytes);
    return pipe.compressed_bytes;
}

} // namespace

void MipFile::encode(TileRow& row, int tile_x) const
{
    const auto index = static_cast<size_t>(tile_x);
    uint8_t* bytes = row.bytes.data() + row.offsets[index];
    size_t& size = row.sizes[index];
    switch (layout_.compression) {
    case Compression::none:
        return;
    case Compression::zip:
    case Compression::zips: { // a tile is one chunk in both
        thread_local ZipCodec codec;
        size = codec.compress(bytes, size);
        return;
    }
    case Compression::rle:
    case Compression::piz:
        size = encode_with_openexr(context_->exr, layout_.type, row, tile_x, bytes, size,
                                   Check(path_));
        return;
    }
}

void MipFile::write(const TileRow& row)
{
    const Check check(path_);
    for (size_t i = 0; i < row.sizes.size(); ++i)
        check(exr_write_tile_chunk(context_->exr, 0, static_cast<int>(i), row.tile_y, row.level,
                                   row.level, row.bytes.data() + row.offsets[i], row.sizes[i]),
              "cannot write a tile");
}

void MipFile::close()
{
    const Check check(path_);
    check(exr_finish(&context_->exr), "cannot complete the file");
}

} // namespace scree
