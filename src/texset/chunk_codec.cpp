#include "texset/chunk_codec.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "math/error.h"

namespace scree {

namespace {

constexpr std::array<std::pair<const char*, Compression>, 5> kNames = {{
    {"none", Compression::none},
    {"rle", Compression::rle},
    {"zips", Compression::zips},
    {"zip", Compression::zip},
    {"piz", Compression::piz},
}};

/// A little faster than OpenEXR's default (zlib, level 4) would be by size; see docs/speed.md.
constexpr int kDeflateLevel = 4;

} // namespace

Compression compression_named(const std::string& name)
{
    for (const auto& [known, compression] : kNames)
        if (name == known)
            return compression;
    for (const char* lossy : {"pxr24", "b44", "b44a", "dwaa", "dwab"})
        if (name == lossy)
            throw Error("--compression " + name +
                        " is lossy and would bend the moments; use none, rle, zips, zip or piz");
    throw Error("--compression '" + name + "' is unknown; use none, rle, zips, zip or piz");
}

std::string compression_name(Compression compression)
{
    for (const auto& [name, known] : kNames)
        if (known == compression)
            return name;
    return {};
}

struct ZipCodec::Deflater {
    Deflater() : handle(libdeflate_alloc_compressor(kDeflateLevel))
    {
        if (handle == nullptr)
            throw std::bad_alloc();
    }
    ~Deflater() { libdeflate_free_compressor(handle); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    libdeflate_compressor* handle;
};

ZipCodec::ZipCodec() : deflater_(std::make_unique<Deflater>()) {}
ZipCodec::~ZipCodec() = default;
ZipCodec::ZipCodec(ZipCodec&&) noexcept = default;
ZipCodec& ZipCodec::operator=(ZipCodec&&) noexcept = default;

size_t ZipCodec::compress(uint8_t* bytes, size_t size)
{
    if (size < 2)
        return size;
    reordered_.resize(size);
    packed_.resize(size);

    // Even bytes to the first half, odd bytes to the second: like with like.
    const size_t half = (size + 1) / 2;
    uint8_t* even = reordered_.data();
    uint8_t* odd = even + half;
    for (size_t i = 0; i < size / 2; ++i) {
        even[i] = bytes[2 * i];
        odd[i] = bytes[2 * i + 1];
    }
    if (size % 2 == 1)
        even[half - 1] = bytes[size - 1];

    packed_[0] = reordered_[0];
    for (size_t i = 1; i < size; ++i)
        packed_[i] = static_cast<uint8_t>(reordered_[i] - reordered_[i - 1] + 128);

    // The output may not be larger than the input: libdeflate then gives up and returns 0.
    const size_t packed_size = libdeflate_zlib_compress(deflater_->handle, packed_.data(), size,
                                                        reordered_.data(), size - 1);
    if (packed_size == 0)
        return size;
    std::copy_n(reordered_.data(), packed_size, bytes);
    return packed_size;
}

} // namespace scree
