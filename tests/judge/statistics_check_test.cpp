// Sets against brute force: right ones are found right, a wrong number is found where it is.
#include "judge/statistics_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/oracle_case.h"
#include "support/rewrite.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

using Figures = std::vector<StatisticsFigure>;

bool is_inside(const StatisticsFigure& figure) { return figure.largest <= figure.tolerance; }

void expect_inside(const Figures& figures, const std::string& title)
{
    for (const StatisticsFigure& figure : figures)
        EXPECT_TRUE(is_inside(figure)) << title << ": " << figure.name << " level " << figure.level
                                       << " error " << figure.largest << " at " << figure.x << ","
                                       << figure.y << " of " << figure.tolerance;
}

std::vector<std::string> names_of(const Figures& figures)
{
    std::vector<std::string> names;
    for (const StatisticsFigure& figure : figures)
        if (figure.level == 0)
            names.push_back(figure.name);
    return names;
}

/// Bakes what the source holds and compares the set with it.
Figures baked_and_checked(const MemorySource& from, BakeOptions options, const TempFolder& temp)
{
    options.output = temp / "set";
    MemorySource source = from;
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    SetReader set(options.output);
    return check_statistics(set, read_original(source, options, {}), options, {});
}

TEST(StatisticsCheck, FindsSetsOfEveryWrapAndReconstructionRight)
{
    unsigned seed = 1;
    for (const Wrap wrap : {Wrap::periodic, Wrap::clamp, Wrap::mirror, Wrap::black})
        for (const auto reconstruction :
             {Reconstruction::bilinear, Reconstruction::central, Reconstruction::sobel})
            for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::automatic}) {
                const TempFolder temp;
                OracleCase c = holes_case(67, 30, seed++);
                set_wrap(c, wrap, Wrap::clamp);
                set_reconstruction(c, reconstruction);
                set_texel_size(c, 0.25, 3);
                c.options.pixel_type = type;
                c.options.rank_terms = 8;
                const Figures figures = baked_and_checked(c.source(), c.options, temp);
                expect_inside(figures, c.title);
                EXPECT_EQ(
                    names_of(figures),
                    (std::vector<std::string>{
                        "height mean and deviation", "mean slope", "slope covariance",
                        "mean height", "height variance", "mean color", "color-height covariance",
                        "color-slope covariance", "rank terms", "tail weight", "coverage"}));
                EXPECT_EQ(figures.size(), 1 + 10U * 7U) << "67x30 has 7 levels";
            }
}

TEST(StatisticsCheck, FindsSamplesRightAlsoAboveTheSummariesOfRanks)
{
    for (const std::string kind : {"fractal", "bricks", "vgroove", "sine", "plane"}) {
        const TempFolder temp;
        const auto field = make_sample(kind, 256, 130);
        const Figures figures = baked_and_checked(sample_source(*field, 256, 130), {}, temp);
        expect_inside(figures, kind);
        EXPECT_EQ(figures.back().level, 8);
    }
}

TEST(StatisticsCheck, AllowsForTheSummariesOfRankTables)
{
    // The hardest for them: colors that jump with height, in three ways, and 8 terms.
    MemorySource source;
    source.map_width = source.map_height = 256;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const double h =
                std::sin(0.02 * x + 0.05 * y) + std::cos(0.04 * x - 0.01 * y) + 0.1 * noise(random);
            source.heights.push_back(h);
            source.colors.push_back({h > 0.8 ? 1.0 : 0.02, std::fmod(std::floor(3 * h) + 9, 2.0),
                                     h < -1.5 ? 1.0 : 0.0});
        }
    BakeOptions options;
    options.maps = {Map::rank};
    options.rank_terms = 8;
    options.pixel_type = PixelTypeChoice::float32;
    const TempFolder temp;
    double exact = 0, summarised = 0;
    for (const StatisticsFigure& figure : baked_and_checked(source, options, temp)) {
        double& largest = figure.level > 6 ? summarised : exact;
        largest = std::max(largest, figure.largest);
        EXPECT_TRUE(is_inside(figure))
            << figure.name << " " << figure.level << " " << figure.largest;
    }
    RecordProperty("summarised", std::to_string(summarised));
    EXPECT_LT(exact, 1e-5);
    EXPECT_GT(summarised, 1e-4) << "needs its allowance";
}

