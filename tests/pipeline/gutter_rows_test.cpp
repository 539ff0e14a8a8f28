// The gutter of baked sets: what its texels hold, and when tile rows are handed out.
#include "pipeline/gutter_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include "support/baked_levels.h"
#include "support/oracle_case.h"

namespace scree::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Rings of one level, from its coverage, by exhaustive search in the window of two texels.
std::vector<int> rings_of(const Image& coverage, bool periodic_s, bool periodic_t)
{
    std::vector<int> rings;
    for (int y = 0; y < coverage.height; ++y)
        for (int x = 0; x < coverage.width; ++x) {
            int ring = kBeyondGutter;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    int column = x + dx, row = y + dy;
                    if (periodic_s)
                        column = (column + 2 * coverage.width) % coverage.width;
                    if (periodic_t)
                        row = (row + 2 * coverage.height) % coverage.height;
                    if (column >= 0 && column < coverage.width && row >= 0 &&
                        row < coverage.height && coverage.at(column, row, 0) > 0)
                        ring = std::min(ring, std::max(std::abs(dx), std::abs(dy)));
                }
            rings.push_back(ring);
        }
    return rings;
}

/// One level of one map beside its coverage.
struct LevelUnderTest {
    const Image& image;
    std::vector<int> rings;
    bool periodic_s, periodic_t;

    [[nodiscard]] int ring(int x, int y) const
    {
        return rings[static_cast<size_t>(y) * static_cast<size_t>(image.width) +
                     static_cast<size_t>(x)];
    }

    /// Mean of what is stored in the neighbours one ring nearer to data.
    [[nodiscard]] double mean_of_sources(int x, int y, int channel) const
    {
        double sum = 0, count = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                int column = x + dx, row = y + dy;
                if (periodic_s)
                    column = (column + image.width) % image.width;
                if (periodic_t)
                    row = (row + image.height) % image.height;
                if (column < 0 || column >= image.width || row < 0 || row >= image.height)
                    continue;
                if (ring(column, row) != ring(x, y) - 1)
                    continue;
                sum += static_cast<double>(image.at(column, row, channel));
                ++count;
            }
        return sum / count;
    }
};

struct Counts {
    int first = 0, second = 0, beyond = 0;
};

/// Every texel of the gutter against the mean of its sources as stored.
///
/// rounding  of a stored number, relative. A second moment is taken about the rounded mean, which
///           moves it by two such steps, and stepped up by at most three more.
void expect_gutter(const std::string& title, const LevelUnderTest& level, double rounding,
                   Counts& counts)
{
    double largest = 0;
    for (const float v : level.image.pixels)
        largest = std::max(largest, std::abs(static_cast<double>(v)));
    for (int y = 0; y < level.image.height; ++y)
        for (int x = 0; x < level.image.width; ++x) {
            const int ring = level.ring(x, y);
            counts.first += ring == 1 ? 1 : 0;
            counts.second += ring == 2 ? 1 : 0;
            counts.beyond += ring > 2 ? 1 : 0;
            for (int c = 0;
                 ring >= 1 && ring <= 2 && c < static_cast<int>(level.image.channels.size()); ++c)
                ASSERT_NEAR(static_cast<double>(level.image.at(x, y, c)),
                            level.mean_of_sources(x, y, c), 6 * rounding * largest)
                    << title << " level of " << level.image.width << "x" << level.image.height
                    << " channel " << c << " ring " << ring << " at " << x << "," << y;
        }
}

bool is_periodic(Wrap wrap) { return wrap == Wrap::periodic; }

/// All textures of a set but the coverage, which may come from another set of the same surface.
void expect_gutters(const BakedLevels& baked, const std::vector<Image>& coverage,
                    const OracleCase& c, Counts& counts)
{
    const bool s = is_periodic(c.options.wrap_s), t = is_periodic(c.options.wrap_t);
    for (const TextureRecord& texture : baked.manifest.textures) {
        const std::string name = map_info(texture.map).name;
        if (texture.map == Map::coverage)
            continue;
        const double rounding = texture.type == PixelType::half ? 0x1p-11 : 0x1p-24;
        const auto& levels = baked.levels.at(name);
        for (size_t l = 0; l < levels.size(); ++l)
            expect_gutter(c.title + " " + name, {levels[l], rings_of(coverage[l], s, t), s, t},
                          rounding, counts);
    }
}

