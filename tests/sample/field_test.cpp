#include "sample/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace scree {
namespace {

const std::vector<std::pair<int, int>> kSizes = {
    {1, 1},   {1, 7},   {7, 1},   {2, 2},     {3, 3},    {7, 3},   {17, 31},
    {64, 64}, {63, 65}, {99, 99}, {100, 128}, {128, 48}, {3, 500}, {600, 2}};

/// A whole map, height x width, row 0 at t = 0.
struct Map {
    int width, height;
    std::vector<float> heights, rgb;

    double at(int x, int y) const
    {
        x = (x % width + width) % width;
        y = (y % height + height) % height;
        return double(
            heights[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)]);
    }
};

Map whole(const SampleField& field)
{
    Map map{field.info().width_texels, field.info().height_texels, {}, {}};
    const auto width = static_cast<size_t>(map.width);
    const auto height = static_cast<size_t>(map.height);
    map.heights.resize(width * height);
    map.rgb.resize(3 * width * height);
    for (size_t y = 0; y < height; ++y)
        field.row(static_cast<int>(y), &map.heights[y * width], &map.rgb[3 * y * width]);
    return map;
}

/// Oracle: the slopes of the bilinear interpolation, square by square between texel centres.
/// The products are of degree 2 in each coordinate, so Gauss-Legendre with 2 x 2 points is
/// exact.
KnownAnswers by_quadrature(const Map& map, double dx, double dy, bool periodic)
{
    double n = 0, s = 0, t = 0, ss = 0, tt = 0, st = 0, h = 0, hh = 0;
    const double offset = 0.5 / std::sqrt(3.0);
    for (int y = 0; y < map.height - (periodic ? 0 : 1); ++y)
        for (int x = 0; x < map.width - (periodic ? 0 : 1); ++x)
            for (double f : {0.5 - offset, 0.5 + offset})
                for (double g : {0.5 - offset, 0.5 + offset}) {
                    const double h00 = map.at(x, y), h10 = map.at(x + 1, y);
                    const double h01 = map.at(x, y + 1), h11 = map.at(x + 1, y + 1);
                    const double ds = ((1 - g) * (h10 - h00) + g * (h11 - h01)) / dx;
                    const double dt = ((1 - f) * (h01 - h00) + f * (h11 - h10)) / dy;
                    n += 1;
                    s += ds;
                    t += dt;
                    ss += ds * ds;
                    tt += dt * dt;
                    st += ds * dt;
                }
    for (float value : map.heights) {
        h += double(value);
        hh += double(value) * double(value);
    }
    const auto texels = static_cast<double>(map.heights.size());
    KnownAnswers found;
    found.mean_s = s / n;
    found.mean_t = t / n;
    found.var_ss = ss / n - s / n * s / n;
    found.var_tt = tt / n - t / n * t / n;
    found.cov_st = st / n - s / n * t / n;
    found.mean_height = h / texels;
    found.std_height = std::sqrt(std::max(0.0, hh / texels - h / texels * h / texels));
    return found;
}

/// The claim, where there is one; returns how many there were.
int expect_known(const KnownAnswers& claim, const KnownAnswers& found, double slope_tolerance,
                 double height_tolerance)
{
    struct {
        const char* name;
        double KnownAnswers::*member;
        double tolerance;
    } const members[] = {
        {"mean s", &KnownAnswers::mean_s, slope_tolerance},
        {"mean t", &KnownAnswers::mean_t, slope_tolerance},
        {"var ss", &KnownAnswers::var_ss, slope_tolerance},
        {"var tt", &KnownAnswers::var_tt, slope_tolerance},
        {"cov st", &KnownAnswers::cov_st, slope_tolerance},
        {"mean height", &KnownAnswers::mean_height, height_tolerance},
        {"std height", &KnownAnswers::std_height, height_tolerance},
    };
    int checked = 0;
    for (const auto& m : members)
        if (!std::isnan(claim.*m.member)) {
            EXPECT_NEAR(found.*m.member, claim.*m.member, m.tolerance) << m.name;
            ++checked;
        }
    return checked;
}

