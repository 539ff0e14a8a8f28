#include "pipeline/strip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "stats/merge.h"

namespace scree {

Edge edge_of(Wrap wrap, Reconstruction reconstruction)
{
    switch (wrap) {
    case Wrap::periodic:
        return Edge::periodic;
    case Wrap::clamp:
        // maketx repeats the border texel under its Sobel; `sobel` is there to match it.
        return reconstruction == Reconstruction::sobel ? Edge::repeat : Edge::extend;
    case Wrap::mirror:
        return Edge::repeat;
    case Wrap::black:
        break;
    }
    return Edge::zero;
}

namespace {

/// Where surroundings say what goes on beyond the edge, nothing else does.
Edge edge_around(Wrap wrap, const BakeOptions& options, const Surroundings* around)
{
    if (around != nullptr && wrap == Wrap::periodic)
        wrap = Wrap::clamp;
    return edge_of(wrap, options.reconstruction);
}

/// Takes what is there of surroundings.
void take(double around, double& height)
{
    if (around != kNothingBeyond)
        height = around;
}

/// The same of a row above or below the map; its ends, where only they are not there, go on from
/// what is.
void take_row(const std::vector<double>& around, Edge edge, std::vector<double>& row)
{
    const size_t last = row.size() - 1;
    for (size_t x = 1; x < last; ++x)
        take(around[x], row[x]);
    std::vector<double> padded = row;
    pad_row(padded.data(), static_cast<int>(last) - 1, edge);
    for (const auto& [end, beside] : {std::pair(size_t{0}, size_t{1}), std::pair(last, last - 1)}) {
        if (around[beside] != kNothingBeyond)
            row[end] = padded[end];
        take(around[end], row[end]);
    }
}

} // namespace

StripReader::StripReader(Source& source, const Survey& survey, const BakeOptions& options,
                         VisibleBands* seen, bool last_time)
    : source_(source), survey_(survey), seen_(seen),
      around_(survey.around ? &*survey.around : nullptr),
      edge_s_(edge_around(options.wrap_s, options, around_)),
      edge_t_(edge_around(options.wrap_t, options, around_))
{
    source_.rewind(last_time);
    read_ahead();
}

void StripReader::pad(const double* heights, int y, std::vector<double>& row) const
{
    const int width = source_.width();
    row.resize(static_cast<size_t>(width) + 2);
    std::copy_n(heights, width, row.begin() + 1);
    pad_row(row.data(), width, edge_s_);
    if (around_ == nullptr)
        return;
    take(around_->left[static_cast<size_t>(y)], row.front());
    take(around_->right[static_cast<size_t>(y)], row.back());
}

std::vector<double> StripReader::beyond(Side side, const std::vector<double>& last,
                                        const std::vector<double>& before_last) const
{
    const int other = side == kTop ? source_.height() - 1 : 0;
    std::vector<double> far;
    pad(survey_.edges[opposite(side)].height.data(), other, far);
    std::vector<double> row = row_beyond(edge_t_, last, before_last, far);
    if (around_ != nullptr)
        take_row(side == kTop ? around_->above : around_->below, edge_s_, row);
    return row;
}

void StripReader::read_ahead()
{
    const int count = std::min(kStripRows, source_.height() - next_row_);
    if (count <= 0)
        return;
    source_.read(count, ahead_);
    if (!source_.has_heights())
        return;
    // Rows 1 to count; 0 and count + 1 are what lies above and below, which next() knows.
    ahead_padded_.resize(static_cast<size_t>(count) + 2);
    for (int row = 0; row < count; ++row)
        pad(ahead_.height.data() + static_cast<ptrdiff_t>(row) * source_.width(), next_row_ + row,
            ahead_padded_[static_cast<size_t>(row) + 1]);
}

bool StripReader::next(Strip& strip)
{
    const int height = source_.height();
    if (next_row_ >= height)
        return false;
    strip.first_row = next_row_;
    strip.count = std::min(kStripRows, height - next_row_);
    std::swap(strip.rows, ahead_);
    std::swap(strip.rows.height, ahead_.height); // stays here: the padded rows hold it all
    strip.rows.height.clear();
    std::swap(strip.padded, ahead_padded_);
    strip.seen = seen_ != nullptr ? seen_->with_row(strip.first_row) : nullptr;
    next_row_ += strip.count;
    read_ahead();
    if (!source_.has_heights())
        return true;

    const auto count = static_cast<size_t>(strip.count);
    const std::vector<double>& first = strip.padded[1];
    const std::vector<double>& last = strip.padded[count];
    if (strip.first_row > 0)
        strip.padded[0] = above_;
    else
        strip.padded[0] = beyond(kTop, first, strip.padded[height > 1 ? 2 : 1]);
    if (next_row_ < height)
        strip.padded[count + 1] = ahead_padded_[1];
    else // The row before the last is the one above in a strip of one row.
        strip.padded[count + 1] = beyond(kBottom, last, strip.padded[height > 1 ? count - 1 : 1]);
    above_ = last;
    return true;
}

TexelMoments::TexelMoments(const MomentLayout& layout, const Survey& survey,
                           const BakeOptions& options, const MappedColor* mapped, int width,
                           double texel_width, double texel_height)
    : layout_(layout), survey_(survey), mapped_(mapped), reconstruction_(options.reconstruction),
      width_(width), texel_width_(texel_width), texel_height_(texel_height)
{}

namespace {

/// Slopes of a normal map: one a texel, no spread inside it.
void given_slopes(const MomentLayout& layout, const double* slope_s, const double* slope_t,
                  int count, MomentRow out)
{
    double* s = out.plane(layout.slope_s);
    double* t = out.plane(layout.slope_t);
    for (int x = 0; x < count; ++x) {
        const bool valid = !std::isnan(slope_s[x]);
        s[x] = valid ? slope_s[x] : 0;
        t[x] = valid ? slope_t[x] : 0;
    }
}

} // namespace

void TexelMoments::fill(const Strip& strip, int y, int x0, int count, MomentRow out) const
{
    // What a texel has no spread of is 0; slopes of heights are set whole below.
    const bool slopes_follow = layout_.slope_s >= 0 && !strip.padded.empty();
    for (const auto& covariance : layout_.covariances) {
        const bool of_slope = covariance.a < 2 && covariance.b < 2;
        if (!(slopes_follow && of_slope))
            std::fill_n(out.plane(covariance.plane), count, 0.0);
    }
    if (layout_.slope_tail >= 0 && !slopes_follow)
        for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
            std::fill_n(out.plane(layout_.slope_tail + i), count, 0.0);

    const auto row = static_cast<size_t>(y - strip.first_row);
    const size_t begin = row * static_cast<size_t>(width_) + static_cast<size_t>(x0);
    const SurfaceRows& in = strip.rows;
    const double* presence =
        strip.padded.empty() ? &in.slope_s[begin] : strip.padded[row + 1].data() + 1 + x0;

    double* weight = out.plane(MomentLayout::weight);
    for (int x = 0; x < count; ++x) {
        const double w =
            in.weight.empty() ? 1 : static_cast<double>(in.weight[begin + static_cast<size_t>(x)]);
        weight[x] = std::isnan(presence[x]) ? 0 : w;
    }
    if (layout_.slope_s >= 0 && strip.padded.empty())
        given_slopes(layout_, &in.slope_s[begin], &in.slope_t[begin], count, out);
    if (slopes_follow) {
        const HeightRows heights{strip.padded[row].data() + x0, strip.padded[row + 1].data() + x0,
                                 strip.padded[row + 2].data() + x0};
        const auto moments = survey_.has_holes ? slope_moments_with_holes : slope_moments;
        for (int done = 0; done < count; done += kMergeRun)
            moments(layout_, reconstruction_, heights.from(done), std::min(kMergeRun, count - done),
                    texel_width_, texel_height_, out.from(done));
        if (!in.slope_map.empty())
            map_slopes(layout_, &in.slope_map[begin], count, out);
    }
    if (layout_.height >= 0)
        fill_heights(presence, count, out);
    if (layout_.color >= 0 && mapped_ != nullptr)
        fill_mapped_colors(presence, count, out);
    else if (layout_.color >= 0)
        fill_colors(&in.color[3 * begin], count, out);
    if (strip.seen)
        fill_seen(*strip.seen, y, x0, count, out);
}

void TexelMoments::fill_heights(const double* heights, int count, MomentRow out) const
{
    double* h = out.plane(layout_.height);
    const double per_h1 = 1 / survey_.h1;
    for (int x = 0; x < count; ++x)
        h[x] = std::isnan(heights[x]) ? 0 : (heights[x] - survey_.h0) * per_h1;
}

// A texel without data holds the map's mean color, for what a filter blends in beyond the gutter.

void TexelMoments::fill_colors(const float* rgb, int count, MomentRow out) const
{
    const double* weight = out.plane(MomentLayout::weight);
    for (int c = 0; c < 3; ++c) {
        double* mean = out.plane(layout_.color + c);
        const double fill = static_cast<double>(survey_.mean_color[static_cast<size_t>(c)]);
        for (int x = 0; x < count; ++x)
            mean[x] = weight[x] > 0 ? static_cast<double>(rgb[3 * x + c]) : fill;
    }
}

void TexelMoments::fill_mapped_colors(const double* heights, int count, MomentRow out) const
{
    const double* weight = out.plane(MomentLayout::weight);
    const bool by_slope = mapped_->by != MapBy::height;
    const double* s = by_slope ? out.plane(layout_.slope_s) : nullptr;
    const double* t = by_slope ? out.plane(layout_.slope_t) : nullptr;
    const Rgb fill = mapped_->without_data(survey_);
    for (int x = 0; x < count; ++x) {
        const Rgb color = !(weight[x] > 0) ? fill
                          : by_slope       ? mapped_->at(0, s[x], t[x])
                                           : mapped_->at(heights[x], 0, 0);
        for (int c = 0; c < 3; ++c)
            out.plane(layout_.color + c)[x] = color[static_cast<size_t>(c)];
    }
}

void TexelMoments::fill_seen(const VisibleBand& seen, int y, int x0, int count, MomentRow out) const
{
    assert(x0 / kSweptColumns == (x0 + count - 1) / kSweptColumns); // one block of the band
    const double* weight = out.plane(MomentLayout::weight);
    for (int component = 0; component < layout_.seen_components(); ++component) {
        const float* excess = seen.at(component, x0, y);
        float* area = out.seen_of(component);
        for (int x = 0; x < count; ++x)
            area[x] = weight[x] > 0 ? excess[x] : 0;
    }
}

} // namespace scree