/// Blobs of holes, and strips of them, so that all rings and what lies beyond come at many levels.
OracleCase blobs_case(int width, int height, unsigned seed)
{
    OracleCase c = random_case(width, height, seed);
    c.title = "blobs " + c.title;
    std::mt19937 random(seed);
    auto& heights = c.input.relief.heights;
    for (int blob = 0; blob < 3 + width * height / 400; ++blob) {
        const int cx = static_cast<int>(random() % static_cast<unsigned>(width));
        const int cy = static_cast<int>(random() % static_cast<unsigned>(height));
        const int r = 1 + static_cast<int>(random() % 9);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if ((x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r)
                    heights[static_cast<size_t>(y) * static_cast<size_t>(width) +
                            static_cast<size_t>(x)] = kNaN;
    }
    heights[heights.size() / 3] = 0.5; // some texel has data
    return c;
}

TEST(GutterRows, EveryTextureHoldsTheMeanOfTheNeighboursAtEveryLevel)
{
    const std::pair<int, int> sizes[] = {{1, 5},   {3, 3},    {2, 65},    {63, 64},
                                         {66, 67}, {17, 130}, {129, 200}, {300, 40}};
    Counts counts;
    unsigned seed = 1;
    for (const auto& [width, height] : sizes)
        for (const auto& [s, t] : {std::pair(Wrap::periodic, Wrap::periodic),
                                   {Wrap::periodic, Wrap::clamp},
                                   {Wrap::mirror, Wrap::periodic},
                                   {Wrap::black, Wrap::clamp}})
            for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half}) {
                OracleCase c = blobs_case(width, height, seed++);
                set_wrap(c, s, t);
                c.options.pixel_type = type;
                const BakedLevels baked(c.source(), c.options);
                EXPECT_EQ(baked.manifest.textures.size(), 8U) << c.title;
                expect_gutters(baked, baked.levels.at("coverage"), c, counts);
                if (HasFatalFailure())
                    return;
            }
    EXPECT_GT(counts.first, 10'000);
    EXPECT_GT(counts.second, 5'000);
    EXPECT_GT(counts.beyond, 5'000);
}

TEST(GutterRows, BumpslopesAndNormalMapsHaveAGutterToo)
{
    Counts counts;
    for (const bool normal_map : {false, true})
        for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half}) {
            OracleCase c = blobs_case(70, 90, 5);
            c.options.pixel_type = type;
            if (normal_map) {
                for (const double h : c.input.relief.heights)
                    c.input.slopes.push_back({h, 0.3 - h * h});
                c.input.relief.heights.clear();
            }
            const BakedLevels with_coverage(c.source(), c.options);
            c.options.layout = normal_map ? Layout::scree : Layout::bumpslopes;
            const BakedLevels baked(c.source(), c.options);
            EXPECT_EQ(baked.levels.count("bumpslopes"), normal_map ? 0U : 1U);
            expect_gutters(baked, with_coverage.levels.at("coverage"), c, counts);
        }
    EXPECT_GT(counts.second, 500);
}

TEST(GutterRows, BeyondTheGutterTexelsHoldTheMapsMean)
{
    OracleCase c = blobs_case(129, 64, 4);
    set_wrap(c, Wrap::clamp, Wrap::clamp);
    c.options.pixel_type = PixelTypeChoice::float32;
    for (int y = 20; y < 40; ++y)
        std::fill_n(c.input.relief.heights.begin() + std::ptrdiff_t{129} * y, 129, kNaN);
    const BakedLevels baked(c.source(), c.options);
    const Image &color = baked.levels.at("color")[0], &slope = baked.levels.at("slope")[0];
    const Image& top = baked.levels.at("color").back();
    for (int x = 0; x < 129; ++x)
        for (int y = 22; y < 38; ++y) {
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(color.at(x, y, k), top.at(0, 0, k), 1e-6F);
            for (int k = 0; k < 5; ++k)
                ASSERT_EQ(slope.at(x, y, k), 0);
            ASSERT_EQ(baked.levels.at("height")[0].at(x, y, 1), 0);
        }
    for (const Image& coverage : baked.levels.at("coverage"))
        for (const float weight : coverage.pixels)
            ASSERT_GE(weight, 0);
    EXPECT_EQ(baked.levels.at("coverage")[0].at(5, 20, 0), 0) << "of the first ring, yet no data";
}

