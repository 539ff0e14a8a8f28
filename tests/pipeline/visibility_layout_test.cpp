// How tables of visibility are laid out over a surface: where nodes and axes lie.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "judge/original.h"
#include "judge/set_reader.h"
#include "judge/shading.h"
#include "judge/view_check.h"
#include "reference/gather.h"
#include "support/files.h"
#include "support/memory_bake.h"
#include "visibility/memory_heights.h"
#include "visibility/slope_survey.h"

namespace scree::test {
namespace {

constexpr int kSize = 64;
constexpr double kRadian = 3.14159265358979323846 / 180;

/// Long walls 30 degrees off the map's axes, every 10 texels, their tops bright.
MemorySource walls(double height = 1.5)
{
    MemorySource source;
    source.map_width = source.map_height = kSize;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            // 3 and 5 periods a map: an angle of atan(5 / 3) = 59.04, -30.96 degrees from the other
            const double phase = (3.0 * x + 5.0 * y) / kSize;
            const double high =
                std::clamp(3 * std::sin(2 * 3.14159265358979323846 * phase), -1.0, 1.0);
            source.heights.push_back(height * high);
            source.colors.push_back({0.5 + 0.4 * high, 0.5, 0.3});
        }
    return source;
}

/// Rms error of the visible color of the whole map against the reference, at angles and azimuths
/// that were not swept.
double error_of(MemorySource source, const BakeOptions& options)
{
    TempFolder temp;
    bake_memory(temp / "set", source, options);
    SetReader set(temp / "set");
    const int last = static_cast<int>(set.manifest().levels.size()) - 1;
    const SetTexel texel = set.row(last, 0).front();
    reference::GatherPlan plan;
    for (const double angle : {50.0, 68.0, 76.0, 79.0, 82.0, 85.0})
        for (int j = 0; j < 12; ++j)
            plan.views.push_back(direction(angle, 30 * j + 7));
    plan.grid = 96;
    const reference::DisplacedSurface surface(read_original(source, options, {}).relief);
    const auto truth = gather(surface, reference::footprint_of(kSize, kSize, last, 0, 0), plan, 0);
    double sum = 0;
    for (size_t i = 0; i < plan.views.size(); ++i) {
        const Rgbf color =
            visible_color(texel, set.colors(), ColorModel::visible, Vec3f(plan.views[i]));
        for (size_t c = 0; c < 3; ++c)
            sum += std::pow(static_cast<double>(color[c]) - truth.all.seen[i].color[c], 2);
    }
    return std::sqrt(sum / (3 * static_cast<double>(plan.views.size())));
}

TEST(VisibilityLayout, AlongAxesTellsWallsBetterThanTwoHarmonics)
{
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.table.harmonics = 2;
    options.texel_size = {1, 1};
    const double harmonics = error_of(walls(), options);
    options.table.harmonics = 0;
    options.table.axes = true;
    const double axes = error_of(walls(), options);
    RecordProperty("harmonics", testing::PrintToString(harmonics));
    RecordProperty("axes", testing::PrintToString(axes));
    EXPECT_LT(axes, harmonics / 2);
    EXPECT_GT(harmonics, 0.01) << "nothing to tell";
}

TEST(VisibilityLayout, AxesLieWhereTheWallsDoOrWhereTheUserHasThem)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.table.axes = true;
    Manifest m = bake_memory(temp / "set", walls(), options);
    ASSERT_TRUE(m.visibility && m.visibility->axis_deg);
    EXPECT_NEAR(*m.visibility->axis_deg, -30.96, 0.5);
    EXPECT_EQ(read_levels(temp / "set" / "test.visible.exr")[0].channels,
              visible_channels_along_axes(kDefaultNodes));
    options.axis_deg = 12;
    m = bake_memory(temp / "set", walls(), options);
    EXPECT_EQ(*m.visibility->axis_deg, 12);
}

TEST(VisibilityLayout, AutoTakesAxesForWalls)
{
    TempFolder temp;
    BakeOptions options;
    options.auto_maps = true;
    options.table.harmonics = 2;
    options.model_tolerance = 1e-3;
    const Manifest m = bake_memory(temp / "set", walls(), options);
    double axes = -1, harmonics = -1;
    for (const ModelRecord& model : m.model_choice->models) {
        if (model.model == "visible 4 axes") {
            axes = model.error;
            EXPECT_TRUE(model.chosen);
        }
        if (model.model == "visible 4x5")
            harmonics = model.error;
    }
    EXPECT_GT(axes, 0);
    EXPECT_GT(harmonics, axes);
    ASSERT_TRUE(m.visibility && m.visibility->axis_deg);
    EXPECT_EQ(read_levels(temp / "set" / "test.visible.exr")[0].channels,
              visible_channels_along_axes(kDefaultNodes));
}

// Walls a tenth as high hide nothing before 75 degrees.
TEST(VisibilityLayout, NodesGoToWhereTheSurfaceBeginsToHide)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.texel_size = {1, 1};
    const auto nodes_of = [&](double height) {
        return bake_memory(temp / "set", walls(height), options).visibility->node_angles_deg;
    };
    EXPECT_EQ(nodes_of(1.5), best_node_angles(kDefaultNodes));
    const auto low = nodes_of(0.15);
    const MemorySource source = walls(0.15);
    HeightGrid::Shape shape;
    shape.width = shape.height = kSize;
    const MemoryHeights heights(shape, {source.heights.begin(), source.heights.end()});
    EXPECT_EQ(low,
              moved_node_angles(best_node_angles(kDefaultNodes), survey_slopes(heights).steepness));
    EXPECT_GT(low[0], 75);
    EXPECT_EQ(low.back(), 87);
    const auto file = OIIO::ImageInput::open((temp / "set" / "test.visible.exr").string());
    EXPECT_NEAR(file->spec().get_float_attribute("scree:nodeCosine1"), std::cos(low[0] * kRadian),
                1e-6);

    options.table.axes = true;
    const double moved = error_of(walls(0.15), options);
    options.move_nodes = false;
    EXPECT_EQ(nodes_of(0.15), best_node_angles(kDefaultNodes));
    const double unmoved = error_of(walls(0.15), options);
    RecordProperty("moved", testing::PrintToString(moved));
    RecordProperty("unmoved", testing::PrintToString(unmoved));
    EXPECT_LT(moved, 0.9 * unmoved);
}

} // namespace
} // namespace scree::test
