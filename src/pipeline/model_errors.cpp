#include "pipeline/model_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernel/filter.h"
#include "stats/kurtosis.h"

namespace scree {

namespace {

constexpr double kRadian = 0.017453292519943295769;
constexpr double kAtomsALevel = 1 << 18;
constexpr double kLeastTexels = 64;

/// A number in [0, 1) that has nothing to do with its neighbours'. After Steele, Lea, Flood 2014
/// (SplitMix).
double hash(int level, int x, int y)
{
    uint64_t z = (static_cast<uint64_t>(level) << 58) ^ (static_cast<uint64_t>(y) << 29) ^
                 static_cast<uint64_t>(x);
    for (int round = 0; round < 2; ++round) {
        z += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        z ^= z >> 31;
    }
    return static_cast<double>(z >> 11) * 0x1p-53;
}

filter::Slopes<double> slopes_of(const MomentLayout& layout, MomentRow texel)
{
    auto value = [&texel](int plane) { return texel.plane(plane)[0]; };
    filter::Slopes<double> slopes;
    slopes.mean = {value(layout.slope_s), value(layout.slope_t)};
    slopes.covariance = {value(layout.slope_ss), value(layout.slope_st), value(layout.slope_tt)};
    slopes.tau = layout.slope_tail >= 0 ? tail_of(layout, texel, 0).tau : 0;
    return slopes;
}

double square(double x) { return x * x; }

} // namespace

ModelErrors::ModelErrors(const MomentLayout& layout, const ValueScale& scale, const MapTable* table,
                         double max_view_angle_deg, int width, int height)
    : layout_(layout), scale_(scale), table_(table)
{
    models_.push_back({"mean color", 0, 0});
    if (table != nullptr)
        models_.push_back({"map", 2, 0}); // height
    auto add_rank = [this](int terms) {
        models_.push_back({"rank " + std::to_string(terms), 3 * terms, terms});
    };
    for (int terms = 1; terms < layout.rank_terms; terms *= 2)
        add_rank(terms);
    if (layout.rank_terms > 0)
        add_rank(layout.rank_terms);
    if (layout.color_height >= 0)
        models_.push_back({"colorheight", 5, 0}); // and height
    std::stable_sort(models_.begin(), models_.end(),
                     [](const Model& a, const Model& b) { return a.channels < b.channels; });

    for (int e = 0; e < kElevations; ++e) {
        const double angle = max_view_angle_deg * kRadian * (e + 1) / kElevations;
        const double level = std::sin(angle), up = std::cos(angle);
        views_[static_cast<size_t>(e)] = {
            {{level, 0, up}, {0, level, up}, {-level, 0, up}, {0, -level, up}}};
    }
    const double all = static_cast<double>(width) * height;
    for (int l = 0, w = width, h = height; l < level_count(width, height); ++l) {
        const double texels = static_cast<double>(w) * h;
        picked_.push_back(std::max(kAtomsALevel / all, kLeastTexels / texels));
        Sums none;
        none.models.resize(models_.size());
        blocks_.emplace_back(static_cast<size_t>((w + kBlockColumns - 1) / kBlockColumns), none);
        w = coarser_size(w);
        h = coarser_size(h);
    }
}

bool ModelErrors::is_picked(int level, int x, int y) const
{
    return hash(level, x, y) < picked_[static_cast<size_t>(level)];
}

void ModelErrors::texels(int level, int y, int x0, int count, MomentRow row)
{
    Sums& sums = blocks_[static_cast<size_t>(level)][static_cast<size_t>(x0 / kBlockColumns)];
    for (int i = 0; i < count; ++i)
        if (row.plane(MomentLayout::weight)[i] > 0 && is_picked(level, x0 + i, y))
            add_slopes(row.from(i), sums);
    if (level + 1 == static_cast<int>(blocks_.size()) && layout_.color >= 0)
        for (int c = 0; c < 3; ++c)
            mean_color_[static_cast<size_t>(c)] = row.plane(layout_.color + c)[0];
}

void ModelErrors::profiles(int level, int y, int x0, int count, MomentRow row,
                           const ProfileRow& profiles)
{
    Sums& sums = blocks_[static_cast<size_t>(level)][static_cast<size_t>(x0 / kBlockColumns)];
    for (int i = 0; i < count; ++i)
        if (profiles.at(x0 + i).count > 0 && is_picked(level, x0 + i, y))
            add_profile(row.from(i), profiles.at(x0 + i), sums);
}

void ModelErrors::add_slopes(MomentRow texel, Sums& sums) const
{
    const double weight = texel.plane(MomentLayout::weight)[0];
    const filter::Slopes<double> slopes = slopes_of(layout_, texel);
    filter::Slopes<double> gaussian = slopes;
    gaussian.tau = 0;
    sums.seen += weight;
    for (size_t e = 0; e < kElevations; ++e)
        for (const View& view : views_[e]) {
            const filter::Vec3<double> w(view.x, view.y, view.z);
            if (slopes.tau > 0) {
                const auto with = filter::visible_slopes(w, slopes);
                const auto without = filter::visible_slopes(w, gaussian);
                const double area = (with.area - without.area) / std::max(with.area, 1e-30);
                sums.tail[e] += weight / kAzimuths *
                                std::max(square(area), (with.mean - without.mean).length2());
            }
            if (layout_.color_slope_s >= 0) {
                const auto& [ss, st, tt] = slopes.covariance;
                const double pull = kernel::scree_slope_pull(view.x, view.y, view.z, slopes.mean.x,
                                                             slopes.mean.y, ss, st, tt, slopes.tau);
                for (int c = 0; c < 3; ++c) {
                    const double along = texel.plane(layout_.color_slope_s + c)[0] * view.x +
                                         texel.plane(layout_.color_slope_t + c)[0] * view.y;
                    sums.colorslope[e] += weight / (3 * kAzimuths) * square(along * pull);
                }
            }
        }
}

Rgb ModelErrors::shown(const Model& model, MomentRow texel, double lambda) const
{
    auto value = [&texel](int plane) { return texel.plane(plane)[0]; };
    Rgb color{};
    const double mean = value(layout_.height);
    const double variance = value(layout_.height_var);
    const auto visible = filter::visible_height(lambda);
    if (model.name == "map") {
        const double sigma = std::sqrt(variance);
        return lookup(*table_, scale_.h0 + scale_.h1 * (mean + sigma * visible.mean),
                      scale_.h1 * sigma * std::sqrt(visible.variance));
    }
    for (size_t i = 0; i < 3; ++i) {
        const int c = static_cast<int>(i);
        const double own = value(layout_.color + c);
        color[i] = own;
        if (model.rank_terms > 0) {
            double a[kMaxRankTerms] = {};
            for (int n = 0; n < model.rank_terms; ++n)
                a[n] = value(layout_.rank + 3 * n + c);
            color[i] = kernel::scree_color_by_rank(own, a[0], a[1], a[2], a[3], a[4], a[5], a[6],
                                                   a[7], lambda);
        } else if (model.name == "colorheight") {
            color[i] =
                kernel::scree_color_by_height(own, value(layout_.color_height + c) + own * mean,
                                              mean, variance + mean * mean, visible.mean);
        }
    }
    return color;
}

void ModelErrors::add_profile(MomentRow texel, const RankProfile& profile, Sums& sums) const
{
    const double weight = texel.plane(MomentLayout::weight)[0];
    const filter::Slopes<double> slopes = slopes_of(layout_, texel);
    sums.judged += weight;
    for (size_t e = 0; e < kElevations; ++e)
        for (const View& view : views_[e]) {
            const double lambda =
                filter::masking(filter::Vec3<double>(view.x, view.y, view.z), slopes).lambda;
            const Rgb truth = visible_color(profile, lambda);
            for (size_t m = 0; m < models_.size(); ++m) {
                const Rgb color = shown(models_[m], texel, lambda);
                for (size_t c = 0; c < 3; ++c)
                    sums.models[m][e] += weight / (3 * kAzimuths) * square(color[c] - truth[c]);
            }
        }
}

template <class Of>
double ModelErrors::worst(double Sums::*weight, Of squares) const
{
    double largest = 0;
    for (const auto& blocks : blocks_) {
        double total = 0;
        Squares sums{};
        for (const Sums& block : blocks) {
            total += block.*weight;
            for (size_t e = 0; e < kElevations; ++e)
                sums[e] += squares(block)[e];
        }
        for (const double sum : sums)
            if (total > 0)
                largest = std::max(largest, std::sqrt(sum / total));
    }
    return largest;
}

namespace {

/// Relative to the rms of a color; of a black map nothing shows.
double relative(double error, const Rgb& color)
{
    const double size = std::sqrt((square(color[0]) + square(color[1]) + square(color[2])) / 3);
    return size > 0 ? error / size : 0;
}

} // namespace

std::vector<ModelRecord> ModelErrors::color_models() const
{
    std::vector<ModelRecord> records;
    for (size_t m = 0; m < models_.size(); ++m) {
        const double error = worst(&Sums::judged, [m](const Sums& sums) { return sums.models[m]; });
        records.push_back({models_[m].name, models_[m].channels, relative(error, mean_color_),
                           models_[m].rank_terms, false});
    }
    return records;
}

double ModelErrors::without_colorslope() const
{
    return relative(worst(&Sums::seen, [](const Sums& sums) { return sums.colorslope; }),
                    mean_color_);
}

double ModelErrors::without_tail() const
{
    return worst(&Sums::seen, [](const Sums& sums) { return sums.tail; });
}

} // namespace scree
