// The streaming resampler against the whole image at once.

#include "pipeline/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/random_image.h"

namespace scree::test {
namespace {

constexpr Wrap kWraps[] = {Wrap::periodic, Wrap::clamp, Wrap::mirror, Wrap::black};

/// The image at another size, read `strip` rows at a time.
Image resampled(const Image& from, int width, int height, Wrap wrap_s, Wrap wrap_t, int strip = 64)
{
    RowResampler resampler(from.width, from.height, width, height, wrap_s, wrap_t);
    const size_t channels = from.channels.size();
    Image to{width, height, from.channels, {}};
    to.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * channels);
    for (int again = 0; again < 2; ++again) { // the second time after rewind()
        size_t read = 0;
        for (int y = 0; y < height; y += strip)
            resampler.read(
                std::min(strip, height - y), channels,
                [&](int count, float* out) {
                    const size_t size = static_cast<size_t>(count * from.width) * channels;
                    ASSERT_LE(read + size, from.pixels.size());
                    std::copy_n(&from.pixels[read], size, out);
                    read += size;
                },
                &to.pixels[static_cast<size_t>(y) * static_cast<size_t>(width) * channels]);
        resampler.rewind();
    }
    return to;
}

double wrapped_value(const Image& image, int x, int y, int c, Wrap wrap_s, Wrap wrap_t)
{
    bool black = false;
    auto inside = [&black](int i, int n, Wrap wrap) {
        if (i >= 0 && i < n)
            return i;
        switch (wrap) {
        case Wrap::periodic:
            return ((i % n) + n) % n;
        case Wrap::mirror: // the edge itself is the mirror
            while (i < 0 || i >= n)
                i = i < 0 ? -1 - i : 2 * n - 1 - i;
            return i;
        case Wrap::clamp:
            return i < 0 ? 0 : n - 1;
        case Wrap::black:
            break;
        }
        black = true;
        return 0;
    };
    const int column = inside(x, image.width, wrap_s);
    const int row = inside(y, image.height, wrap_t);
    return black ? 0 : static_cast<double>(image.at(column, row, c));
}

// Oracle: the definition, a triangle as wide as a texel of the coarser grid, texel by texel.
double by_definition(const Image& from, int width, int height, int x, int y, int c, Wrap wrap_s,
                     Wrap wrap_t)
{
    const double scale_s = static_cast<double>(from.width) / width;
    const double scale_t = static_cast<double>(from.height) / height;
    const double at_s = (x + 0.5) * scale_s - 0.5, at_t = (y + 0.5) * scale_t - 0.5;
    const double radius_s = std::max(1.0, scale_s), radius_t = std::max(1.0, scale_t);
    auto tent = [](double distance, double radius) {
        return std::max(0.0, 1 - std::abs(distance) / radius);
    };
    const auto reach_s = static_cast<int>(std::ceil(radius_s)) + 1;
    const auto reach_t = static_cast<int>(std::ceil(radius_t)) + 1;
    double sum = 0, weights = 0;
    for (int v = static_cast<int>(std::floor(at_t)) - reach_t;
         v <= static_cast<int>(std::ceil(at_t)) + reach_t; ++v)
        for (int u = static_cast<int>(std::floor(at_s)) - reach_s;
             u <= static_cast<int>(std::ceil(at_s)) + reach_s; ++u) {
            const double w = tent(u - at_s, radius_s) * tent(v - at_t, radius_t);
            weights += w;
            if (w > 0)
                sum += w * wrapped_value(from, u, v, c, wrap_s, wrap_t);
        }
    return sum / weights;
}

const std::pair<std::pair<int, int>, std::pair<int, int>> kSizes[] = {
    {{8, 8}, {16, 16}},     {{16, 16}, {8, 8}},    {{7, 5}, {13, 11}},   {{13, 11}, {7, 5}},
    {{64, 3}, {5, 70}},     {{5, 70}, {64, 3}},    {{1, 1}, {9, 4}},     {{9, 4}, {1, 1}},
    {{1, 30}, {3, 7}},      {{3, 7}, {1, 30}},     {{20, 20}, {19, 21}}, {{2, 2}, {1, 3}},
    {{100, 90}, {30, 130}}, {{33, 200}, {33, 100}}};

// Sums of up to a hundred products in float: 5e-7 of numbers below 1.
TEST(Resample, EqualsItsDefinitionForEverySizeAndWrap)
{
    for (const auto& [from_size, to_size] : kSizes) {
        const Image from = random_image(from_size.first, from_size.second, {"R", "G", "B"}, 11);
        for (const Wrap wrap_s : kWraps)
            for (const Wrap wrap_t : kWraps) {
                // one strip of the image is in memory: a periodic map repeats its edge along t
                const Wrap wrap_done = wrap_t == Wrap::periodic ? Wrap::clamp : wrap_t;
                const Image to = resampled(from, to_size.first, to_size.second, wrap_s, wrap_t, 5);
                for (int y = 0; y < to.height; ++y)
                    for (int x = 0; x < to.width; ++x)
                        ASSERT_NEAR(static_cast<double>(to.at(x, y, y % 3)),
                                    by_definition(from, to.width, to.height, x, y, y % 3, wrap_s,
                                                  wrap_done),
                                    5e-7)
                            << from.width << "x" << from.height << " to " << to.width << "x"
                            << to.height << " wrap " << wrap_name(wrap_s) << " "
                            << wrap_name(wrap_t) << " texel (" << x << ", " << y << ")";
            }
    }
}

TEST(Resample, AConstantStaysConstant)
{
    for (const auto& [from_size, to_size] : kSizes)
        for (const Wrap wrap : {Wrap::periodic, Wrap::clamp, Wrap::mirror}) {
            Image from = random_image(from_size.first, from_size.second, {"Y"}, 1);
            std::fill(from.pixels.begin(), from.pixels.end(), 0.7F);
            for (const float value :
                 resampled(from, to_size.first, to_size.second, wrap, wrap).pixels)
                ASSERT_NEAR(value, 0.7F, 5e-7F); // weights rounded to float sum to 1 as closely
        }
}

/// A plane in units of the map's width and height, at texel centres.
Image plane(int width, int height)
{
    Image image{width, height, {"Y"}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.pixels.push_back(static_cast<float>((x + 0.5) / width - 2 * (y + 0.5) / height));
    return image;
}

// Interpolation keeps a plane, and so does a tent over a whole number of texels.
TEST(Resample, APlaneStaysAPlaneInside)
{
    const std::pair<int, int> sizes[] = {{16, 64}, {16, 37}, {17, 23}, {64, 16},
                                         {64, 32}, {63, 21}, {20, 20}};
    for (const auto& [from, to] : sizes) {
        const Image got = resampled(plane(from, from), to, to, Wrap::clamp, Wrap::clamp);
        const Image want = plane(to, to);
        const int edge = to >= from ? (to + from - 1) / from : 1; // texels that look beyond
        for (int y = edge; y < to - edge; ++y)
            for (int x = edge; x < to - edge; ++x)
                ASSERT_NEAR(got.at(x, y, 0), want.at(x, y, 0), 1e-6F) // float, numbers up to 2
                    << from << " to " << to << " texel (" << x << ", " << y << ")";
    }
}

// Where the ratio of the sizes is no whole number, the samples under a tent are not balanced: a
// shift of less than a tenth of a texel of the original.
TEST(Resample, ShrinkingByAnyRatioShiftsAPlaneByLessThanATenthOfATexel)
{
    for (const auto& [from, to] : {std::pair(64, 63), {64, 50}, {64, 43}, {64, 30}, {64, 7}}) {
        const Image got = resampled(plane(from, 1), to, 1, Wrap::clamp, Wrap::clamp);
        double worst = 0;
        for (int x = 1; x < to - 1; ++x) {
            const double shift = static_cast<double>(got.at(x, 0, 0)) - ((x + 0.5) / to - 1);
            worst = std::max(worst, std::abs(shift) * from);
        }
        EXPECT_LT(worst, 0.1) << from << " to " << to;
    }
}

TEST(Resample, EqualSizesPassEveryBit)
{
    const Image from = random_image(31, 70, {"R", "G", "B"}, 2);
    EXPECT_EQ(resampled(from, 31, 70, Wrap::periodic, Wrap::periodic, 7).pixels, from.pixels);
}

TEST(Resample, StripsOfAnyHeightGiveTheSameRows)
{
    const Image from = random_image(40, 90, {"R", "G"}, 3);
    const auto whole = resampled(from, 25, 130, Wrap::mirror, Wrap::mirror, 1000).pixels;
    for (const int strip : {1, 2, 63, 64, 65})
        EXPECT_EQ(resampled(from, 25, 130, Wrap::mirror, Wrap::mirror, strip).pixels, whole);
}

TEST(Resample, ATexelThatIsNotFiniteReachesJustItsNeighbours)
{
    Image from = random_image(16, 16, {"Y"}, 4);
    from.pixels[8 * 16 + 8] = std::numeric_limits<float>::quiet_NaN();
    const Image to = resampled(from, 32, 32, Wrap::clamp, Wrap::clamp);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            // centres of the finer grid, in texels of the coarser, within 1 of the bad one
            const bool near =
                std::abs((x + 0.5) / 2 - 8.5) < 1 && std::abs((y + 0.5) / 2 - 8.5) < 1;
            EXPECT_EQ(std::isnan(to.at(x, y, 0)), near) << x << ", " << y;
        }
}

} // namespace
} // namespace scree::test
