// Labels keep clear of each other, of markers and of the edge.

#include "report/labels.h"

#include <gtest/gtest.h>

#include <optional>
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

/// How many leaders go over a label that is not theirs, by points along them.
int leaders_over_labels(const std::vector<Spot>& points,
                        const std::vector<std::optional<Box>>& boxes)
{
    int over = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        if (!boxes[i])
            continue;
        const Spot from = points[i], to = nearest_in(*boxes[i], from);
        bool meets = false;
        for (size_t j = 0; j < points.size(); ++j)
            for (double share = 0; share <= 1 && j != i && boxes[j]; share += 1.0 / 64) {
                const Spot at = {from.x + share * (to.x - from.x),
                                 from.y + share * (to.y - from.y)};
                meets = meets || meet(*boxes[j], {at.x, at.y, at.x, at.y});
            }
        over += meets ? 1 : 0;
    }
    return over;
}

TEST(Labels, LeadersOfACrowdGoRoundItsLabels)
{
    // The methods of a chart of bricks: two crowds, as wide as two markers, with all room around.
    const std::vector<Spot> points = {{87, 98},     {89.4, 101},  {90.3, 103},  {91.4, 104},
                                      {160, 130},   {189, 119},   {182.5, 137}, {192, 137},
                                      {186, 138},   {184.4, 138}, {184.4, 138}, {185.1, 138},
                                      {194.9, 138}, {200, 141}};
    const std::vector<double> widths = {53, 41, 41, 30, 36, 74, 30, 74, 36, 36, 36, 36, 79, 117};
    std::vector<LabelWish> wishes;
    for (size_t i = 0; i < points.size(); ++i)
        wishes.push_back({points[i], widths[i], 14});
    const auto boxes = place_labels(wishes, points, kRadius, {}, kFrame);
    for (const auto& box : boxes)
        EXPECT_TRUE(box);
    EXPECT_EQ(leaders_over_labels(points, boxes), 0);
}

TEST(Labels, WithoutRoomThereIsNone)
{
    const auto boxes = place_labels({{{200, 150}, 500, 14}}, {{200, 150}}, kRadius, {}, kFrame);
    EXPECT_FALSE(boxes.at(0));
}

} // namespace
} // namespace scree::report