TEST(StatisticsCheck, DoesNotJudgeTheTailOfAPlane)
{
    // Its slopes differ by what 0.1 x + 0.03 y is rounded to, in another way in each of the two.
    MemorySource plane;
    plane.map_width = 50;
    plane.map_height = 40;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            plane.heights.push_back(0.1 * x + 0.03 * y);
    BakeOptions options;
    options.wrap_s = options.wrap_t = Wrap::clamp;
    options.texel_size = std::array{0.3, 0.7};
    const TempFolder temp;
    expect_inside(baked_and_checked(plane, options, temp), "plane");
}

TEST(StatisticsCheck, FindsNormalMapsAndBumpslopesRight)
{
    OracleCase c = random_case(40, 33, 3);
    std::vector<std::array<double, 2>> slopes;
    for (const double h : c.input.relief.heights)
        slopes.push_back({h, 0.5 - 0.3 * h * h});
    for (const bool normal_map : {false, true}) {
        if (normal_map) {
            c.input.slopes = slopes;
            c.input.relief.heights.clear();
        }
        const TempFolder plain, bump;
        const Figures figures = baked_and_checked(c.source(), c.options, plain);
        expect_inside(figures, "normal map");
        EXPECT_EQ(names_of(figures).size(), normal_map ? 5U : 10U);
        c.options.layout = Layout::bumpslopes;
        const Figures bumpslopes = baked_and_checked(c.source(), c.options, bump);
        expect_inside(bumpslopes, "bumpslopes");
        std::vector<std::string> names{"world height", "mean slope", "slope covariance"};
        if (!normal_map)
            names.insert(names.begin(), "height mean and deviation");
        EXPECT_EQ(names_of(bumpslopes), names);
        c.options.layout = Layout::scree;
    }
}

TEST(StatisticsCheck, FindsSetsOfColorMapsRight)
{
    const TempFolder temp;
    const OracleCase c = random_case(37, 21, 4);
    Image heights{37, 21, {"Y"}, {}};
    for (const double h : c.input.relief.heights)
        heights.pixels.push_back(static_cast<float>(h));
    heights.pixels[50] = std::nanf(""); // what a hole holds is not compared
    write_image(temp / "height.exr", heights);
    std::ofstream(temp / "map.cpt") << "0 10/20/30 0.4 200/100/50\n0.4 200/100/50 1 0/0/255\n";
    for (const MapBy by : {MapBy::height, MapBy::slope, MapBy::slope_magnitude}) {
        BakeOptions options;
        options.height_file = temp / "height.exr";
        options.colormap_file = temp / "map.cpt";
        options.map_by = by;
        options.map_azimuth_deg = 30;
        options.map_range = std::array{-2.0, 2.5};
        options.pixel_type = PixelTypeChoice::float32;
        options.texel_size = std::array{1.0, 0.5};
        options.output = temp / ("set" + map_by_name(by));
        bake(options);
        SetReader set(options.output);
        expect_inside(check_statistics(set, read_original(options, {}), options, {}),
                      map_by_name(by));
    }
}

TEST(StatisticsCheck, FindsRealBricksRight)
{
    const auto folder = data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no data";
    const auto bricks = folder / "heights" / "structured" / "bricks_02_256";
    for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::automatic}) {
        const TempFolder temp;
        BakeOptions options;
        options.height_file = bricks / "bricks_02_height_2k_raw.exr";
        options.color_file = bricks / "bricks_02_basecolor_2k_acescg.exr";
        options.height_scale = 0.1;
        options.pixel_type = type;
        options.output = temp / "set";
        bake(options);
        SetReader set(options.output);
        expect_inside(check_statistics(set, read_original(options, {}), options, {}), "bricks");
    }
}

