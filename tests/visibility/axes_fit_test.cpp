// Tables along axes: what a fit finds again.

#include "visibility/axes_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "visibility/memory_heights.h"
#include "visibility/view_components.h"

namespace scree::test {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

VisibilityPlan plan_along(double axis_deg)
{
    VisibilityPlan plan{{50, 70, 84}, 0, 8};
    plan.axes = true;
    plan.axis_deg = axis_deg;
    return plan;
}

double told(const std::vector<TableShare>& shares, const std::vector<double>& table)
{
    double sum = 0;
    for (const TableShare& share : shares)
        sum += share.weight * table[static_cast<size_t>(share.component)];
    return sum;
}

/// The views that a fit samples.
std::vector<ViewAngles> sampled(const VisibilityPlan& plan, const AxesFit& fit)
{
    std::vector<ViewAngles> views;
    for (const double angle : fit.angles_deg())
        for (int j = 0; j < plan.azimuths; ++j)
            views.push_back({angle, swept_azimuth_deg(plan, j)});
    return views;
}

/// (A^T A + r)^-1 A^T V.
std::vector<double> fitted(const VisibilityPlan& plan, const std::vector<double>& seen)
{
    const AxesFit fit(plan);
    const auto views = sampled(plan, fit);
    const auto n = static_cast<size_t>(plan.components());
    std::vector<double> sums(n), table(n);
    for (size_t i = 0; i < views.size(); ++i)
        for (const TableShare& share : fit.shares(views[i]))
            sums[static_cast<size_t>(share.component)] += share.weight * seen[i];
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j)
            table[i] += static_cast<double>(fit.inverse()[i * n + j]) * sums[j];
    return table;
}

// At a node's angle straight along an axis f = g(x_k) + a(x_k); at 45 degrees both axes count by
// tan theta / sqrt 2, between nodes.
TEST(AxesFit, SharesAreThoseOfTheNodesAroundTheTangents)
{
    const VisibilityPlan plan = plan_along(20);
    const AxesFit fit(plan);
    std::vector<double> table(15);
    for (size_t i = 0; i < 15; ++i)
        table[i] = static_cast<double>(i) + 1;
    EXPECT_NEAR(told(fit.shares({70, 20}), table), 6 + 8, 1e-12);
    EXPECT_NEAR(told(fit.shares({70, 200}), table), 6 + 7, 1e-12);
    EXPECT_NEAR(told(fit.shares({70, 110}), table), 6 + 10, 1e-12);
    EXPECT_NEAR(told(fit.shares({70, -70}), table), 6 + 9, 1e-12);
    EXPECT_NEAR(told(fit.shares({89, 20}), table), 11 + 13, 1e-12) << "beyond the last node";
    const double first = std::tan(50 * kRadian), second = std::tan(70 * kRadian);
    const double part = (second / std::sqrt(2.0) - first) / (second - first);
    EXPECT_NEAR(told(fit.shares({70, 65}), table), 6 + (3 + 5 * part) + (5 + 5 * part), 1e-9);
    EXPECT_NEAR(told(fit.shares({1, 20}), table), std::tan(1 * kRadian) / first * (1 + 3), 1e-12);
}

// What a ridge of r leaves of a least square: A^T (V - A x) = r x, whatever V is.
TEST(AxesFit, IsALeastSquareWithARidge)
{
    const VisibilityPlan plan = plan_along(-33);
    const AxesFit fit(plan);
    const auto views = sampled(plan, fit);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> seen(views.size());
    for (double& value : seen)
        value = number(random);
    const auto table = fitted(plan, seen);
    std::vector<double> rest(table.size());
    for (size_t i = 0; i < views.size(); ++i) {
        const auto shares = fit.shares(views[i]);
        for (const TableShare& share : shares)
            rest[static_cast<size_t>(share.component)] +=
                share.weight * (seen[i] - told(shares, table));
    }
    for (size_t i = 0; i < table.size(); ++i)
        EXPECT_NEAR(rest[i], 0.01 * table[i], 2e-5) << i; // the inverse is in floats
}

/// A groove along y of a turned frame hides by p_x alone: nothing up to a tangent of 1, then what
/// is beyond.
TEST(AxesFit, TellsAWallThatHidesFromATangentOn)
{
    const VisibilityPlan plan = plan_along(20);
    const AxesFit fit(plan);
    const auto groove = [&](const ViewAngles& view) {
        const double x =
            std::tan(view.angle_deg * kRadian) * std::cos((view.azimuth_deg - 20) * kRadian);
        const double nodes[] = {std::tan(50 * kRadian), std::tan(70 * kRadian)};
        return -0.1 * std::max(std::abs(x) - nodes[0], 0.0) +
               0.1 * std::max(std::abs(x) - nodes[1], 0.0);
    };
    std::vector<double> seen;
    for (const ViewAngles& view : sampled(plan, fit))
        seen.push_back(groove(view));
    const auto table = fitted(plan, seen);
    for (double angle = 30; angle < 84; angle += 3)
        for (double azimuth = 0; azimuth < 360; azimuth += 11)
            EXPECT_NEAR(told(fit.shares({angle, azimuth}), table), groove({angle, azimuth}), 0.004)
                << angle << ' ' << azimuth; // of up to 0.16; the ridge
}

TEST(ViewComponents, AlongAxesAreTheFitOfSweeps)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(0, 0.6F);
    HeightGrid::Shape shape;
    shape.width = shape.height = 24;
    std::vector<float> heights(24 * 24);
    for (float& height : heights)
        height = number(random);
    const MemoryHeights grid(shape, heights);
    const VisibilityPlan plan = plan_along(10);
    const TexelBlock block{3, 5, 9, 10};
    // A table of harmonics before it and a view behind it keep out of its way.
    const ViewComponents components({VisibilityPlan{{60}, 1, 4}, plan}, {{65, 40}});
    ASSERT_EQ(components.count(), 3 + 15 + 1);
    std::vector<std::vector<float>> planes(19, std::vector<float>(90));
    std::vector<float*> pointers;
    for (auto& plane : planes)
        pointers.push_back(plane.data());
    components.see(grid, block, pointers.data());

    const AxesFit fit(plan);
    std::vector<std::vector<double>> seen;
    for (const ViewAngles& view : sampled(plan, fit)) {
        std::vector<float> visible(90);
        float* pointer = visible.data();
        sweep(grid, block, view.azimuth_deg * kRadian, {1 / std::tan(view.angle_deg * kRadian)},
              &pointer);
        seen.emplace_back(visible.begin(), visible.end());
    }
    for (size_t texel = 0; texel < 90; texel += 7) {
        std::vector<double> of_texel;
        for (const auto& view : seen)
            of_texel.push_back(view[texel] - 1);
        const auto table = fitted(plan, of_texel);
        for (size_t i = 0; i < table.size(); ++i)
            EXPECT_NEAR(static_cast<double>(planes[3 + i][texel]), table[i], 2e-3) << i;
    }
}

} // namespace
} // namespace scree::test
