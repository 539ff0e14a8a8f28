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
    double cost = 0; ///< whatever the other labels do
};

/// The box of a wish whose nearest edge or corner lies `gap` from the point in a direction.
Box box_beside(const LabelWish& wish, double gap, int dx, int dy)
{
    // A diagonal label starts over the point's corner, not a full gap away in both axes.
    const double reach = dx != 0 && dy != 0 ? 0.7 * gap : gap;
    const double x = wish.point.x + dx * reach + (dx - 1) * wish.width / 2;
    const double y = wish.point.y + dy * reach + (dy - 1) * wish.height / 2;
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
        struct Direction {
            int dx, dy;
            double cost;
        };
        // Right and above are where a reader looks first.
        constexpr std::array<Direction, 8> kDirections = {{{1, 0, 0},
                                                           {1, -1, 1},
                                                           {0, -1, 2},
                                                           {-1, 0, 3},
                                                           {1, 1, 3},
                                                           {0, 1, 4},
                                                           {-1, -1, 4},
                                                           {-1, 1, 5}}};
        constexpr std::array<double, 5> kGaps = {3, 10, 20, 34, 50}; // from the marker's edge
        constexpr double kDistanceCost = 8;
        std::vector<Candidate> found;
        for (const double gap : kGaps)
            for (const auto& d : kDirections) {
                const Box box = box_beside(wish, radius_ + gap, d.dx, d.dy);
                const double cost =
                    standing_cost(wish.point, box) + d.cost + kDistanceCost * (gap - kGaps[0]);
                if (cost < kImpossible)
                    found.push_back({box, cost});
            }
        return found;
    }

    /// For covering what never moves: markers and the frame's edge not at all, strokes by length;
    /// and for other markers on the way from the point to its label.
    [[nodiscard]] double standing_cost(const Spot& point, const Box& box) const
    {
        constexpr double kCovering = 6, kPassing = 10; // a pixel
        if (box.x0 < frame_.x0 || box.y0 < frame_.y0 || box.x1 > frame_.x1 || box.y1 > frame_.y1)
            return kImpossible;
        const Stroke leader = {point, nearest_in(box, point)};
        double cost = 0;
        for (const auto& p : points_) {
            const Box marker = {p.x - radius_, p.y - radius_, p.x + radius_, p.y + radius_};
            if (overlap(box, marker) > 0)
                return kImpossible;
            if (p.x != point.x || p.y != point.y)
                cost += kPassing * length_inside(leader, marker);
        }
        for (const auto& stroke : strokes_)
            cost += kCovering * length_inside(stroke, box);
        return cost;
    }

    [[nodiscard]] bool is_free(size_t label, const Box& box) const
    {
        for (size_t i = 0; i < chosen_.size(); ++i)
            if (i != label && chosen_[i] != nullptr && overlap(box, chosen_[i]->box) > 0)
                return false;
        return true;
    }

    /// Takes the cheapest free candidate; whether that is another than before.
    bool choose(size_t label)
    {
        const Candidate* best = nullptr;
        for (const auto& candidate : candidates_[label])
            if ((best == nullptr || candidate.cost < best->cost) && is_free(label, candidate.box))
                best = &candidate;
        const bool moved = best != chosen_[label];
        chosen_[label] = best;
        return moved;
    }

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
