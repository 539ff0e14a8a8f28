// Compressed chunks, undone with zlib and OpenEXR's documented predictor.

#include "texset/chunk_codec.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "math/error.h"

namespace scree::test {
namespace {

using Bytes = std::vector<uint8_t>;

// Oracle: "OpenEXR File Layout": inflate, add up the differences, put the two halves together.
Bytes undone(const Bytes& packed, size_t size)
{
    Bytes bytes(size);
    auto length = static_cast<uLongf>(size);
    EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), static_cast<uLong>(packed.size())),
              Z_OK);
    EXPECT_EQ(length, size);
    for (size_t i = 1; i < size; ++i)
        bytes[i] = static_cast<uint8_t>(bytes[i - 1] + bytes[i] - 128);
    Bytes out(size);
    for (size_t i = 0; i < size; ++i)
        out[i] = i % 2 == 0 ? bytes[i / 2] : bytes[(size + 1) / 2 + i / 2];
    return out;
}

/// The chunk after the codec: what goes into the file.
Bytes compressed(ZipCodec& codec, Bytes bytes)
{
    const size_t size = codec.compress(bytes.data(), bytes.size());
    EXPECT_LE(size, bytes.size());
    bytes.resize(size);
    return bytes;
}

/// Bytes of a row of floats that climbs in steps, cut to any size.
Bytes smooth(size_t size)
{
    std::vector<float> row(size / 4 + 1);
    for (size_t i = 0; i < row.size(); ++i)
        row[i] = static_cast<float>(i / 16) * 0.125F;
    Bytes bytes(row.size() * 4);
    std::copy_n(reinterpret_cast<const uint8_t*>(row.data()), bytes.size(), bytes.begin());
    bytes.resize(size);
    return bytes;
}

Bytes noise(size_t size)
{
    std::mt19937 random(7);
    Bytes bytes(size);
    for (uint8_t& byte : bytes)
        byte = static_cast<uint8_t>(random() >> 24);
    return bytes;
}

TEST(ChunkCodec, ZlibAndThePredictorUndoIt)
{
    ZipCodec codec; // one for all sizes: nothing may be left over from a chunk to the next
    for (const size_t size : {512U, 513U, 4096U, 4097U, 64U * 64U * 5U * 4U, 3U * 4097U, 512U})
        for (const Bytes& bytes : {smooth(size), Bytes(size, 0), Bytes(size, 200)}) {
            const Bytes packed = compressed(codec, bytes);
            ASSERT_LT(packed.size(), size) << "not compressed, size " << size;
            EXPECT_EQ(undone(packed, size), bytes) << "size " << size;
        }
}

TEST(ChunkCodec, BytesThatDoNotGetSmallerAreLeftAsTheyAre)
{
    ZipCodec codec;
    for (const size_t size : {0U, 1U, 2U, 3U, 4U, 5U, 17U, 1000U, 1001U, 65536U, 65537U}) {
        const Bytes bytes = noise(size);
        EXPECT_EQ(compressed(codec, bytes), bytes) << "size " << size;
    }
}

TEST(ChunkCodec, TinyChunksSurvive)
{
    ZipCodec codec;
    for (const size_t size : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 11U, 13U, 15U, 16U, 31U}) {
        const Bytes bytes(size, 42);
        const Bytes packed = compressed(codec, bytes);
        EXPECT_EQ(packed.size() == size ? packed : undone(packed, size), bytes) << "size " << size;
    }
}

TEST(ChunkCodec, AnotherCodecMakesTheSameBytes)
{
    ZipCodec used, fresh;
    compressed(used, noise(5000));
    compressed(used, smooth(70000));
    EXPECT_EQ(compressed(used, smooth(20480)), compressed(fresh, smooth(20480)));
    ZipCodec moved = std::move(used);
    EXPECT_EQ(compressed(moved, smooth(20480)), compressed(fresh, smooth(20480)));
}

TEST(ChunkCodec, NamesGoToCompressionsAndBack)
{
    for (const char* name : {"none", "rle", "zips", "zip", "piz"})
        EXPECT_EQ(compression_name(compression_named(name)), name);
}

TEST(ChunkCodec, LossyAndUnknownCompressionsAreRefused)
{
    auto message = [](const char* name) -> std::string {
        try {
            compression_named(name);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    for (const char* lossy : {"pxr24", "b44", "b44a", "dwaa", "dwab"}) {
        EXPECT_NE(message(lossy).find("lossy"), std::string::npos) << lossy;
        EXPECT_NE(message(lossy).find(lossy), std::string::npos) << lossy;
    }
    EXPECT_NE(message("lzma").find("none, rle, zips, zip or piz"), std::string::npos);
    EXPECT_NE(message("").find("unknown"), std::string::npos);
}

} // namespace
} // namespace scree::test
