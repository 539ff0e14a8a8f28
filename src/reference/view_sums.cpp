#include "reference/view_sums.h"

namespace scree::reference {
namespace {

constexpr double kInversePi = 0.31830988618379067154;

void add_to(Rgb& sum, const Rgb& other)
{
    for (size_t c = 0; c < 3; ++c)
        sum[c] += other[c];
}

Rgb divided(const Rgb& sum, double by) { return {sum[0] / by, sum[1] / by, sum[2] / by}; }

} // namespace

void SlopeSums::add(double weight, const Vec2& mean, const std::array<double, 3>& about)
{
    if (!(weight > 0))
        return;
    const double total = weight_ + weight;
    const Vec2 away = mean - mean_;
    const double between = weight_ * weight / total;
    mean_ += away * (weight / total);
    about_[0] += about[0] + between * away.x * away.x;
    about_[1] += about[1] + between * away.x * away.y;
    about_[2] += about[2] + between * away.y * away.y;
    weight_ = total;
}

void SlopeSums::add(double weight, const Vec2& slope) { add(weight, slope, {}); }

void SlopeSums::add(const SlopeSums& other) { add(other.weight_, other.mean_, other.about_); }

std::array<double, 3> SlopeSums::covariance() const
{
    if (!(weight_ > 0))
        return {};
    return {about_[0] / weight_, about_[1] / weight_, about_[2] / weight_};
}

void SeenSums::add(const SeenSums& other)
{
    facing += other.facing;
    area += other.area;
    add_to(color, other.color);
    slopes.add(other.slopes);
}

Seen SeenSums::mean(double weight) const
{
    Seen seen;
    if (weight > 0) {
        seen.facing = facing / weight;
        seen.area = area / weight;
    }
    if (area > 0) {
        seen.color = divided(color, area);
        seen.slope = slopes.mean();
        seen.covariance = slopes.covariance();
    }
    return seen;
}

void LitSums::add(const LitSums& other)
{
    open += other.open;
    add_to(color, other.color);
    add_to(diffuse, other.diffuse);
    white += other.white;
    specular += other.specular;
}

Lit LitSums::mean(double area) const
{
    Lit lit;
    if (!(area > 0))
        return lit;
    lit.share = open / area;
    if (open > 0)
        lit.color = divided(color, open);
    lit.diffuse = divided(diffuse, area / kInversePi);
    lit.white = white / (area / kInversePi);
    lit.specular = specular / area;
    return lit;
}

void GatherSums::add(const GatherSums& other)
{
    weight += other.weight;
    for (size_t i = 0; i < seen.size(); ++i)
        seen[i].add(other.seen[i]);
    for (size_t i = 0; i < lit.size(); ++i)
        lit[i].add(other.lit[i]);
}

Gathered GatherSums::mean() const
{
    Gathered mean;
    for (const SeenSums& sums : seen)
        mean.seen.push_back(sums.mean(weight));
    for (size_t i = 0; i < lit.size(); ++i)
        mean.lit.push_back(lit[i].mean(seen[i / (lit.size() / seen.size())].area));
    return mean;
}

} // namespace scree::reference
