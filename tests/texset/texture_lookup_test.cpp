// A set looked up through OpenImageIO: which file, which channels, which wrap. How it filters is
// in texture_system_test.cpp.

#include "texset/texture_lookup.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>

#include "math/error.h"
#include "pipeline/bake.h"
#include "support/files.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

constexpr int kSize = 64;

/// A set of random heights and colors, not repeating.
Manifest bake_random(const TempFolder& temp)
{
    write_image(temp / "h.exr", random_image(kSize, kSize, {"Y"}, 31));
    write_image(temp / "c.exr", random_image(kSize, kSize, {"R", "G", "B"}, 32));
    BakeOptions options;
    options.height_file = temp / "h.exr";
    options.color_file = temp / "c.exr";
    options.output = temp / "set";
    options.name = "test";
    options.texel_size = {{1, 1}};
    options.wrap_s = options.wrap_t = Wrap::clamp;
    options.pixel_type = PixelTypeChoice::float32;
    return bake(options);
}

/// The centre of a texel of a level, with that level's footprint.
TexturePlace texel(int level, int x, int y)
{
    const float step = static_cast<float>(1 << level) / kSize;
    return {(static_cast<float>(x) + 0.5F) * step,
            (static_cast<float>(y) + 0.5F) * step,
            step,
            0,
            0,
            step};
}

TEST(TextureLookup, ReadsEveryMapOfTheSet)
{
    const TempFolder temp;
    const Manifest manifest = bake_random(temp);
    const TextureLookup lookup(temp / "set", manifest);
    ASSERT_FALSE(manifest.textures.empty());
    for (const TextureRecord& record : manifest.textures) {
        ASSERT_TRUE(lookup.has(record.map)) << record.file;
        const auto levels = read_levels(temp / "set" / record.file);
        const int count = lookup.channels(record.map);
        ASSERT_EQ(count, static_cast<int>(levels[2].channels.size()));
        std::vector<float> got(static_cast<size_t>(count));
        lookup.read(record.map, texel(2, 5, 9), 0, count, got.data());
        for (int c = 0; c < count; ++c) // a texel centre is hit to a few units of rounding
            EXPECT_NEAR(got[static_cast<size_t>(c)], levels[2].at(5, 9, c), 1e-5F)
                << record.file << " channel " << c;
    }
    EXPECT_FALSE(lookup.has(Map::coverage));
    EXPECT_FALSE(lookup.has(Map::map));
}

TEST(TextureLookup, ReadsPartOfTheChannels)
{
    const TempFolder temp;
    const TextureLookup lookup(temp / "set", bake_random(temp));
    std::array<float, 5> all{};
    lookup.read(Map::slope, texel(1, 7, 3), 0, 5, all.data());
    std::array<float, 3> part{-1, -1, -1};
    lookup.read(Map::slope, texel(1, 7, 3), 3, 2, part.data());
    EXPECT_EQ(part[0], all[3]);
    EXPECT_EQ(part[1], all[4]);
    EXPECT_EQ(part[2], -1) << "written beyond the channels that were asked for";
}

TEST(TextureLookup, TheWrapIsTheFilesOrTiled)
{
    const TempFolder temp;
    const Manifest manifest = bake_random(temp);
    TextureFilter tiled;
    tiled.is_tiled = true;
    const TextureLookup as_baked(temp / "set", manifest), repeated(temp / "set", manifest, tiled);
    TexturePlace inside = texel(0, 10, 20), outside = inside, edge = texel(0, kSize - 1, 20);
    outside.s += 1;
    auto red = [](const TextureLookup& lookup, const TexturePlace& place) {
        float value = -1;
        lookup.read(Map::color, place, 0, 1, &value);
        return value;
    };
    EXPECT_NEAR(red(repeated, outside), red(repeated, inside), 1e-5F);
    EXPECT_NEAR(red(as_baked, outside), red(as_baked, edge), 1e-5F);
    EXPECT_GT(std::abs(red(as_baked, inside) - red(as_baked, edge)), 1e-3F) << "a weak example";
}

TEST(TextureLookup, ThreadsReadWhatOneReads)
{
    const TempFolder temp;
    const TextureLookup lookup(temp / "set", bake_random(temp));
    auto read = [&lookup](size_t i) {
        std::array<float, 12> values{};
        const int x = static_cast<int>(i % kSize), y = static_cast<int>(i / kSize);
        lookup.read(Map::rank, texel(0, x, y), 0, 12, values.data());
        return values;
    };
    std::vector<std::array<float, 12>> together(size_t{kSize} * kSize);
    tbb::parallel_for(size_t{0}, together.size(), [&](size_t i) { together[i] = read(i); });
    for (size_t i = 0; i < together.size(); i += 7)
        ASSERT_EQ(together[i], read(i)) << "texel " << i;
}

// The threads of a pool go on from one set to the next, and with them what OpenImageIO keeps for
// each thread of a cache, found by its address.
TEST(TextureLookup, SetsLookedUpOneAfterAnotherShareNothing)
{
    const TempFolder temp;
    const Manifest manifest = bake_random(temp);
    std::vector<float> first;
    for (int round = 0; round < 12; ++round) {
        const TextureLookup lookup(temp / "set", manifest);
        std::vector<float> values(size_t{kSize} * kSize);
        tbb::parallel_for(size_t{0}, values.size(), [&](size_t i) {
            const int x = static_cast<int>(i % kSize), y = static_cast<int>(i / kSize);
            lookup.read(Map::color, texel(0, x, y), 0, 1, &values[i]);
        });
        if (round == 0)
            first = values;
        ASSERT_EQ(values, first) << "round " << round;
    }
}

std::string refusal(const TempFolder& temp, const Manifest& manifest)
{
    try {
        const TextureLookup lookup(temp / "set", manifest);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

TEST(TextureLookup, NamesTheFileThatIsMissingOrAnothers)
{
    const TempFolder temp;
    const Manifest manifest = bake_random(temp);
    const std::string file = (temp / "set" / "test.height.exr").string();
    std::filesystem::copy_file(temp / "set" / "test.color.exr", file,
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(refusal(temp, manifest).find(file + ": has 3 channels"), 0U);
    std::filesystem::remove(file);
    EXPECT_EQ(refusal(temp, manifest).find(file + ": cannot be read"), 0U);
}

} // namespace
} // namespace scree::test