/// Slopes on a line far from 0 with little spread: the covariance has determinant 0 and is all but
/// lost in the moments, so a blend that does not round with care turns it negative.
OracleCase thin_case(double amplitude, double mean)
{
    OracleCase c = blobs_case(96, 96, 8);
    std::mt19937 random(4);
    std::normal_distribution<double> noise;
    for (const double h : c.input.relief.heights) {
        const double n = amplitude * noise(random);
        c.input.slopes.push_back({std::isnan(h) ? kNaN : mean + 3 * n, 0.3 * mean + n});
    }
    c.input.relief.heights.clear();
    return c;
}

TEST(GutterRows, NoVarianceAndNoDeterminantIsNegative)
{
    for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half})
        for (const auto& [amplitude, mean] : {std::pair(0.3, 0.0), std::pair(0.01, 2.0),
                                              std::pair(1e-4, 0.7), std::pair(0.01, -100.0)}) {
            OracleCase c = thin_case(amplitude, mean);
            c.options.pixel_type = type;
            const BakedLevels baked(c.source(), c.options);
            for (const Image& level : baked.levels.at("slope"))
                for (int y = 0; y < level.height; ++y)
                    for (int x = 0; x < level.width; ++x) {
                        const double s = level.at(x, y, 0), t = level.at(x, y, 3);
                        const double ss = static_cast<double>(level.at(x, y, 1)) - s * s;
                        const double tt = static_cast<double>(level.at(x, y, 4)) - t * t;
                        const double st = static_cast<double>(level.at(x, y, 2)) - s * t;
                        ASSERT_GE(ss, 0) << mean << " level " << level.width;
                        ASSERT_GE(tt, 0) << mean << " level " << level.width;
                        ASSERT_GE(ss * tt - st * st, 0)
                            << "mean " << mean << " amplitude " << amplitude << " level of "
                            << level.width << " texel " << x << "," << y;
                    }
        }
}

TEST(GutterRows, NoVarianceOfHeightsIsNegative)
{
    // Two plateaus whose roughness is below the rounding of a float.
    OracleCase c = blobs_case(96, 96, 9);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
    size_t i = 0;
    for (double& h : c.input.relief.heights)
        h = std::isnan(h) ? h : (i++ % 96 < 48 ? 0 : 1) + noise(random);
    for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half}) {
        c.options.pixel_type = type;
        const BakedLevels baked(c.source(), c.options);
        for (const Image& level : baked.levels.at("height"))
            for (int y = 0; y < level.height; ++y)
                for (int x = 0; x < level.width; ++x) {
                    const double h = level.at(x, y, 0), hh = level.at(x, y, 1);
                    ASSERT_GE(hh, h * h) << level.width << " at " << x << "," << y;
                }
    }
}

/// A surface that is known also where it does not count.
class WeighedSource : public MemorySource {
public:
    void read(int count, SurfaceRows& rows) override
    {
        std::vector<float> none;
        std::swap(none, weights);
        MemorySource::read(count, rows);
        std::swap(none, weights);
        const auto texels = static_cast<std::ptrdiff_t>(count) * map_width;
        rows.weight.assign(weights.begin() + done_, weights.begin() + done_ + texels);
        done_ += texels;
    }
    void rewind(bool last_time) override
    {
        MemorySource::rewind(last_time);
        done_ = 0;
    }

private:
    std::ptrdiff_t done_ = 0;
};

TEST(GutterRows, WeightsOf0MakeAGutterThoughHeightsAreKnown)
{
    WeighedSource source;
    source.map_width = 20;
    source.map_height = 10;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
            source.heights.push_back(x < 10 ? 0.75 * x - 0.5 * y : 100 + x * x);
            source.weights.push_back(x < 10 ? 1 : 0);
        }
    const TempFolder temp;
    BakeOptions options;
    options.output = temp / "set";
    options.texel_size = {1, 1};
    options.wrap_s = options.wrap_t = Wrap::clamp;
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    manifest = bake(source, options, manifest);
    EXPECT_EQ(manifest.no_data_texels, 0);
    const auto slope = read_levels(temp / "set" / "test.slope.exr");
    const auto height = read_levels(temp / "set" / "test.height.exr");
    for (int y = 2; y < 8; ++y) { // means of rows of a plane, up to its ends
        EXPECT_NEAR(slope[0].at(11, y, 3), slope[0].at(9, y, 3), 1e-6F);
        EXPECT_NEAR(height[0].at(11, y, 0), height[0].at(9, y, 0), 1e-6F);
    }
}

