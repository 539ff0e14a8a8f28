#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scree {

/// Lossless OpenEXR compressions; the lossy ones would bend the moments.
enum class Compression { none, rle, zips, zip, piz };

/// Throws Error naming the choices; a lossy OpenEXR compression is refused with the reason.
Compression compression_named(const std::string& name);
std::string compression_name(Compression compression);

/// Compresses one chunk of pixels to the bytes OpenEXR's ZIP stores: bytes de-interleaved, each
/// replaced by its difference to the one before, then a zlib stream.
///
/// libdeflate makes that stream: the same format as zlib's, in about half the time (docs/speed.md).
/// Not thread safe; one codec a thread.
class ZipCodec {
public:
    ZipCodec();
    ~ZipCodec();
    ZipCodec(ZipCodec&&) noexcept;
    ZipCodec& operator=(ZipCodec&&) noexcept;

    /// Compresses in place; returns the new size, or `size` with the bytes untouched where they
    /// would not get smaller (OpenEXR stores such a chunk as it is).
    size_t compress(uint8_t* bytes, size_t size);

private:
    struct Deflater;
    std::unique_ptr<Deflater> deflater_;
    std::vector<uint8_t> reordered_;
    std::vector<uint8_t> packed_;
};

} // namespace scree
