#include "pipeline/color_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "kernel/visibility_table.h"
#include "stats/kurtosis.h"

namespace scree {

namespace {

constexpr double kRadian = 0.017453292519943295769;

using Shown = std::function<Rgb(const SeenTexel&)>;

ModelRecord record_of(const std::string& name, int channels, int rank_terms = 0)
{
    ModelRecord record;
    record.model = name;
    record.channels = channels;
    record.rank_terms = rank_terms;
    return record;
}

Shown shown_by_map(const ValueScale& scale, const MapTable& map)
{
    return [h0 = scale.h0, h1 = scale.h1, &map](const SeenTexel& seen) {
        const double sigma = std::sqrt(seen.texel.height_var);
        return lookup(map, h0 + h1 * (seen.texel.height + sigma * seen.height.mean),
                      h1 * sigma * std::sqrt(seen.height.variance));
    };
}

Shown shown_by_rank(const MomentLayout& layout, int terms)
{
    return [rank = layout.rank, terms](const SeenTexel& seen) {
        Rgb color = seen.texel.color;
        for (size_t c = 0; c < 3; ++c) {
            double a[kMaxRankTerms] = {};
            for (int n = 0; n < terms; ++n)
                a[n] = seen.texel.value(rank + 3 * n + static_cast<int>(c));
            color[c] = kernel::scree_color_by_rank(color[c], a[0], a[1], a[2], a[3], a[4], a[5],
                                                   a[6], a[7], seen.lambda);
        }
        return color;
    };
}

Shown shown_by_height(const MomentLayout& layout)
{
    return [plane = layout.color_height](const SeenTexel& seen) {
        const double h = seen.texel.height;
        const Rgb covariance = seen.texel.rgb(plane);
        Rgb color = seen.texel.color;
        for (size_t c = 0; c < 3; ++c)
            color[c] =
                kernel::scree_color_by_height(color[c], covariance[c] + color[c] * h, h,
                                              seen.texel.height_var + h * h, seen.height.mean);
        return color;
    };
}

/// Nodes and harmonics of a table that make a smaller one.
struct TablePart {
    std::vector<int> nodes; ///< their numbers, rising
    int harmonics = 0;      ///< at most those of the table
};

VisibilityPlan plan_of(const VisibilityPlan& table, const TablePart& part)
{
    VisibilityPlan plan = table;
    plan.harmonics = part.harmonics;
    plan.node_angles_deg.clear();
    for (const int node : part.nodes)
        plan.node_angles_deg.push_back(table.node_angles_deg[static_cast<size_t>(node)]);
    return plan;
}

/// The first plane of each component of the part.
///
/// first_plane  that of the table
std::vector<int> planes_of(const VisibilityPlan& table, const TablePart& part, int first_plane)
{
    std::vector<int> terms(table.axes ? static_cast<size_t>(table.terms()) : 1);
    std::iota(terms.begin(), terms.end(), 0);
    for (const int wave : {0, 1}) // cosines, then sines
        for (int h = 1; h <= part.harmonics; ++h)
            terms.push_back(wave * table.harmonics + h);
    std::vector<int> planes;
    for (const int node : part.nodes)
        for (const int term : terms)
            planes.push_back(first_plane +
                             MomentLayout::kVisiblePlanes * (node * table.terms() + term));
    return planes;
}

Shown shown_by_table(const VisibilityPlan& plan, std::vector<int> planes)
{
    std::vector<double> cosines;
    for (const double angle : plan.node_angles_deg)
        cosines.push_back(std::cos(angle * kRadian));
    const double axis = plan.axis_deg * kRadian;
    const filter::VisibilityTable<double> empty{
        nullptr,        nullptr,       static_cast<int>(cosines.size()), plan.harmonics, plan.axes,
        std::cos(axis), std::sin(axis)};
    return [empty, cosines, planes = std::move(planes)](const SeenTexel& seen) {
        double values[kMostVisibleChannels];
        int count = 0;
        for (const int plane : planes)
            for (int i = 0; i < MomentLayout::kVisiblePlanes; ++i)
                values[count++] = seen.texel.value(plane + i);
        filter::VisibilityTable<double> table = empty;
        table.values = values;
        table.cosines = cosines.data();
        const auto& [r, g, b] = seen.texel.color;
        const auto color = filter::visible_color({r, g, b}, table, seen.w);
        return Rgb{color.x, color.y, color.z};
    };
}

/// All nodes; of harmonics as many and fewer, and besides the second and last node alone.
std::vector<TablePart> parts_of(const VisibilityPlan& table)
{
    const int count = static_cast<int>(table.node_angles_deg.size());
    if (count == 0)
        return {};
    std::vector<int> all(static_cast<size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    if (table.axes)
        return {{all, 0}};
    std::vector<TablePart> parts;
    for (int harmonics = 0; harmonics <= table.harmonics; ++harmonics) {
        if (count >= 4)
            parts.push_back({{1, count - 1}, harmonics});
        parts.push_back({all, harmonics});
    }
    return parts;
}

void add_tables(const VisibilityPlan& table, int first_plane, std::vector<CandidateModel>& models)
{
    for (const TablePart& part : parts_of(table)) {
        const VisibilityPlan plan = plan_of(table, part);
        const size_t nodes = part.nodes.size();
        const std::string name = plan.axes ? fmt::format("visible {} axes", nodes)
                                           : fmt::format("visible {}x{}", nodes, plan.terms());
        models.push_back({record_of(name, MomentLayout::kVisiblePlanes * plan.components()), plan,
                          shown_by_table(plan, planes_of(table, part, first_plane))});
    }
}

} // namespace

MeasuredTexel::MeasuredTexel(const MomentLayout& layout, MomentRow texel) : row(texel)
{
    weight = value(MomentLayout::weight);
    slopes.mean = {value(layout.slope_s), value(layout.slope_t)};
    slopes.covariance = {value(layout.slope_ss), value(layout.slope_st), value(layout.slope_tt)};
    slopes.tau = layout.slope_tail >= 0 ? tail_of(layout, texel, 0).tau : 0;
    if (layout.color >= 0)
        color = rgb(layout.color);
    if (layout.height >= 0) {
        height = value(layout.height);
        height_var = value(layout.height_var);
    }
}

Rgb MeasuredTexel::rgb(int plane) const
{
    return {value(plane), value(plane + 1), value(plane + 2)};
}

filter::Slopes<double> MeasuredTexel::about_plane() const
{
    const filter::Vec2<double>& mean = slopes.mean;
    filter::Slopes<double> raw = slopes;
    raw.mean = {0, 0};
    raw.covariance.ss += mean.x * mean.x;
    raw.covariance.st += mean.x * mean.y;
    raw.covariance.tt += mean.y * mean.y;
    return raw;
}

SeenTexel::SeenTexel(const MeasuredTexel& measured, const MeasuredView& view)
    : texel(measured), w(view.x, view.y, view.z),
      lambda(filter::masking(w, measured.slopes).lambda), height(filter::visible_height(lambda))
{}

std::vector<CandidateModel> candidate_models(const MomentLayout& layout, const ValueScale& scale,
                                             const MapTable* map, const TableSizes& tables)
{
    std::vector<CandidateModel> models;
    auto add = [&models](const ModelRecord& record, Shown shown) {
        models.push_back({record, {}, std::move(shown)});
    };
    auto add_rank = [&](int terms) {
        add(record_of(fmt::format("rank {}", terms), 3 * terms, terms),
            shown_by_rank(layout, terms));
    };
    add(record_of("mean color", 0), [](const SeenTexel& seen) { return seen.texel.color; });
    if (map != nullptr)
        add(record_of("map", 2), shown_by_map(scale, *map)); // height
    for (int terms = 1; terms < layout.rank_terms; terms *= 2)
        add_rank(terms);
    if (layout.rank_terms > 0)
        add_rank(layout.rank_terms);
    if (layout.color_height >= 0)
        add(record_of("colorheight", 5), shown_by_height(layout)); // and height
    if (layout.color_height >= 0 && layout.view_count > 0)
        add(record_of("exponent", 8), nullptr); // and colorheight
    add_tables(tables.visibility, layout.visible, models);
    add_tables(tables.tried, layout.tried, models);
    std::stable_sort(models.begin(), models.end(),
                     [](const CandidateModel& a, const CandidateModel& b) {
                         return a.record.channels < b.record.channels;
                     });
    return models;
}

} // namespace scree
