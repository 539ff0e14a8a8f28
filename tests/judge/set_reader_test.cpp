#include "judge/set_reader.h"

#include <gtest/gtest.h>

#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

void bake_bricks(const TempFolder& temp, Layout layout, int rank_terms = 3)
{
    const auto field = make_sample("bricks", 70, 66);
    MemorySource source = sample_source(*field, 70, 66);
    BakeOptions options;
    options.output = temp / "set";
    options.layout = layout;
    options.rank_terms = rank_terms;
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
}

TEST(SetReader, PutsEveryChannelWhereItBelongs)
{
    const TempFolder temp;
    bake_bricks(temp, Layout::scree);
    SetReader set(temp / "set");
    EXPECT_EQ(set.colors().best(), ColorModel::rank);
    EXPECT_TRUE(set.colors().has_slope);
    auto levels = [&temp](const char* map) {
        return read_levels(temp / "set" / (std::string("test.") + map + ".exr"));
    };
    const auto slope = levels("slope"), height = levels("height"), color = levels("color"),
               colorheight = levels("colorheight"), colorslope = levels("colorslope"),
               rank = levels("rank"), tail = levels("tail");
    for (const size_t level : {size_t{0}, size_t{1}, slope.size() - 1}) {
        const int y = slope[level].height - 1, x = slope[level].width / 2;
        const SetTexel texel = set.row(static_cast<int>(level), y)[static_cast<size_t>(x)];
        EXPECT_EQ(texel.slope.s, slope[level].at(x, y, 0));
        EXPECT_EQ(texel.slope.ss, slope[level].at(x, y, 1));
        EXPECT_EQ(texel.slope.st, slope[level].at(x, y, 2));
        EXPECT_EQ(texel.slope.t, slope[level].at(x, y, 3));
        EXPECT_EQ(texel.slope.tt, slope[level].at(x, y, 4));
        EXPECT_EQ(texel.h, height[level].at(x, y, 0));
        EXPECT_EQ(texel.hh, height[level].at(x, y, 1));
        EXPECT_EQ(texel.tau, tail[level].at(x, y, 0));
        EXPECT_EQ(texel.coverage, 1);
        for (int i = 0; i < 3; ++i) {
            const auto rgb = static_cast<size_t>(i);
            EXPECT_EQ(texel.color[rgb], color[level].at(x, y, i));
            EXPECT_EQ(texel.color_height[rgb], colorheight[level].at(x, y, i));
            // Bs Bt Gs Gt Rs Rt and B1 B2 B3 G1 ... in their files.
            EXPECT_EQ(texel.color_s[rgb], colorslope[level].at(x, y, 2 * (2 - i)));
            EXPECT_EQ(texel.color_t[rgb], colorslope[level].at(x, y, 2 * (2 - i) + 1));
            for (int n = 0; n < 3; ++n)
                EXPECT_EQ(texel.rank[static_cast<size_t>(n)][rgb],
                          rank[level].at(x, y, 3 * (2 - i) + n));
            EXPECT_EQ(texel.rank[3][rgb], 0);
        }
    }
}

/// The sample with what was measured of views, three nodes and a harmonic.
Manifest bake_measured(const TempFolder& temp, const std::vector<Map>& maps)
{
    const auto field = make_sample("bricks", 40, 36);
    MemorySource source = sample_source(*field, 40, 36);
    BakeOptions options;
    options.output = temp / "set";
    options.maps = maps;
    options.table = {{50, 70, 85}, 1, 8};
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    return bake(source, options, manifest);
}

const std::vector<Map> kMeasured = {Map::slope,    Map::height, Map::color,  Map::colorheight,
                                    Map::exponent, Map::rank,   Map::visible};