std::string label(const std::string& kind, std::pair<int, int> size)
{
    return kind + " " + std::to_string(size.first) + "x" + std::to_string(size.second);
}

TEST(Sample, EveryKindAndSizeIsFiniteWithColorsInRange)
{
    ASSERT_EQ(sample_kinds(),
              (std::vector<std::string>{"fractal", "bricks", "vgroove", "sine", "plane"}));
    for (const std::string& kind : sample_kinds())
        for (const auto& size : kSizes) {
            SCOPED_TRACE(label(kind, size));
            const auto field = make_sample(kind, size.first, size.second);
            const SampleInfo& info = field->info();
            EXPECT_EQ(info.kind, kind);
            EXPECT_FALSE(info.description.empty());
            EXPECT_EQ(info.width_texels, size.first);
            EXPECT_EQ(info.height_texels, size.second);
            EXPECT_GT(info.world_width, 0);
            EXPECT_GT(info.world_height, 0);
            for (const std::string& wrap : {info.wrap_s, info.wrap_t})
                EXPECT_EQ(wrap, kind == "plane" ? "clamp" : "periodic");

            const Map map = whole(*field);
            for (float h : map.heights)
                ASSERT_TRUE(std::isfinite(h));
            for (float c : map.rgb)
                ASSERT_TRUE(c >= 0 && c <= 1) << c;
        }
}

TEST(Sample, RowsDependOnNothingButTheirNumber)
{
    for (const std::string& kind : sample_kinds())
        for (const auto& size : kSizes) {
            SCOPED_TRACE(label(kind, size));
            const Map map = whole(*make_sample(kind, size.first, size.second));
            const auto again = make_sample(kind, size.first, size.second);
            const auto width = static_cast<size_t>(map.width);
            std::vector<float> heights(width), rgb(3 * width), without_color(width);
            for (int y = map.height - 1; y >= 0; --y) { // the other way round
                again->row(y, without_color.data(), nullptr);
                again->row(y, heights.data(), rgb.data());
                const auto start = static_cast<std::ptrdiff_t>(width) * y;
                ASSERT_TRUE(
                    std::equal(heights.begin(), heights.end(), map.heights.begin() + start));
                ASSERT_TRUE(std::equal(rgb.begin(), rgb.end(), map.rgb.begin() + 3 * start));
                ASSERT_EQ(heights, without_color);
            }
        }
}

TEST(Sample, RowsOutsideTheMapFollowTheWrap)
{
    for (const std::string& kind : sample_kinds()) {
        SCOPED_TRACE(kind);
        const auto field = make_sample(kind, 20, 12);
        const bool periodic = field->info().wrap_t == "periodic";
        std::vector<float> outside(20), inside(20);
        for (int y : {-25, -12, -1, 12, 13, 40}) {
            field->row(y, outside.data(), nullptr);
            field->row(periodic ? (y + 36) % 12 : std::clamp(y, 0, 11), inside.data(), nullptr);
            EXPECT_EQ(outside, inside) << y;
        }
    }
}

/// Mean absolute step of height from column x to x + 1 (row, if not along s).
double mean_step(const Map& map, bool along_s, int x)
{
    const int across = along_s ? map.height : map.width;
    double sum = 0;
    for (int k = 0; k < across; ++k)
        sum += along_s ? std::abs(map.at(x + 1, k) - map.at(x, k))
                       : std::abs(map.at(k, x + 1) - map.at(k, x));
    return sum / across;
}