/// A number in a file that is changed, and what the check should say of it.
struct Change {
    const char* map;
    int channel, level, x, y;
    double by; ///< added to the number
    std::vector<std::string> figures;
};

TEST(StatisticsCheck, FindsAChangedNumberAtItsPlace)
{
    // Numbers and yardsticks are near 1 (rms slope 1.5), so changes are a few times 1e-5.
    const double step = 1e-3, nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Change> changes = {
        {"slope", 0, 0, 12, 40, step, {"mean slope", "slope covariance"}}, // s
        {"slope", 2, 1, 30, 0, step, {"slope covariance"}},                // st
        {"slope", 4, 6, 0, 0, -step, {"slope covariance"}},                // tt
        {"height", 0, 2, 3, 4, step, {"mean height", "height variance"}},
        {"height", 1, 0, 66, 69, step, {"height variance"}},
        {"color", 2, 3, 7, 1, step, {"mean color"}},
        {"colorheight", 1, 1, 5, 9, -step, {"color-height covariance"}},
        {"colorslope", 5, 2, 10, 11, step, {"color-slope covariance"}}, // Rt
        {"rank", 7, 1, 2, 3, step, {"rank terms"}},                     // G4
        {"tail", 0, 2, 3, 3, 0.001, {"tail weight"}},
        {"coverage", 0, 1, 0, 0, -step, {"coverage"}},
        {"color", 0, 0, 1, 68, nan, {"mean color"}},
    };
    const TempFolder temp;
    OracleCase c = holes_case(67, 70, 9);
    c.options.pixel_type = PixelTypeChoice::float32;
    expect_inside(baked_and_checked(c.source(), c.options, temp), "before");
    const MemorySource source = c.source();
    for (const Change& change : changes) {
        const auto file = temp / "set" / (std::string("test.") + change.map + ".exr");
        const std::string before = read_bytes(file);
        rewrite_texture(file, change.level, change.x, change.y, change.channel,
                        [&](float value) { return value + static_cast<float>(change.by); });
        SetReader set(temp / "set");
        MemorySource again = source;
        std::vector<std::string> found;
        for (const auto& figure :
             check_statistics(set, read_original(again, c.options, {}), c.options, {}))
            if (!is_inside(figure)) {
                found.push_back(figure.name);
                EXPECT_EQ(figure.level, change.level) << change.map;
                EXPECT_EQ(figure.x, change.x) << change.map;
                EXPECT_EQ(figure.y, change.y) << change.map;
                if (std::isfinite(change.by) && found.size() == 1) {
                    EXPECT_GT(figure.largest * figure.yardstick, 0.4 * std::abs(change.by));
                    EXPECT_LT(figure.rms, figure.largest);
                }
            }
        EXPECT_EQ(found, change.figures) << change.map << " channel " << change.channel;
        std::ofstream(file, std::ios::binary) << before;
    }
}

