// Labels keep clear of each other, of markers and of the edge.

#include "report/labels.h"

#include <gtest/gtest.h>

#include <random>

namespace scree::report {
namespace {

constexpr Box kFrame = {0, 0, 400, 300};
constexpr double kRadius = 6;

bool meet(const Box& a, const Box& b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

Box around(const Spot& p) { return {p.x - kRadius, p.y - kRadius, p.x + kRadius, p.y + kRadius}; }

std::vector<LabelWish> wishes_at(const std::vector<Spot>& points, double width)
{
    std::vector<LabelWish> wishes;
    wishes.reserve(points.size());
    for (const auto& point : points)
        wishes.push_back({point, width, 14});
    return wishes;
}

TEST(Labels, ALonePointHasItsLabelOnItsRight)
{
    const auto boxes = place_labels({{{200, 150}, 60, 14}}, {{200, 150}}, kRadius, {}, kFrame);
    ASSERT_TRUE(boxes.at(0));
    EXPECT_GT(boxes[0]->x0, 206);
    EXPECT_LT(boxes[0]->x0, 212);
    EXPECT_EQ(boxes[0]->x1 - boxes[0]->x0, 60);
    EXPECT_EQ((boxes[0]->y0 + boxes[0]->y1) / 2, 150);
}

TEST(Labels, AtTheEdgeTheyTurnInwards)
{
    for (const Spot corner : {Spot{0, 0}, Spot{400, 0}, Spot{0, 300}, Spot{400, 300}}) {
        const auto boxes = place_labels({{corner, 60, 14}}, {corner}, kRadius, {}, kFrame);
        ASSERT_TRUE(boxes.at(0));
        EXPECT_GE(boxes[0]->x0, 0);
        EXPECT_LE(boxes[0]->x1, 400);
        EXPECT_GE(boxes[0]->y0, 0);
        EXPECT_LE(boxes[0]->y1, 300);
    }
}

TEST(Labels, ALineIsNotWrittenOver)
{
    // Falling to the right, through the point: above and to the right is free.
    const std::vector<Stroke> strokes = {{{200, 150}, {400, 170}}};
    const auto boxes = place_labels({{{200, 150}, 60, 14}}, {{200, 150}}, kRadius, strokes, kFrame);
    ASSERT_TRUE(boxes.at(0));
    EXPECT_LE(boxes[0]->y1, 150 + 20.0 * (boxes[0]->x0 - 200) / 200);
}

TEST(Labels, NoneLiesOnAnotherOrOnAMarkerAndFewAreLost)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(10, 390), y(10, 290);
    int placed = 0, wanted = 0;
    for (int round = 0; round < 20; ++round) {
        std::vector<Spot> points(25);
        for (auto& p : points)
            p = {x(random), y(random)};
        const auto boxes = place_labels(wishes_at(points, 50), points, kRadius, {}, kFrame);
        ASSERT_EQ(boxes.size(), points.size());
        for (size_t i = 0; i < boxes.size(); ++i) {
            ++wanted;
            if (!boxes[i])
                continue;
            ++placed;
            for (const auto& p : points)
                EXPECT_FALSE(meet(*boxes[i], around(p))) << "round " << round << " label " << i;
            for (size_t j = 0; j < i; ++j)
                EXPECT_FALSE(boxes[j] && meet(*boxes[i], *boxes[j]))
                    << "round " << round << " labels " << i << " and " << j;
        }
    }
    // 25 labels of 50 x 14 fill a seventh of the frame: there is room for them.
    EXPECT_GT(placed, 0.98 * wanted);
}

TEST(Labels, WithoutRoomThereIsNone)
{
    const auto boxes = place_labels({{{200, 150}, 500, 14}}, {{200, 150}}, kRadius, {}, kFrame);
    EXPECT_FALSE(boxes.at(0));
}

} // namespace
} // namespace scree::report
