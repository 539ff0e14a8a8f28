// NAME.rank.exr against footprints put together texel by texel.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "pipeline/bake.h"
#include "sample/field.h"
#include "stats/pyramid.h"
#include "stats/rank_rows.h"
#include "support/files.h"
#include "support/memory_source.h"
#include "support/oracle_case.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

/// [level][texel][level-0 texel]: share of the level-0 texels in each texel of a level, one axis.
using AxisShares = std::vector<std::vector<std::vector<double>>>;

/// First of the entries that are not 0, and one behind the last.
std::pair<int, int> extent(const std::vector<double>& shares)
{
    auto covers = [](double share) { return share > 0; };
    const auto first = std::find_if(shares.begin(), shares.end(), covers);
    const auto last = std::find_if(shares.rbegin(), shares.rend(), covers);
    return {static_cast<int>(first - shares.begin()), static_cast<int>(shares.rend() - last)};
}

AxisShares axis_shares(int size, size_t levels)
{
    AxisShares shares(1);
    for (int i = 0; i < size; ++i) {
        shares[0].emplace_back(static_cast<size_t>(size), 0.0);
        shares[0].back()[static_cast<size_t>(i)] = 1;
    }
    for (int fine = size; shares.size() < levels; fine = std::max(1, fine / 2)) {
        const int coarse = std::max(1, fine / 2);
        std::vector<std::vector<double>> level;
        for (int j = 0; j < coarse; ++j) {
            // Texel j covers [j fine / coarse, (j + 1) fine / coarse).
            const double begin = static_cast<double>(j) * fine / coarse,
                         end = static_cast<double>(j + 1) * fine / coarse;
            std::vector<double> row(static_cast<size_t>(size), 0.0);
            for (int i = 0; i < fine; ++i) {
                const double overlap = std::min(end, i + 1.0) - std::max(begin, double(i));
                if (overlap > 1e-9)
                    for (size_t k = 0; k < row.size(); ++k)
                        row[k] +=
                            overlap / (end - begin) * shares.back()[static_cast<size_t>(i)][k];
            }
            level.push_back(row);
        }
        shares.push_back(level);
    }
    return shares;
}

struct Group {
    double weight = 0;
    std::array<double, 3> color{}; ///< times weight
};

/// a_1 ... a_terms of one channel by definition: the integral of P_n over each height's ranks.
std::vector<double> coefficients(const std::map<double, Group>& groups, int terms, size_t channel)
{
    auto primitive = [](int n, double x) {
        return (boost::math::legendre_p(n + 1, x) - boost::math::legendre_p(n - 1, x)) /
               (2.0 * n + 1);
    };
    double total = 0, below = 0;
    for (const auto& [height, group] : groups)
        total += group.weight;
    std::vector<double> a(static_cast<size_t>(terms), 0.0);
    for (const auto& [height, group] : groups) {
        const double x0 = 2 * below / total - 1, x1 = 2 * (below + group.weight) / total - 1;
        for (int n = 1; n <= terms; ++n)
            a[static_cast<size_t>(n) - 1] += (2 * n + 1) / 2.0 * group.color[channel] /
                                             group.weight * (primitive(n, x1) - primitive(n, x0));
        below += group.weight;
    }
    return a;
}

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

    const AxisShares columns = axis_shares(source.map_width, levels.size()),
                     rows = axis_shares(source.map_height, levels.size());
    std::vector<double> errors;
    for (size_t l = 0; l < levels.size(); ++l) {
        double worst = 0;
        for (int y = 0; y < levels[l].height; ++y)
            for (int x = 0; x < levels[l].width; ++x) {
                std::map<double, Group> groups;
                const auto& column = columns[l][static_cast<size_t>(x)];
                const auto& row = rows[l][static_cast<size_t>(y)];
                const auto [u0, u1] = extent(column);
                const auto [v0, v1] = extent(row);
                for (int v = v0; v < v1; ++v)
                    for (int u = u0; u < u1; ++u) {
                        const auto i = static_cast<size_t>(v * source.map_width + u);
                        double w = column[static_cast<size_t>(u)] * row[static_cast<size_t>(v)];
                        w *= source.weights.empty() ? 1 : source.weights[i];
                        const auto& color = source.colors[i];
                        if (!(w > 0) ||
                            !std::isfinite(source.heights[i] + color[0] + color[1] + color[2]))
                            continue;
                        Group& group = groups[source.heights[i]];
                        group.weight += w;
                        for (size_t c = 0; c < 3; ++c)
                            group.color[c] += w * color[c];
                    }
                for (size_t c = 0; c < 3; ++c) {
                    const auto expected = coefficients(groups, terms, c);
                    for (int n = 0; n < terms; ++n) {
                        const int channel = (2 - static_cast<int>(c)) * terms + n;
                        worst = std::max(worst,
                                         std::abs(static_cast<double>(levels[l].at(x, y, channel)) -
                                                  expected[static_cast<size_t>(n)]));
                    }
                }
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
    for (double& h : c.input.heights)
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
