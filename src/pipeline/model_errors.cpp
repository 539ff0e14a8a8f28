#include "pipeline/model_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kernel/filter.h"

namespace scree {

namespace {

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

double square(double x) { return x * x; }

} // namespace

ModelErrors::ModelErrors(const MomentLayout& layout, const ValueScale& scale, const MapTable* map,
                         const TableSizes& tables, const MeasuredViews& views, int width,
                         int height)
    : layout_(layout), views_(views), models_(candidate_models(layout, scale, map, tables))
{
    const size_t elevations = views.elevations_deg.size();
    const double all = static_cast<double>(width) * height;
    for (int l = 0, w = width, h = height; l < level_count(width, height); ++l) {
        const double texels = static_cast<double>(w) * h;
        picked_.push_back(std::max(kAtomsALevel / all, kLeastTexels / texels));
        Sums none;
        none.seen.resize(elevations);
        none.models.assign(models_.size(), Squares(elevations));
        none.colorslope.resize(elevations);
        none.tail.resize(elevations);
        if (layout.color_height >= 0 && layout.view_count > 0)
            none.exponent.emplace(static_cast<int>(elevations));
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
    for (int i = 0; i < count; ++i) {
        if (!(row.plane(MomentLayout::weight)[i] > 0) || !is_picked(level, x0 + i, y))
            continue;
        const MeasuredTexel texel(layout_, row.from(i));
        sums.texels += texel.weight;
        add_slopes(texel, sums);
        if (layout_.view_count > 0)
            add_colors(texel, sums);
    }
    if (level + 1 == static_cast<int>(blocks_.size()) && layout_.color >= 0)
        for (int c = 0; c < 3; ++c)
            mean_color_[static_cast<size_t>(c)] = row.plane(layout_.color + c)[0];
}

void ModelErrors::add_slopes(const MeasuredTexel& texel, Sums& sums) const
{
    const filter::Slopes<double>& slopes = texel.slopes;
    filter::Slopes<double> gaussian = slopes;
    gaussian.tau = 0;
    const double share = static_cast<double>(views_.elevations_deg.size()) /
                         static_cast<double>(views_.views.size());
    for (const MeasuredView& view : views_.views) {
        const auto e = static_cast<size_t>(view.elevation);
        const filter::Vec3<double> w(view.x, view.y, view.z);
        if (slopes.tau > 0) {
            const auto with = filter::visible_slopes(w, slopes);
            const auto without = filter::visible_slopes(w, gaussian);
            const double area = (with.area - without.area) / std::max(with.area, 1e-30);
            sums.tail[e] +=
                texel.weight * share * std::max(square(area), (with.mean - without.mean).length2());
        }
        if (layout_.color_slope_s >= 0) {
            const auto& [ss, st, tt] = slopes.covariance;
            const double pull = kernel::scree_slope_pull(view.x, view.y, view.z, slopes.mean.x,
                                                         slopes.mean.y, ss, st, tt, slopes.tau);
            for (int c = 0; c < 3; ++c) {
                const double along = texel.value(layout_.color_slope_s + c) * view.x +
                                     texel.value(layout_.color_slope_t + c) * view.y;
                sums.colorslope[e] += texel.weight * share / 3 * square(along * pull);
            }
        }
    }
}

ModelErrors::Truth ModelErrors::truth_of(const MeasuredTexel& texel, int view) const
{
    const MomentRow& row = texel.row;
    if (row.seen != nullptr) { // a texel of level 0
        const int before = layout_.visible_components + layout_.tried_components;
        return {1 + static_cast<double>(row.seen_of(before + view)[0]), texel.color};
    }
    const int first = layout_.views + MomentLayout::kVisiblePlanes * view;
    Truth truth{1 + texel.value(first), {}};
    for (size_t c = 0; c < 3; ++c)
        truth.color[c] =
            (texel.color[c] + texel.value(first + 3 - static_cast<int>(c))) / truth.area; // B G R
    return truth;
}

void ModelErrors::add_colors(const MeasuredTexel& texel, Sums& sums) const
{
    const filter::Slopes<double> about_plane = texel.about_plane();
    Rgb shift{}; // of the color, by a deviation of height
    if (sums.exponent && texel.height_var > 0) {
        shift = texel.rgb(layout_.color_height);
        for (double& channel : shift)
            channel /= std::sqrt(texel.height_var);
    }
    for (size_t i = 0; i < views_.views.size(); ++i) {
        const MeasuredView& view = views_.views[i];
        const Truth truth = truth_of(texel, static_cast<int>(i));
        if (!(truth.area > 1e-6))
            continue;
        const SeenTexel seen(texel, view);
        Rgb more{};
        for (size_t c = 0; c < 3; ++c)
            more[c] = truth.color[c] - texel.color[c];
        const auto e = static_cast<size_t>(view.elevation);
        const double weight = texel.weight * truth.area;
        sums.seen[e] += weight;
        add_models(seen, truth.color, e, weight / 3, sums);
        if (sums.exponent)
            sums.exponent->add(view.elevation, filter::masking(seen.w, about_plane).lambda, shift,
                               more, weight / 3);
    }
}

void ModelErrors::add_models(const SeenTexel& seen, const Rgb& truth, size_t elevation,
                             double weight, Sums& sums) const
{
    const bool is_finest = seen.texel.row.seen != nullptr; // where tables show the color itself
    for (size_t m = 0; m < models_.size(); ++m) {
        if (models_[m].is_fitted() || (is_finest && models_[m].table.components() > 0))
            continue;
        const Rgb color = models_[m].shown(seen);
        for (size_t c = 0; c < 3; ++c)
            sums.models[m][elevation] += weight * square(color[c] - truth[c]);
    }
}

ModelErrors::Sums ModelErrors::total(int level) const
{
    const auto& blocks = blocks_[static_cast<size_t>(level)];
    Sums sums = blocks.front();
    auto add = [](const Squares& from, Squares& to) {
        for (size_t i = 0; i < to.size(); ++i)
            to[i] += from[i];
    };
    for (size_t b = 1; b < blocks.size(); ++b) {
        const Sums& block = blocks[b];
        sums.texels += block.texels;
        add(block.seen, sums.seen);
        for (size_t m = 0; m < models_.size(); ++m)
            add(block.models[m], sums.models[m]);
        add(block.colorslope, sums.colorslope);
        add(block.tail, sums.tail);
        if (sums.exponent)
            sums.exponent->add(*block.exponent);
    }
    return sums;
}

/// Rms of the map's mean color; of a black map, where nothing shows, endless.
double ModelErrors::color_size() const
{
    const double squares = square(mean_color_[0]) + square(mean_color_[1]) + square(mean_color_[2]);
    return squares > 0 ? std::sqrt(squares / 3) : std::numeric_limits<double>::infinity();
}

namespace {

/// Root of the largest mean square over elevations.
double largest_rms(const std::vector<double>& squares, const std::vector<double>& weights)
{
    double largest = 0;
    for (size_t e = 0; e < squares.size(); ++e)
        if (weights[e] > 0)
            largest = std::max(largest, squares[e] / weights[e]);
    return std::sqrt(largest);
}

} // namespace

double ModelErrors::largest_error(const Sums& sums, size_t model,
                                  const std::optional<ExponentFit>& fit) const
{
    const Squares squares =
        models_[model].is_fitted() ? sums.exponent->squares(*fit) : sums.models[model];
    return largest_rms(squares, sums.seen) / color_size();
}

MeasuredModels ModelErrors::measured() const
{
    MeasuredModels measured;
    for (const CandidateModel& model : models_) {
        measured.models.push_back(model.record);
        measured.tables.push_back(model.table);
    }
    for (size_t level = 0; level < blocks_.size(); ++level) {
        const Sums sums = total(static_cast<int>(level));
        std::optional<ExponentFit> fit;
        if (sums.exponent)
            fit = fit_exponent(*sums.exponent, color_size());
        measured.exponents.push_back(fit);
        std::vector<LevelError> errors;
        for (size_t m = 0; m < models_.size() && layout_.view_count > 0; ++m) {
            errors.push_back({models_[m].record.model, largest_error(sums, m, fit)});
            measured.models[m].error += square(errors.back().error);
        }
        measured.levels.push_back(std::move(errors));
        const Squares texels(sums.tail.size(), sums.texels);
        measured.without_colorslope = std::max(measured.without_colorslope,
                                               largest_rms(sums.colorslope, texels) / color_size());
        measured.without_tail = std::max(measured.without_tail, largest_rms(sums.tail, texels));
    }
    const size_t coarser = std::max<size_t>(blocks_.size() - 1, 1); // nothing varies at level 0
    for (ModelRecord& model : measured.models)
        model.error = std::sqrt(model.error / static_cast<double>(coarser));
    return measured;
}

} // namespace scree
