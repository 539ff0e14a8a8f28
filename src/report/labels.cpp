#include "report/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scree::report {

namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();

double overlap(const Box& a, const Box& b)
{
    const double w = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
    const double h = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
    return w > 0 && h > 0 ? w * h : 0;
}

/// Length of a stroke inside a box (Liang and Barsky 1984).
double length_inside(const Stroke& stroke, const Box& box)
{
    const double dx = stroke.to.x - stroke.from.x, dy = stroke.to.y - stroke.from.y;
    double enters = 0, leaves = 1;
    const std::array<std::array<double, 2>, 4> sides = {{{-dx, stroke.from.x - box.x0},
                                                         {dx, box.x1 - stroke.from.x},
                                                         {-dy, stroke.from.y - box.y0},
                                                         {dy, box.y1 - stroke.from.y}}};
    for (const auto& [towards, room] : sides) {
        if (towards == 0 && room < 0)
            return 0;
        if (towards < 0)
            enters = std::max(enters, room / towards);
        if (towards > 0)
            leaves = std::min(leaves, room / towards);
    }
    return leaves > enters ? (leaves - enters) * std::hypot(dx, dy) : 0;
}

struct Candidate {
    Box box;
    Stroke leader;   ///< from the point to the box
    double cost = 0; ///< whatever the other labels do
};

/// Which way from its point a label lies: -1 to 1 along both axes.
struct Direction {
    double dx, dy;
    double cost;
};

// Right and above are where a reader looks first.
constexpr std::array<Direction, 16> kDirections = {{{1, 0, 0},
                                                    {1, -1, 1},
                                                    {0, -1, 2},
                                                    {-1, 0, 3},
                                                    {1, 1, 3},
                                                    {0, 1, 4},
                                                    {-1, -1, 4},
                                                    {-1, 1, 5},
                                                    {1, -0.5, 6},
                                                    {1, 0.5, 6},
                                                    {0.5, -1, 6},
                                                    {0.5, 1, 7},
                                                    {-0.5, -1, 7},
                                                    {-0.5, 1, 7},
                                                    {-1, 0.5, 8},
                                                    {-1, -0.5, 8}}};

/// The box of a wish whose nearest edge or corner lies `gap` from the point in a direction.
Box box_beside(const LabelWish& wish, double gap, const Direction& d)
{
    // A diagonal label starts over the point's corner, not a full gap away in both axes.
    const double reach = d.dx != 0 && d.dy != 0 ? 0.7 * gap : gap;
    const double x = wish.point.x + d.dx * reach + (d.dx - 1) * wish.width / 2;
    const double y = wish.point.y + d.dy * reach + (d.dy - 1) * wish.height / 2;
    return {x, y, x + wish.width, y + wish.height};
}

class Placer {
public:
    Placer(const std::vector<LabelWish>& wishes, const std::vector<Spot>& points, double radius,
           const std::vector<Stroke>& strokes, const Box& frame)
        : points_(points), radius_(radius), strokes_(strokes), frame_(frame)
    {
        for (const auto& wish : wishes)
            candidates_.push_back(candidates_of(wish));
        chosen_.resize(wishes.size());
    }

    std::vector<std::optional<Box>> run()
    {
        constexpr int kSweeps = 12;
        bool moved = true;
        for (int sweep = 0; sweep < kSweeps && moved; ++sweep) {
            moved = false;
            for (size_t i = 0; i < chosen_.size(); ++i)
                moved = choose(i) || moved;
        }
        std::vector<std::optional<Box>> boxes(chosen_.size());
        for (size_t i = 0; i < boxes.size(); ++i)
            if (chosen_[i] != nullptr)
                boxes[i] = chosen_[i]->box;
        return boxes;
    }

private:
    [[nodiscard]] std::vector<Candidate> candidates_of(const LabelWish& wish) const
    {
        constexpr std::array<double, 5> kGaps = {3, 10, 20, 34, 50}; // from the marker's edge
        constexpr double kDistanceCost = 8;
        std::vector<Candidate> found;
        for (const double gap : kGaps)
            for (const Direction& d : kDirections) {
                const Box box = box_beside(wish, radius_ + gap, d);
                const Stroke leader = {wish.point, nearest_in(box, wish.point)};
                const double cost =
                    standing_cost(leader, box) + d.cost + kDistanceCost * (gap - kGaps[0]);
                if (cost < kImpossible)
                    found.push_back({box, leader, cost});
            }
        return found;
    }

    /// For covering what never moves: markers and the frame's edge not at all, strokes by length;
    /// and for other markers on the way from the point to its label.
    [[nodiscard]] double standing_cost(const Stroke& leader, const Box& box) const
    {
        constexpr double kCovering = 6; // a pixel
        if (box.x0 < frame_.x0 || box.y0 < frame_.y0 || box.x1 > frame_.x1 || box.y1 > frame_.y1)
            return kImpossible;
        double cost = 0;
        for (const auto& p : points_) {
            const Box marker = {p.x - radius_, p.y - radius_, p.x + radius_, p.y + radius_};
            if (overlap(box, marker) > 0)
                return kImpossible;
            if (p.x != leader.from.x || p.y != leader.from.y)
                cost += kPassing * length_inside(leader, marker);
        }
        for (const auto& stroke : strokes_)
            cost += kCovering * length_inside(stroke, box);
        return cost;
    }

    /// For leaders that cross labels; labels on each other are impossible.
    [[nodiscard]] double meeting_cost(size_t label, const Candidate& candidate) const
    {
        constexpr double kSpace = 5; // between words in a line
        double cost = 0;
        for (size_t i = 0; i < chosen_.size(); ++i) {
            if (i == label || chosen_[i] == nullptr)
                continue;
            const Box& other = chosen_[i]->box;
            if (overlap({other.x0 - kSpace, other.y0, other.x1 + kSpace, other.y1}, candidate.box) >
                0)
                return kImpossible;
            cost += kPassing * (length_inside(candidate.leader, other) +
                                length_inside(chosen_[i]->leader, candidate.box));
        }
        return cost;
    }

    /// Takes the cheapest candidate; whether that is another than before.
    bool choose(size_t label)
    {
        const Candidate* best = nullptr;
        double least = kImpossible;
        for (const auto& candidate : candidates_[label]) {
            if (candidate.cost >= least)
                continue;
            const double cost = candidate.cost + meeting_cost(label, candidate);
            if (cost < least) {
                least = cost;
                best = &candidate;
            }
        }
        const bool moved = best != chosen_[label];
        chosen_[label] = best;
        return moved;
    }

    /// A pixel of a leader over what is not its own: across a line of text that is dearer than the
    /// farthest place.
    static constexpr double kPassing = 40;

    const std::vector<Spot>& points_;
    double radius_;
    const std::vector<Stroke>& strokes_;
    Box frame_;
    std::vector<std::vector<Candidate>> candidates_;
    std::vector<const Candidate*> chosen_; ///< of each label; null: none
};

} // namespace

Spot nearest_in(const Box& box, const Spot& point)
{
    return {std::clamp(point.x, box.x0, box.x1), std::clamp(point.y, box.y0, box.y1)};
}

std::vector<std::optional<Box>> place_labels(const std::vector<LabelWish>& wishes,
                                             const std::vector<Spot>& points, double radius,
                                             const std::vector<Stroke>& strokes, const Box& frame)
{
    return Placer(wishes, points, radius, strokes, frame).run();
}

} // namespace scree::report