// The step over each border is like the steps beside it; the 1.3 is for
// roughness. No brick ends on the left border, so half a brick of another firing would show.
TEST(Sample, PeriodicKindsCloseOverBothBorders)
{
    int checked = 0;
    for (const std::string& kind : sample_kinds())
        for (const auto& size : {std::make_pair(256, 256), std::make_pair(512, 192),
                                 std::make_pair(150, 400), std::make_pair(1040, 1040)}) {
            const auto field = make_sample(kind, size.first, size.second);
            if (field->info().wrap_s != "periodic")
                continue;
            SCOPED_TRACE(label(kind, size));
            const Map map = whole(*field);
            for (bool along_s : {true, false}) {
                const int last = (along_s ? map.width : map.height) - 1;
                double beside = 0;
                for (int d = 1; d <= 3; ++d)
                    beside = std::max({beside, mean_step(map, along_s, last - d),
                                       mean_step(map, along_s, last + d)});
                EXPECT_LE(mean_step(map, along_s, last), 1.3 * beside) << along_s;
                ++checked;
            }
        }
    EXPECT_EQ(checked, 32);
}

// Tolerances: float heights of size H, steps of one texel: H 2^-24 a texel, squared slopes
// about 1.
TEST(Sample, KnownAnswersMatchTheBilinearInterpolation)
{
    for (const std::string& kind : sample_kinds())
        for (const auto& size : kSizes) {
            SCOPED_TRACE(label(kind, size));
            const auto field = make_sample(kind, size.first, size.second);
            const SampleInfo& info = field->info();
            const bool periodic = info.wrap_s == "periodic";
            if (!periodic && std::min(size.first, size.second) < 2)
                continue; // a single line has no slope across
            const Map map = whole(*field);
            const double dx = info.world_width / info.width_texels;
            const double dy = info.world_height / info.height_texels;
            double largest = 1e-6;
            for (float h : map.heights)
                largest = std::max(largest, std::abs(double(h)));
            const double rounding = largest / 8e6;
            const int checked = expect_known(info.bilinear, by_quadrature(map, dx, dy, periodic),
                                             rounding / std::min(dx, dy), rounding);
            EXPECT_EQ(checked, kind == "fractal" || kind == "bricks" ? 2 : 7);
        }
}

TEST(Sample, SineTendsToItsContinuousAnswersWithTheSquareOfTheTexel)
{
    double before = 0;
    for (int n : {64, 128, 256, 512}) {
        const auto field = make_sample("sine", n, n);
        const KnownAnswers &fine = field->info().continuous, &sampled = field->info().bilinear;
        // By hand: A = 0.02, five waves by three on a square of side 1.
        const double scale = 0.02 * 0.02 / 2 * 4 * std::acos(-1.0) * std::acos(-1.0);
        EXPECT_NEAR(fine.var_ss, scale * 25, 1e-12);
        EXPECT_NEAR(fine.var_tt, scale * 9, 1e-12);
        EXPECT_NEAR(fine.cov_st, scale * 15, 1e-12);
        const double error = std::max({std::abs(fine.var_ss - sampled.var_ss),
                                       std::abs(fine.var_tt - sampled.var_tt),
                                       std::abs(fine.cov_st - sampled.cov_st)});
        if (n > 64) {
            EXPECT_NEAR(before / error, 4, 0.2) << n;
        }
        before = error;
    }
}

TEST(Sample, VgrooveHasOnlyTheTwoSlopesAndPeriodSixteenWhereItFits)
{
    for (int width : {2, 16, 48, 64, 100, 4096}) {
        const auto field = make_sample("vgroove", width, 2);
        const Map map = whole(*field);
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(std::abs(map.at(x + 1, 0) - map.at(x, 0)), 0.5) << width << " at " << x;
        EXPECT_EQ(field->info().bilinear.var_ss, 0.25);
        if (width % 16 == 0) {
            for (int x = 0; x < width; ++x)
                ASSERT_EQ(map.at(x, 0), map.at(x + 16, 0));
            EXPECT_EQ(*std::max_element(map.heights.begin(), map.heights.end()), 4.0f);
        }
    }
}