TEST(GutterRows, AnyNumberOfThreadsGivesTheSameBytes)
{
    OracleCase c = holes_case(300, 270, 6);
    std::map<std::string, std::string> first;
    for (const int threads : {1, 2, 5}) {
        const TempFolder temp;
        c.options.threads = threads;
        const Manifest manifest = bake_memory(temp / "set", c.source(), c.options);
        for (const TextureRecord& texture : manifest.textures) {
            const std::string bytes = read_bytes(temp / "set" / texture.file);
            const auto [known, is_new] = first.emplace(texture.file, bytes);
            EXPECT_EQ(is_new, threads == 1);
            EXPECT_TRUE(known->second == bytes) << texture.file << " with " << threads;
        }
    }
}

// --- the order of tile rows ----------------------------------------------------------------------

using HasData = std::function<bool(int x, int y)>;

const HasData kBlobs = [](int x, int y) {
    return std::sin(0.31 * x) + std::sin(0.27 * y + 0.2 * x) > -0.3;
};
const HasData kDots = [](int x, int y) { return (x * 7 + y * 11) % 10 > 0; };

using Handed = std::vector<std::pair<int, int>>; // level, tile_y

/// What is handed out, batch after batch of 16 rows of level 0.
std::vector<Handed> handed_out(int width, int height, Wrap wrap, const HasData& has_data)
{
    const TempFolder temp;
    MomentSet set;
    set.slope = false;
    const MomentLayout layout(set);
    MipLayout file_layout;
    file_layout.width = width;
    file_layout.height = height;
    file_layout.channels = {"a"};
    const MipFile file(temp / "a.exr", file_layout);
    TextureRows texture(Map::coverage, layout, {}, file);
    GutterRows gutter(width, height, wrap, wrap, {&texture});
    MomentPyramid pyramid(layout, width, height, {&gutter});
    std::vector<Handed> batches;
    for (int first = 0; first < height; first += 16) {
        pyramid.push(std::min(16, height - first), [&](int y, int x0, int count, MomentRow row) {
            for (int x = 0; x < count; ++x)
                row.plane(MomentLayout::weight)[x] = has_data(x0 + x, y) ? 1 : 0;
        });
        batches.emplace_back();
        for (const TileRow& row : texture.take_finished())
            batches.back().emplace_back(row.level, row.tile_y);
    }
    return batches;
}

TEST(GutterRows, HandsTileRowsOutInAnOrderOfTheSizesAndKeepsFewBack)
{
    for (const Wrap wrap : {Wrap::periodic, Wrap::clamp})
        for (const auto& [width, height] :
             {std::pair(100, 1000), std::pair(65, 513), std::pair(7, 129), std::pair(3, 2)}) {
            const auto batches = handed_out(width, height, wrap, kBlobs);
            EXPECT_EQ(batches, handed_out(width, height, wrap, kDots));
            std::set<std::pair<int, int>> rows;
            std::map<int, int> out; // of a level
            for (size_t b = 0; b < batches.size(); ++b) {
                for (const auto& row : batches[b]) {
                    EXPECT_TRUE(rows.insert(row).second) << row.first << " " << row.second;
                    ++out[row.first];
                }
                // Below the tile rows finished 3 rows are wanted; the first may wait for the end.
                const int made = 16 * (static_cast<int>(b) + 1);
                const int held = wrap == Wrap::periodic ? 1 : 0;
                EXPECT_GE(out[0], (made - 3) / kTileSize - held) << "after row " << made;
            }
            size_t expected = 0;
            for (int h = height, w = width;; h = std::max(1, h / 2), w = std::max(1, w / 2)) {
                expected += static_cast<size_t>((h + kTileSize - 1) / kTileSize);
                if (h == 1 && w == 1)
                    break;
            }
            EXPECT_EQ(rows.size(), expected) << width << "x" << height;
        }
}

} // namespace
} // namespace scree::test
