#include "pipeline/model_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "kernel/filter.h"
#include "kernel/visibility_table.h"
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

double square(double x) { return x * x; }

double lambda_of(const MeasuredView& view, const filter::Slopes<double>& slopes)
{
    return filter::masking(filter::Vec3<double>(view.x, view.y, view.z), slopes).lambda;
}

} // namespace

struct ModelErrors::Texel {
    Texel(const MomentLayout& layout, MomentRow texel) : row(texel)
    {
        weight = value(MomentLayout::weight);
        slopes.mean = {value(layout.slope_s), value(layout.slope_t)};
        slopes.covariance = {value(layout.slope_ss), value(layout.slope_st),
                             value(layout.slope_tt)};
        slopes.tau = layout.slope_tail >= 0 ? tail_of(layout, texel, 0).tau : 0;
    }

    [[nodiscard]] double value(int plane) const { return row.plane(plane)[0]; }

    /// Slopes about the texture plane: what the exponent that is fitted goes by.
    [[nodiscard]] filter::Slopes<double> about_plane() const
    {
        filter::Slopes<double> raw = slopes;
        raw.mean = {0, 0};
        raw.covariance.ss += square(slopes.mean.x);
        raw.covariance.st += slopes.mean.x * slopes.mean.y;
        raw.covariance.tt += square(slopes.mean.y);
        return raw;
    }

    MomentRow row;
    double weight = 0;
    filter::Slopes<double> slopes;
};