TEST(Sample, ColorIsLinearInHeightWhereItShouldBe)
{
    for (const std::string kind : {"vgroove", "sine", "plane"}) {
        const Map map = whole(*make_sample(kind, 96, 80));
        const auto range = std::minmax_element(map.heights.begin(), map.heights.end());
        const auto low = static_cast<size_t>(range.first - map.heights.begin());
        const auto high = static_cast<size_t>(range.second - map.heights.begin());
        for (size_t k = 0; k < 3; ++k) {
            const float dark = map.rgb[3 * low + k], light = map.rgb[3 * high + k];
            EXPECT_GT(light - dark, 0.3f) << kind;
            for (size_t i = 0; i < map.heights.size(); ++i) {
                const float f = (map.heights[i] - *range.first) / (*range.second - *range.first);
                ASSERT_NEAR(map.rgb[3 * i + k], dark + f * (light - dark), 1e-6)
                    << kind << " texel " << i << " channel " << k;
            }
        }
    }
}

double height_color_correlation(const Map& map)
{
    double n = 0, h = 0, c = 0, hh = 0, cc = 0, hc = 0;
    for (size_t i = 0; i < map.heights.size(); ++i) {
        const auto x = double(map.heights[i]), y = double(map.rgb[3 * i + 1]);
        n += 1;
        h += x;
        c += y;
        hh += x * x;
        cc += y * y;
        hc += x * y;
    }
    return (hc / n - h / n * c / n) /
           std::sqrt((hh / n - h / n * h / n) * (cc / n - c / n * c / n));
}

TEST(Sample, SnowLiesHighAndMortarLow)
{
    for (int n : {128, 300, 512}) {
        EXPECT_GT(height_color_correlation(whole(*make_sample("fractal", n, n))), 0.7) << n;
        EXPECT_LT(height_color_correlation(whole(*make_sample("bricks", n, n))), -0.8) << n;
    }
}

double rms_slope(const std::string& kind, int width, int height)
{
    const auto field = make_sample(kind, width, height);
    const SampleInfo& info = field->info();
    const KnownAnswers found =
        by_quadrature(whole(*field), info.world_width / width, info.world_height / height, true);
    return std::sqrt(found.var_ss + found.var_tt);
}

TEST(Sample, SlopesArePlausibleAndHardlyGrowWithTheResolution)
{
    for (const char* kind : {"fractal", "bricks"}) {
        const double coarse = rms_slope(kind, 256, 256), fine = rms_slope(kind, 1024, 1024);
        for (double rms : {coarse, fine, rms_slope(kind, 512, 256), rms_slope(kind, 90, 200)})
            EXPECT_TRUE(rms > 0.3 && rms < 1.3) << kind << ": " << rms;
        EXPECT_LT(fine, 1.25 * coarse) << kind;
    }
}

// Twice the texels, the same land: coarse texels lie between two fine ones, so they differ by
// the detail the coarse map lacks (here below 12 m, of 700 m of relief).
TEST(Sample, LargerMapsShowTheSameTerrain)
{
    const Map coarse = whole(*make_sample("fractal", 256, 256));
    const Map fine = whole(*make_sample("fractal", 512, 512));
    double worst = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const double mean = (fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) +
                                 fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1)) /
                                4;
            worst = std::max(worst, std::abs(mean - coarse.at(x, y)));
        }
    EXPECT_LT(worst, 12);
}

TEST(Sample, UnknownKindsAndBadSizesSaySo)
{
    try {
        make_sample("brick", 64, 64);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(
            error.what(),
            "unknown sample \"brick\"; choose one of fractal, bricks, vgroove, sine, plane");
    }
    for (const auto& size :
         {std::make_pair(0, 4), std::make_pair(4, -1), std::make_pair(4, (1 << 20) + 1)})
        EXPECT_THROW(make_sample("sine", size.first, size.second), std::invalid_argument);
}

} // namespace
} // namespace scree
