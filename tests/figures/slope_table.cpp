#include "figures/slope_table.h"

#include <algorithm>
#include <cmath>

namespace scree::test {
namespace {

constexpr double kLeastSeen = 0.25; ///< of v, as in the kernel: less is filled up by what is baked

Vec2 azimuth_of(const Vec3& w)
{
    const Vec2 across(w.x, w.y);
    return across.length() > 0 ? across.normalized() : Vec2(1, 0);
}

double tangent(const Vec3& w) { return std::sqrt(w.x * w.x + w.y * w.y) / w.z; }

/// 1, cos phi, sin phi, cos 2 phi, sin 2 phi: as many as there are harmonics.
std::vector<double> waves(const Vec2& azimuth, size_t harmonics)
{
    const double c = azimuth.x, s = azimuth.y;
    const std::vector<double> all = {1, c, s, c * c - s * s, 2 * c * s};
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(1 + 2 * harmonics)};
}

/// Mean and covariance in a frame turned so that x lies along (c, s).
SeenSlopes turned(const SeenSlopes& slopes, const Vec2& along)
{
    const double c = along.x, s = along.y;
    const auto& [ss, st, tt] = slopes.covariance;
    return {{c * slopes.mean.x + s * slopes.mean.y, c * slopes.mean.y - s * slopes.mean.x},
            {c * c * ss + 2 * c * s * st + s * s * tt, (c * c - s * s) * st + c * s * (tt - ss),
             s * s * ss - 2 * c * s * st + c * c * tt}};
}

/// What linear moments leave of a covariance, made one again.
filter::Covariance<double> made_positive(filter::Covariance<double> of)
{
    of.ss = std::max(of.ss, 0.0);
    of.tt = std::max(of.tt, 0.0);
    const double bound = std::sqrt(of.ss * of.tt);
    of.st = std::clamp(of.st, -bound, bound);
    return of;
}

} // namespace

SeenSlopes seen_slopes(const reference::Seen& seen)
{
    return {seen.slope, {seen.covariance[0], seen.covariance[1], seen.covariance[2]}};
}

SlopeTable::Quantities SlopeTable::moments(double v, const SeenSlopes& slopes, double color,
                                           const Vec2& along)
{
    const auto& [m, cov] = turned(slopes, along);
    return {v,
            v * m.x,
            v * m.y,
            v * (cov.ss + m.x * m.x),
            v * (cov.st + m.x * m.y),
            v * (cov.tt + m.y * m.y),
            v * color};
}

SlopeTable::SlopeTable(const SlopeViews& views, const reference::Seen& straight,
                       const std::vector<reference::Seen>& nodes, size_t harmonics, Frame frame)
    : color_(straight.color[1]), frame_(frame)
{
    for (size_t first = 0; first < nodes.size(); first += SlopeViews::kAzimuths) {
        tangents_.push_back(tangent(views.fitted[1 + first]));
        std::vector<Quantities>& terms = terms_.emplace_back(1 + 2 * harmonics);
        for (size_t j = first; j < first + SlopeViews::kAzimuths; ++j) {
            const Vec3& w = views.fitted[1 + j];
            const Vec2 azimuth = azimuth_of(w);
            const Quantities seen = moments(nodes[j].area / w.z, seen_slopes(nodes[j]),
                                            nodes[j].color[1], x_axis(azimuth));
            const Quantities all = moments(1, seen_slopes(straight), color_, x_axis(azimuth));
            const std::vector<double> wave = waves(azimuth, harmonics);
            // Evenly spaced azimuths: least squares is a sum.
            for (size_t term = 0; term < terms.size(); ++term)
                for (size_t q = 0; q < kQuantities; ++q)
                    terms[term][q] += (term == 0 ? 1.0 : 2.0) / SlopeViews::kAzimuths * wave[term] *
                                      (seen[q] - all[q]);
        }
    }
}

Vec2 SlopeTable::x_axis(const Vec2& azimuth) const
{
    return frame_ == Frame::view ? azimuth : Vec2(1, 0);
}

SlopeTable::Quantities SlopeTable::at_node(size_t node, const Vec2& azimuth) const
{
    const std::vector<Quantities>& terms = terms_[node];
    const std::vector<double> wave = waves(azimuth, (terms.size() - 1) / 2);
    Quantities sum{};
    for (size_t term = 0; term < terms.size(); ++term)
        for (size_t q = 0; q < kQuantities; ++q)
            sum[q] += wave[term] * terms[term][q];
    return sum;
}

SlopeTable::Told SlopeTable::at(const Vec3& w, const filter::Slopes<double>& baked) const
{
    const Vec2 azimuth = azimuth_of(w), x = x_axis(azimuth);
    size_t far = 0;
    while (far + 1 < tangents_.size() && tangent(w) > tangents_[far])
        ++far;
    const double from = far > 0 ? tangents_[far - 1] : 0;
    const double share = std::min((tangent(w) - from) / (tangents_[far] - from), 1.0);
    Quantities told = at_node(far, azimuth);
    const Quantities near = far > 0 ? at_node(far - 1, azimuth) : Quantities{};
    const Quantities all = moments(1, {baked.mean, baked.covariance}, color_, x);
    const double a = near[0] + share * (told[0] - near[0]);
    const double v = std::max(1 + a, kLeastSeen);
    for (size_t q = 1; q < kQuantities; ++q) {
        const double beta = near[q] + share * (told[q] - near[q]);
        told[q] = all[q] + (beta - a * all[q]) / v;
    }
    const Vec2 m(told[1], told[2]);
    const SeenSlopes in_frame{
        m, made_positive({told[3] - m.x * m.x, told[4] - m.x * m.y, told[5] - m.y * m.y})};
    return {turned(in_frame, Vec2(x.x, -x.y)), told[6]};
}

} // namespace scree::test