ModelErrors::ModelErrors(const MomentLayout& layout, const ValueScale& scale, const MapTable* map,
                         const TableSizes& tables, const MeasuredViews& views, int width,
                         int height)
    : layout_(layout), scale_(scale), map_(map), views_(views)
{
    auto add = [this](const std::string& name, int channels, int rank_terms = 0) {
        Model& model = models_.emplace_back();
        model.record.model = name;
        model.record.channels = channels;
        model.record.rank_terms = rank_terms;
    };
    add("mean color", 0);
    if (map != nullptr)
        add("map", 2); // height
    for (int terms = 1; terms < layout.rank_terms; terms *= 2)
        add(fmt::format("rank {}", terms), 3 * terms, terms);
    if (layout.rank_terms > 0)
        add(fmt::format("rank {}", layout.rank_terms), 3 * layout.rank_terms, layout.rank_terms);
    if (layout.color_height >= 0)
        add("colorheight", 5); // and height
    if (layout.color_height >= 0 && layout.view_count > 0)
        add("exponent", 8); // and colorheight
    add_tables(tables.visibility, layout.visible);
    add_tables(tables.tried, layout.tried);
    std::stable_sort(models_.begin(), models_.end(), [](const Model& a, const Model& b) {
        return a.record.channels < b.record.channels;
    });

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

/// A part of a table that is measured.
void ModelErrors::add_table(const VisibilityPlan& measured, int first_plane,
                            const std::vector<int>& nodes, int harmonics)
{
    Model& model = models_.emplace_back();
    model.table = measured;
    model.table.harmonics = harmonics;
    model.table.node_angles_deg.clear();
    auto add = [&](int node, int term) {
        const int component = node * measured.terms() + term;
        model.planes.push_back(first_plane + MomentLayout::kVisiblePlanes * component);
    };
    for (const int node : nodes) {
        const double angle = measured.node_angles_deg[static_cast<size_t>(node)];
        model.table.node_angles_deg.push_back(angle);
        model.cosines.push_back(std::cos(angle * kRadian));
        add(node, 0);
        for (int term = 1; measured.axes && term < measured.terms(); ++term)
            add(node, term);
        for (const int wave : {0, 1}) // cosines, then sines
            for (int h = 1; h <= harmonics; ++h)
                add(node, wave * measured.harmonics + h);
    }
    const size_t size = nodes.size();
    model.record.model = measured.axes ? fmt::format("visible {} axes", size)
                                       : fmt::format("visible {}x{}", size, model.table.terms());
    model.record.channels = MomentLayout::kVisiblePlanes * model.table.components();
}

/// All nodes; of harmonics as many and fewer, and besides the second and last node alone.
void ModelErrors::add_tables(const VisibilityPlan& measured, int first_plane)
{
    const int count = static_cast<int>(measured.node_angles_deg.size());
    std::vector<int> all(static_cast<size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    if (measured.axes)
        add_table(measured, first_plane, all, 0);
    for (int harmonics = 0; harmonics <= measured.harmonics && !measured.axes; ++harmonics) {
        if (count >= 4)
            add_table(measured, first_plane, {1, count - 1}, harmonics);
        if (count >= 1)
            add_table(measured, first_plane, all, harmonics);
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
        const Texel texel(layout_, row.from(i));
        sums.texels += texel.weight;
        add_slopes(texel, sums);
        if (layout_.view_count > 0)
            add_colors(texel, sums);
    }
    if (level + 1 == static_cast<int>(blocks_.size()) && layout_.color >= 0)
        for (int c = 0; c < 3; ++c)
            mean_color_[static_cast<size_t>(c)] = row.plane(layout_.color + c)[0];
}

void ModelErrors::add_slopes(const Texel& texel, Sums& sums) const
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

Rgb ModelErrors::by_table(const Model& model, const Texel& texel, const MeasuredView& view) const
{
    double values[kMostVisibleChannels];
    int count = 0;
    for (const int plane : model.planes)
        for (int i = 0; i < MomentLayout::kVisiblePlanes; ++i)
            values[count++] = texel.value(plane + i);
    const double axis = model.table.axis_deg * kRadian;
    const filter::VisibilityTable<double> table{values,
                                                model.cosines.data(),
                                                static_cast<int>(model.cosines.size()),
                                                model.table.harmonics,
                                                model.table.axes,
                                                std::cos(axis),
                                                std::sin(axis)};
    const filter::Vec3<double> color(texel.value(layout_.color), texel.value(layout_.color + 1),
                                     texel.value(layout_.color + 2));
    const auto seen = filter::visible_color(color, table, {view.x, view.y, view.z});
    return {seen.x, seen.y, seen.z};
}

Rgb ModelErrors::shown(const Model& model, const Texel& texel, double lambda,
                       const MeasuredView& view) const
{
    if (!model.planes.empty())
        return by_table(model, texel, view);
    Rgb color{};
    for (size_t c = 0; c < 3; ++c)
        color[c] = texel.value(layout_.color + static_cast<int>(c));
    if (model.record.model == "mean color")
        return color;
    const double mean = texel.value(layout_.height);
    const double variance = texel.value(layout_.height_var);
    const auto visible = filter::visible_height(lambda);
    if (model.record.model == "map") {
        const double sigma = std::sqrt(variance);
        return lookup(*map_, scale_.h0 + scale_.h1 * (mean + sigma * visible.mean),
                      scale_.h1 * sigma * std::sqrt(visible.variance));
    }
    for (size_t i = 0; i < 3; ++i) {
        const int c = static_cast<int>(i);
        if (model.record.rank_terms > 0) {
            double a[kMaxRankTerms] = {};
            for (int n = 0; n < model.record.rank_terms; ++n)
                a[n] = texel.value(layout_.rank + 3 * n + c);
            color[i] = kernel::scree_color_by_rank(color[i], a[0], a[1], a[2], a[3], a[4], a[5],
                                                   a[6], a[7], lambda);
        } else if (model.record.model == "colorheight") {
            color[i] = kernel::scree_color_by_height(
                color[i], texel.value(layout_.color_height + c) + color[i] * mean, mean,
                variance + mean * mean, visible.mean);
        }
    }
    return color;
}

void ModelErrors::add_colors(const Texel& texel, Sums& sums) const
{
    const filter::Slopes<double> about_plane = texel.about_plane();
    Rgb shift{};
    if (sums.exponent) {
        const double variance = texel.value(layout_.height_var);
        for (size_t c = 0; c < 3; ++c)
            shift[c] = variance > 0 ? texel.value(layout_.color_height + static_cast<int>(c)) /
                                          std::sqrt(variance)
                                    : 0;
    }
    for (size_t i = 0; i < views_.views.size(); ++i) {
        const MeasuredView& view = views_.views[i];
        const int first = layout_.views + MomentLayout::kVisiblePlanes * static_cast<int>(i);
        const double seen = 1 + texel.value(first);
        if (!(seen > 1e-6))
            continue;
        Rgb truth{}, more{};
        for (size_t c = 0; c < 3; ++c) {
            const double color = texel.value(layout_.color + static_cast<int>(c));
            truth[c] = (color + texel.value(first + 3 - static_cast<int>(c))) / seen; // B G R
            more[c] = truth[c] - color;
        }
        const auto e = static_cast<size_t>(view.elevation);
        const double weight = texel.weight * seen;
        const double lambda = lambda_of(view, texel.slopes);
        sums.seen[e] += weight;
        for (size_t m = 0; m < models_.size(); ++m) {
            const Rgb color = shown(models_[m], texel, lambda, view);
            for (size_t c = 0; c < 3; ++c)
                sums.models[m][e] += weight / 3 * square(color[c] - truth[c]);
        }
        if (sums.exponent)
            sums.exponent->add(view.elevation, lambda_of(view, about_plane), shift, more,
                               weight / 3);
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
    if (models_[model].record.model != "exponent")
        return largest_rms(sums.models[model], sums.seen) / color_size();
    return largest_rms(sums.exponent->squares(*fit), sums.seen) / color_size();
}

MeasuredModels ModelErrors::measured() const
{
    MeasuredModels measured;
    for (const Model& model : models_) {
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
