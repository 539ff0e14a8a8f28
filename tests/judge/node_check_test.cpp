// Tables of visibility against the reference.

#include "judge/node_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/original.h"
#include "judge/validation.h"
#include "pipeline/bake.h"
#include "support/files.h"
#include "support/memory_source.h"

namespace scree::test {
namespace {

/// A set with tables, baked from a surface of texels of one unit.
struct Baked {
    TempFolder temp;
    MemorySource source;
    BakeOptions options;
    Manifest manifest;

    explicit Baked(MemorySource surface, Wrap wrap = Wrap::periodic, bool axes = false)
        : source(std::move(surface))
    {
        options.output = temp / "set";
        options.texel_size = {1, 1};
        options.wrap_s = options.wrap_t = wrap;
        options.pixel_type = PixelTypeChoice::float32;
        options.maps = {Map::slope, Map::color, Map::visible};
        options.table = {{60, 78}, axes ? 0 : 1, 8, axes};
        options.move_nodes = false;
        Manifest start;
        start.name = "test";
        manifest = bake(source, options, start);
    }

    [[nodiscard]] NodeCheck checked(int grid)
    {
        SetReader set(temp / "set");
        ViewPlan plan;
        plan.grid = grid;
        return check_nodes(
            set, reference::DisplacedSurface(read_original(source, options, {}).relief), plan, {});
    }
};

/// Ridges along t, slopes +-0.5, 16 texels apart; red grows with height, green falls.
MemorySource shaded_grooves()
{
    MemorySource source;
    source.map_width = source.map_height = 64;
    for (int i = 0; i < 64 * 64; ++i) {
        const double height = std::abs(i % 16 - 8) / 8.0;
        source.heights.push_back(4 * height);
        source.colors.push_back({0.1 + 0.8 * height, 0.8 - 0.6 * height, 0.3});
    }
    return source;
}

// Of a plane a = -tan(theta) slope . azimuth, whose mean over azimuths is 0: both sides to
// rounding.
TEST(NodeCheck, OnAPlaneTheTablesAreTheReferences)
{
    MemorySource source;
    source.map_width = source.map_height = 32;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            source.heights.push_back(0.125 * x - 0.0625 * y);
            source.colors.push_back({0.25, 0.5, 0.75});
        }
    const NodeCheck check = Baked(source, Wrap::clamp).checked(4);
    ASSERT_EQ(check.all.size(), 2U);
    ASSERT_EQ(check.levels.size(), 2U * 6);
    for (const NodeErrors& errors : check.all) {
        EXPECT_LT(errors.area.set, 1e-5) << errors.angle_deg;
        EXPECT_LT(errors.color.set, 1e-5) << errors.angle_deg;
        EXPECT_EQ(errors.footprints, 16 + 16 + 16 + 4 + 1);
    }
    EXPECT_GT(check.samples, 0);
}

/// Rms of R, G, B that the tables hold at a node of the whole map.
double color_held(const Baked& baked, size_t node)
{
    SetReader set(baked.temp / "set");
    const int top = static_cast<int>(baked.manifest.levels.size()) - 1;
    const SetTexel texel = set.row(top, 0).front();
    double sum = 0;
    for (size_t c = 1; c < 4; ++c)
        sum += std::pow(static_cast<double>(texel.visible[12 * node + c]), 2);
    return std::sqrt(sum / 3);
}

// A groove hides its bottom from 78 degrees: what the tables hold of that is what is seen, channel
// by channel. Footprints of 16 texels, a period, and more.
TEST(NodeCheck, TablesOfGroovesAreWithinTheReferencesNoise)
{
    Baked baked(shaded_grooves());
    const NodeCheck check = baked.checked(64);
    const double mean = std::sqrt((0.5 * 0.5 + 0.5 * 0.5 + 0.3 * 0.3) / 3);
    EXPECT_GT(color_held(baked, 1) / mean, 0.05) << "little is hidden";
    int compared = 0;
    for (const NodeErrors& errors : check.levels) {
        if (errors.level < 4)
            continue;
        ++compared;
        // Of few footprints the noise is itself a matter of chance; the sweep's profiles are exact.
        EXPECT_LT(errors.area.set, 3 * errors.area.noise + 0.004)
            << errors.level << " " << errors.angle_deg;
        EXPECT_LT(errors.color.set, 3 * errors.color.noise + 0.004)
            << errors.level << " " << errors.angle_deg;
        EXPECT_LT(errors.color.set, 0.01);
        if (errors.angle_deg > 60) { // from less nothing is hidden, and both sides balance
            EXPECT_GT(errors.color.noise, 0);
        }
    }
    EXPECT_EQ(compared, 2 * 3);
}

// Along axes the means over the azimuth at the nodes are made of all the numbers.
TEST(NodeCheck, TablesAlongAxesAreJudgedByWhatTheyTell)
{
    Baked baked(shaded_grooves(), Wrap::periodic, true);
    const NodeCheck check = baked.checked(64);
    const NodeErrors& top = check.levels.back();
    EXPECT_EQ(top.angle_deg, 78);
    RecordProperty("color", testing::PrintToString(top.color.set));
    RecordProperty("area", testing::PrintToString(top.area.set));
    // A fit through twice as many angles goes by each of them as near as its lines can.
    EXPECT_LT(top.color.set, 0.005);
    EXPECT_LT(top.area.set, 0.005);
}

// Tables of 60 and 78 degrees are not those of 40 and 60, from where all is seen: the error is what
// they hold.
TEST(NodeCheck, FindsTablesOfOtherNodes)
{
    Baked baked(shaded_grooves());
    const double mean = std::sqrt((0.5 * 0.5 + 0.5 * 0.5 + 0.3 * 0.3) / 3);
    const double held = color_held(baked, 1) / mean;
    baked.manifest.visibility->node_angles_deg = {40, 60};
    write_manifest(baked.manifest, baked.temp / "set");
    const NodeCheck check = baked.checked(32);
    const NodeErrors& top = check.levels.back();
    EXPECT_EQ(top.angle_deg, 60);
    EXPECT_EQ(top.level, 6);
    EXPECT_NEAR(top.color.set, held, 0.1 * held + 3 * top.color.noise);
    EXPECT_LT(check.all[0].color.set, check.all[1].color.set);
}

TEST(NodeCheck, ValidationJudgesThemByTheirTolerance)
{
    Baked baked(shaded_grooves());
    const auto validated = [&baked](std::optional<double> tolerance) {
        SetReader set(baked.temp / "set");
        ValidationPlan plan;
        plan.images = false;
        plan.view.grid = 8;
        plan.view.footprints = 4;
        plan.view.angles_deg = {30};
        plan.tolerances.tables = tolerance;
        return validate(set, read_original(baked.source, baked.options, {}), baked.options, plan,
                        {});
    };
    const Validation plain = validated({});
    ASSERT_TRUE(plain.tables);
    EXPECT_TRUE(plain.exceeded.empty());
    EXPECT_TRUE(validated(10).exceeded.empty());
    const Validation strict = validated(1e-9);
    ASSERT_FALSE(strict.exceeded.empty());
    EXPECT_NE(strict.exceeded.front().find("tables of visibility at"), std::string::npos);

    baked.options.maps = {Map::slope, Map::color};
    Manifest start;
    start.name = "test";
    bake(baked.source, baked.options, start);
    const Validation without = validated(10);
    EXPECT_FALSE(without.tables);
    ASSERT_EQ(without.exceeded.size(), 1U);
    EXPECT_NE(without.exceeded.front().find("not in the set"), std::string::npos);
}

} // namespace
} // namespace scree::test