TEST(SetReader, PutsTablesOfVisibilityWhereTheyBelong)
{
    const TempFolder temp;
    bake_measured(temp, kMeasured);
    SetReader set(temp / "set");
    const SetColors& colors = set.colors();
    EXPECT_EQ(colors.models,
              (std::vector<ColorModel>{ColorModel::mean, ColorModel::height, ColorModel::rank,
                                       ColorModel::exponent, ColorModel::visible}));
    EXPECT_EQ(colors.best(), ColorModel::visible);
    ASSERT_EQ(colors.node_cosines.size(), 3U);
    EXPECT_NEAR(colors.node_cosines[0], 0.64278761, 1e-7);
    EXPECT_NEAR(colors.node_cosines[1], 0.34202014, 1e-7);
    EXPECT_NEAR(colors.node_cosines[2], 0.08715574, 1e-7);
    EXPECT_EQ(colors.harmonics, 1);
    const auto visible = read_levels(temp / "set" / "test.visible.exr");
    const auto exponent = read_levels(temp / "set" / "test.exponent.exr");
    for (const size_t level : {size_t{1}, size_t{2}, visible.size() - 1}) {
        const int y = visible[level].height - 1, x = visible[level].width / 2;
        const SetTexel texel = set.row(static_cast<int>(level), y)[static_cast<size_t>(x)];
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(texel.exponent[static_cast<size_t>(i)], exponent[level].at(x, y, i));
        for (int i = 0; i < 3 * 3 * 4; ++i)
            EXPECT_EQ(texel.visible[static_cast<size_t>(i)], visible[level].at(x, y, i)) << i;
        EXPECT_EQ(texel.visible[3 * 3 * 4], 0);
        EXPECT_NE(texel.visible[0], 0) << "a view that sees all";
    }
}

TEST(SetReader, TakesTheMeasuredExponentOverSmiths)
{
    const TempFolder temp;
    bake_measured(temp, {Map::slope, Map::height, Map::color, Map::colorheight, Map::exponent});
    EXPECT_EQ(SetReader(temp / "set").colors().best(), ColorModel::exponent);
}

TEST(SetReader, RefusesTablesThatTheManifestTellsOtherwise)
{
    const TempFolder temp;
    Manifest manifest = bake_measured(temp, kMeasured);
    for (const std::optional<VisibilityRecord>& wrong :
         {std::optional<VisibilityRecord>(), std::optional(VisibilityRecord{{50, 70}, 1, 8, {}}),
          std::optional(VisibilityRecord{{50, 70, 85}, 0, 8, {}}),
          std::optional(VisibilityRecord{{50, 70, 85}, -1, 8, {}}),
          std::optional(VisibilityRecord{{50, 70, 85}, 0, 8, 30.0}),
          std::optional(VisibilityRecord{{50, 85, 70}, 1, 8, {}})}) {
        manifest.visibility = wrong;
        write_manifest(manifest, temp / "set");
        try {
            SetReader set(temp / "set");
            ADD_FAILURE();
        } catch (const Error& e) {
            const std::string said = e.what();
            EXPECT_TRUE(said.find("test.visible.exr: has other nodes or terms") != said.npos ||
                        said.find("test.visible.exr: nodes at 50, 85, 70 degrees") != said.npos)
                << said;
        }
    }
}

TEST(SetReader, ReadsTheSlopesOfTheBumpslopesLayout)
{
    const TempFolder plain, bump;
    bake_bricks(plain, Layout::scree);
    bake_bricks(bump, Layout::bumpslopes);
    SetReader set(plain / "set"), as_maketx(bump / "set");
    const auto a = set.row(1, 5), b = as_maketx.row(1, 5);
    for (size_t x = 0; x < a.size(); ++x) {
        EXPECT_EQ(a[x].slope.s, b[x].slope.s);
        EXPECT_EQ(a[x].slope.ss, b[x].slope.ss);
        EXPECT_EQ(a[x].slope.st, b[x].slope.st);
        EXPECT_EQ(a[x].slope.t, b[x].slope.t);
        EXPECT_EQ(a[x].slope.tt, b[x].slope.tt);
    }
}

TEST(SetReader, NamesTheTextureThatIsMissingOrAnothers)
{
    const TempFolder temp;
    bake_bricks(temp, Layout::scree, 3);
    const TempFolder other;
    bake_bricks(other, Layout::scree, 2);
    auto error = [&temp] {
        try {
            SetReader set(temp / "set");
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    std::filesystem::copy_file(other / "set" / "test.rank.exr", temp / "set" / "test.rank.exr",
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_NE(error().find("test.rank.exr: has other channels"), std::string::npos);
    std::filesystem::remove(temp / "set" / "test.rank.exr");
    EXPECT_NE(error().find("test.rank.exr"), std::string::npos);
}

} // namespace
} // namespace scree::test
