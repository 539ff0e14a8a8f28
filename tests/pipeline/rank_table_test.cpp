// NAME.rank.exr against footprints sorted texel by texel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/bake.h"
#include "sample/field.h"
#include "stats/rank_rows.h"
#include "support/files.h"
#include "support/memory_source.h"
#include "support/oracle_case.h"
#include "support/sample_source.h"
#include "support/truth.h"

namespace scree::test {
namespace {

/// Largest error of the baked tables, by level.
std::vector<double> errors_of(const MemorySource& given, int terms)
{
    TempFolder temp;
    MemorySource source = given;
    BakeOptions options;
    options.output = temp / "set";
    options.maps = {Map::color, Map::rank};
    options.rank_terms = terms;
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    const auto levels = read_levels(temp / "set" / "test.rank.exr");

    const Truth truth = brute_force(given.statistics_input(), terms);
    std::vector<double> errors;
    for (size_t l = 0; l < levels.size(); ++l) {
        double worst = 0;
        for (int y = 0; y < levels[l].height; ++y)
            for (int x = 0; x < levels[l].width; ++x)
                for (int c = 0; truth.levels[l].at(x, y).coverage > 0 && c < 3; ++c)
                    for (int n = 0; n < terms; ++n) {
                        const double expected =
                            truth.levels[l].at(x, y).rank[static_cast<size_t>(n)]
                                                         [static_cast<size_t>(c)];
                        const float stored = levels[l].at(x, y, (2 - c) * terms + n);
                        worst = std::max(worst, std::abs(static_cast<double>(stored) - expected));
                    }
        errors.push_back(worst);
    }
    return errors;
}

TEST(RankTable, IsExactForFootprintsUpTo64By64OfAnySize)
{
    for (const auto& [width, height] : {std::pair(64, 64), std::pair(1, 1), std::pair(63, 65),
                                        std::pair(37, 1), std::pair(7, 90)})
        for (const bool holes : {false, true}) {
            const OracleCase c = holes && width * height > 40 ? holes_case(width, height, 5)
                                                              : random_case(width, height, 6);
            const auto errors = errors_of(c.source(), 4);
            for (size_t l = 0; l < std::min<size_t>(errors.size(), kExactLevels + 1); ++l)
                EXPECT_LT(errors[l], 2e-6)
                    << width << "x" << height << (holes ? " with holes" : "") << " level " << l;
        }
}

TEST(RankTable, FewHeightsStayExactAtEveryLevel)
{
    // 256 x 128 texels of 40 heights: summaries have more room than that.
    OracleCase c = random_case(256, 128, 3);
    for (double& h : c.input.relief.heights)
        h = std::floor(h * 10) / 10;
    const auto errors = errors_of(c.source(), 8);
    for (size_t l = 0; l < errors.size(); ++l)
        EXPECT_LT(errors[l], 5e-6) << "level " << l;
}

TEST(RankTable, SummariesCostLittleAbove64By64)
{
    // Of 512 atoms, merged twice or three times, measured on two surfaces.
    for (const std::string kind : {"fractal", "bricks"}) {
        const auto field = make_sample(kind, 512, 256);
        const auto errors = errors_of(sample_source(*field, 512, 256), 4);
        double worst = 0;
        for (size_t l = kExactLevels + 1; l < errors.size(); ++l)
            worst = std::max(worst, errors[l]);
        RecordProperty(kind, std::to_string(worst));
        EXPECT_LT(worst, 1e-4) << kind;
    }
}

TEST(RankTable, TheStorageErrorIsThatOfItsCoefficients)
{
    // Floats, held against the same numbers in the same channels: red, green and blue differ.
    TempFolder temp;
    OracleCase c = random_case(64, 64, 12);
    MemorySource source = c.source();
    c.options.output = temp / "set";
    c.options.maps = {Map::rank};
    Manifest manifest;
    manifest.name = "test";
    const TextureRecord rank = bake(source, c.options, manifest).textures.front();
    EXPECT_LT(*rank.float_error, 1e-6);
    EXPECT_GT(*rank.half_error, 100 * *rank.float_error);
    EXPECT_LT(*rank.half_error, 1e-2);
}

TEST(RankTable, BytesDoNotDependOnTheNumberOfThreads)
{
    std::string first;
    for (const int threads : {1, 2, 5}) {
        TempFolder temp;
        OracleCase c = holes_case(700, 333, 30);
        MemorySource source = c.source();
        c.options.output = temp / "set";
        c.options.maps = {Map::rank};
        c.options.threads = threads;
        Manifest manifest;
        manifest.name = "test";
        bake(source, c.options, manifest);
        const std::string bytes = read_bytes(temp / "set" / "test.rank.exr");
        if (first.empty())
            first = bytes;
        EXPECT_TRUE(bytes == first) << threads << " threads";
    }
}

} // namespace
} // namespace scree::test
