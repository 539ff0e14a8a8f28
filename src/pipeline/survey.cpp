#include "pipeline/survey.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "math/error.h"
#include "pipeline/pool.h"

namespace scree {

namespace {

/// Weight, mean and sum of squared deviations, merged.
struct Running {
    double weight = 0, mean = 0, squares = 0;

    void merge(const Running& other)
    {
        const double total = weight + other.weight;
        if (!(total > 0))
            return;
        const double offset = other.mean - mean;
        mean += offset * (other.weight / total);
        squares += other.squares + offset * offset * weight * (other.weight / total);
        weight = total;
    }
};

/// What the survey adds up, of one strip or of all before it.
struct Sums {
    Running height; ///< of the heights; of a normal map, of its slopes, whose weight is the same
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    std::array<double, 3> color{};
    long long no_data = 0;
    bool unit_weights = true, covered = true;

    void merge(const Sums& other)
    {
        height.merge(other.height);
        min = std::min(min, other.min);
        max = std::max(max, other.max);
        for (size_t c = 0; c < 3; ++c)
            color[c] += other.color[c];
        no_data += other.no_data;
        unit_weights = unit_weights && other.unit_weights;
        covered = covered && other.covered;
    }
};

/// Two loops over a row: its mean, then deviations from it.
void add_row(const double* presence, const float* weight, int width, std::vector<double>& weights,
             Sums& sums)
{
    weights.resize(static_cast<size_t>(width));
    double* w = weights.data();
    int missing = 0;
    double total = 0, first = 0, min = sums.min, max = sums.max;
    for (int x = 0; x < width; ++x) {
        const bool valid = !std::isnan(presence[x]);
        const double given = weight != nullptr ? static_cast<double>(weight[x]) : 1;
        const double h = valid ? presence[x] : 0;
        w[x] = valid ? given : 0;
        missing += valid ? 0 : 1;
        sums.unit_weights = sums.unit_weights && given == 1;
        sums.covered = sums.covered && w[x] > 0;
        total += w[x];
        first += w[x] * h;
        min = valid && h < min ? h : min;
        max = valid && h > max ? h : max;
    }
    sums.min = min;
    sums.max = max;
    sums.no_data += missing;
    if (!(total > 0))
        return;
    Running row{total, first / total, 0};
    for (int x = 0; x < width; ++x) {
        const double d = w[x] > 0 ? presence[x] - row.mean : 0;
        row.squares += w[x] * d * d;
    }
    sums.height.merge(row);
}

void add_colors(const float* color, const std::vector<double>& weights, Sums& sums)
{
    for (size_t x = 0; x < weights.size(); ++x)
        if (weights[x] > 0)
            for (size_t c = 0; c < 3; ++c)
                sums.color[c] += weights[x] * static_cast<double>(color[3 * x + c]);
}

Sums sums_of(const SurfaceRows& rows, int count, int width)
{
    Sums sums;
    std::vector<double> weights;
    for (int row = 0; row < count; ++row) {
        const auto begin = static_cast<size_t>(row) * static_cast<size_t>(width);
        const double* presence = rows.height.empty() ? &rows.slope_s[begin] : &rows.height[begin];
        add_row(presence, rows.weight.empty() ? nullptr : &rows.weight[begin], width, weights,
                sums);
        if (!rows.color.empty())
            add_colors(&rows.color[3 * begin], weights, sums);
    }
    return sums;
}

/// A strip on its way through the survey.
struct SurveyStrip {
    SurfaceRows rows;
    int first_row = 0, count = 0;
    Sums sums;
};

using StripPtr = std::shared_ptr<SurveyStrip>;

void note_edges(const SurveyStrip& strip, int width, int height, MapEdges& edges)
{
    const std::vector<double>& heights = strip.rows.height;
    for (auto row = heights.begin(); row != heights.end(); row += width) {
        edges[kLeft].height.push_back(row[0]);
        edges[kRight].height.push_back(row[width - 1]);
    }
    if (strip.first_row == 0)
        edges[kTop].height.assign(heights.begin(), heights.begin() + width);
    if (strip.first_row + strip.count == height)
        edges[kBottom].height.assign(heights.end() - width, heights.end());
}

/// 1 where all heights are the same: there is nothing to normalise.
double scale_of(double variance) { return variance > 0 ? std::sqrt(variance) : 1; }

} // namespace

Survey survey_if_any(Source& source, const BakeMonitor& monitor)
{
    const int width = source.width(), height = source.height();
    Survey result;
    Sums all;
    int next_row = 0;
    Pool<StripPtr> used;

    auto read = [&](tbb::flow_control& control) -> StripPtr {
        if (next_row >= height) {
            control.stop();
            return nullptr;
        }
        StripPtr strip = used.take();
        if (!strip)
            strip = std::make_shared<SurveyStrip>();
        strip->first_row = next_row;
        strip->count = std::min(kStripRows, height - next_row);
        source.read(strip->count, strip->rows);
        next_row += strip->count;
        monitor.report("survey", static_cast<double>(next_row) / height);
        return strip;
    };
    auto sum = [&](const StripPtr& strip) {
        strip->sums = sums_of(strip->rows, strip->count, width);
        return strip;
    };
    auto merge = [&](const StripPtr& strip) {
        all.merge(strip->sums);
        if (source.has_heights())
            note_edges(*strip, width, height, result.edges);
        used.give(strip);
    };
    source.rewind(false);
    tbb::parallel_pipeline(
        static_cast<size_t>(tbb::this_task_arena::max_concurrency()) + 1,
        tbb::make_filter<void, StripPtr>(tbb::filter_mode::serial_in_order, read) &
            tbb::make_filter<StripPtr, StripPtr>(tbb::filter_mode::parallel, sum) &
            tbb::make_filter<StripPtr, void>(tbb::filter_mode::serial_in_order, merge));

    result.rejects = source.rejects();
    result.no_data_texels = all.no_data;
    result.weight = all.height.weight;
    if (!(result.weight > 0))
        return result;
    result.has_holes = all.no_data > 0;
    result.complete = all.no_data == 0 && all.unit_weights;
    result.covered = all.covered;
    for (size_t c = 0; c < 3; ++c)
        result.mean_color[c] = static_cast<float>(all.color[c] / all.height.weight);
    if (source.has_heights()) {
        result.h0 = all.height.mean;
        result.height_min = all.min;
        result.height_max = all.max;
        result.variance = all.height.squares / all.height.weight;
        result.h1 = scale_of(result.variance);
    }
    return result;
}

void refuse_without_data(const Source& source)
{
    throw Error(fmt::format("{}: no data in any texel; check --height-channel, --input, --no-data "
                            "and --alpha-weight",
                            source.name()));
}

Survey survey(Source& source, const BakeMonitor& monitor)
{
    Survey found = survey_if_any(source, monitor);
    if (!(found.weight > 0))
        refuse_without_data(source);
    return found;
}

void unite(const std::vector<Survey*>& surveys, const std::vector<double>& areas)
{
    if (surveys.size() < 2)
        return;
    Running heights;
    Sums sums;
    for (size_t i = 0; i < surveys.size(); ++i) {
        const Survey& own = *surveys[i];
        const double weight = own.weight * areas[i];
        heights.merge({weight, own.h0, own.variance * weight});
        sums.min = std::min(sums.min, own.height_min);
        sums.max = std::max(sums.max, own.height_max);
        for (size_t c = 0; c < 3; ++c)
            sums.color[c] += weight * static_cast<double>(own.mean_color[c]);
    }
    for (Survey* own : surveys) {
        own->h0 = heights.mean;
        own->variance = heights.squares / heights.weight;
        own->h1 = scale_of(own->variance);
        own->height_min = sums.min;
        own->height_max = sums.max;
        for (size_t c = 0; c < 3; ++c)
            own->mean_color[c] = static_cast<float>(sums.color[c] / heights.weight);
    }
}

} // namespace scree