TEST(StatisticsCheck, FindsAnAlienSurfaceWrong)
{
    // Where a single texel of the inputs is another, so is every level above it.
    const TempFolder temp;
    OracleCase c = random_case(64, 64, 11);
    c.options.pixel_type = PixelTypeChoice::float32;
    baked_and_checked(c.source(), c.options, temp);
    MemorySource other = c.source();
    other.heights[size_t{64} * 20 + 33] += 1;
    SetReader set(temp / "set");
    const Figures figures =
        check_statistics(set, read_original(other, c.options, {}), c.options, {});
    for (const StatisticsFigure& figure : figures) {
        const bool is_top = figure.level == 6; // mean 0, variance 1 of any surface
        if ((figure.name == "mean height" && !is_top) ||
            (figure.name == "slope covariance" && figure.level > 0) ||
            figure.name == "height mean and deviation") {
            EXPECT_FALSE(is_inside(figure)) << figure.name << " level " << figure.level;
        }
    }

    // All of it higher by 1, or twice as high and wide: just what heights are relative to is wrong.
    for (const bool higher : {true, false}) {
        MemorySource moved = c.source();
        const double middle = set.manifest().h0;
        for (double& h : moved.heights)
            h = higher ? h + 1 : middle + 2 * (h - middle);
        BakeOptions options = c.options;
        if (!higher)
            options.texel_size = std::array{2.0, 2.0};
        const Figures of_moved =
            check_statistics(set, read_original(moved, options, {}), options, {});
        expect_inside({of_moved.begin() + 1, of_moved.end()}, "moved");
        EXPECT_FALSE(is_inside(of_moved.front())) << of_moved.front().name;
    }

    MemorySource smaller = sample_source(*make_sample("sine", 32, 64), 32, 64);
    EXPECT_THROW(check_statistics(set, read_original(smaller, c.options, {}), c.options, {}),
                 Error);
}

TEST(StatisticsCheck, SaysWhereHalfLosesTooMuch)
{
    // A height far out: half keeps its square near 56^2 to 1, and the variance is 0.
    MemorySource source;
    source.map_width = source.map_height = 64;
    source.heights.assign(size_t{64} * 64, 0.0);
    source.heights[size_t{64} * 30 + 17] = 1;
    source.heights[size_t{64} * 50 + 40] = 0.55;
    BakeOptions options;
    options.maps = {Map::height, Map::slope};
    for (const auto type : {PixelTypeChoice::half, PixelTypeChoice::automatic}) {
        const TempFolder temp;
        options.pixel_type = type;
        const Figures figures = baked_and_checked(source, options, temp);
        const auto variance = std::find_if(figures.begin(), figures.end(), [](const auto& figure) {
            return figure.name == "height variance";
        });
        EXPECT_EQ(is_inside(*variance), type == PixelTypeChoice::automatic) << variance->largest;
        if (type == PixelTypeChoice::half) {
            EXPECT_EQ(variance->x, 17);
            EXPECT_EQ(variance->y, 30);
        }
        EXPECT_TRUE(is_inside(figures.back())) << "the slope's last level";
    }
}

TEST(StatisticsCheck, SaysWhereEvenFloatLosesTheHeights)
{
    // In world units, as bumpslopes has them: float resolves 0.06 at a million.
    MemorySource source = random_case(20, 20, 6).source();
    for (double& h : source.heights)
        h = 1e6 + 0.05 * h;
    BakeOptions options;
    options.layout = Layout::bumpslopes;
    options.pixel_type = PixelTypeChoice::float32;
    const TempFolder temp;
    for (const StatisticsFigure& figure : baked_and_checked(source, options, temp)) {
        const bool is_lost = figure.name == "world height" && figure.level < 3;
        EXPECT_TRUE(is_inside(figure) || figure.name == "world height") << figure.name;
        EXPECT_FALSE(is_inside(figure) && is_lost) << figure.level;
    }
}

TEST(StatisticsCheck, TellsItsProgressAndStops)
{
    const TempFolder temp;
    const OracleCase c = random_case(64, 64, 12);
    baked_and_checked(c.source(), c.options, temp);
    SetReader set(temp / "set");
    MemorySource source = c.source();
    const Original original = read_original(source, c.options, {});
    std::vector<double> told;
    check_statistics(set, original, c.options, [&](double done) { told.push_back(done); });
    ASSERT_EQ(told.size(), 7U); // levels
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_LT(told.back(), 1);
    EXPECT_THROW(check_statistics(set, original, c.options, [](double) { throw Cancelled(); }),
                 Cancelled);
}

} // namespace
} // namespace scree::test
