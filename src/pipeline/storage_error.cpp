#include "pipeline/storage_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stats/kurtosis.h"
#include "texset/mip_file.h"

namespace scree {

StorageError::StorageError(Map map, const MomentLayout& layout, const ValueScale& scale, int width,
                           int height)
    : map_(map), layout_(layout), scale_(scale)
{
    for (int l = 0; l < level_count(width, height); ++l) {
        const int level_width = std::max(1, width >> l);
        blocks_.emplace_back(
            static_cast<size_t>((level_width + kBlockColumns - 1) / kBlockColumns));
    }
}

namespace {

/// Less area than this, relative, no reader divides by; see scree_color_by_visibility.
constexpr double kLeastSeen = 1.0 / 4;

/// Error of the covariance of x and y recovered from E[x], E[y], E[xy].
double covariance_error(double x, double y, double xy, double truth)
{
    return std::abs(xy - x * y - truth);
}

} // namespace

/// Of world heights, as bumpslopes has them, over their deviation h1.
template <class Store>
double StorageError::world_height_error(MomentRow row, int count) const
{
    const double* heights = row.plane(layout_.height);
    double largest = 0;
    for (int i = 0; i < count; ++i) {
        const double height = scale_.h0 + scale_.h1 * heights[i];
        const double stored = Store::value(Store::nearest(height));
        // Beyond the range, where it is infinite: lost.
        largest = std::max(largest, std::isfinite(stored) ? std::abs(stored - height) : kLost);
    }
    return largest / scale_.h1;
}

template <class Store>
double StorageError::largest_error(int level, MomentRow row, int count) const
{
    using Bits = typename Store::Bits;
    Bits values[kMostChannels][kTileSize];
    Bits* stored[kMostChannels];
    for (int c = 0; c < kMostChannels; ++c)
        stored[c] = values[c];
    texture_values<Store>(map_, layout_, level, row, count, scale_, stored);

    auto value = [&](int channel, int i) { return Store::value(values[channel][i]); };
    auto truth = [&](int plane, int i) { return row.plane(plane)[i]; };
    double largest = 0;
    // Infinite and NaN (infinity minus infinity) alike: lost, whatever the yardstick.
    auto note = [&](double error) {
        largest = std::isfinite(error) ? std::max(largest, error)
                                       : std::numeric_limits<double>::infinity();
    };
    auto note_slope = [&](int i, int s, int t, int ss, int tt, int st) {
        note(covariance_error(value(s, i), value(s, i), value(ss, i), truth(layout_.slope_ss, i)));
        note(covariance_error(value(t, i), value(t, i), value(tt, i), truth(layout_.slope_tt, i)));
        note(covariance_error(value(s, i), value(t, i), value(st, i), truth(layout_.slope_st, i)));
    };
    // Products with another texture's mean: its rounding is that texture's error, not this one's.
    auto note_product = [&](int channel, int covariance, int x, int y, int i) {
        note(covariance_error(truth(x, i), truth(y, i), value(channel, i), truth(covariance, i)));
    };
    // The color told from a component, to first order, where the view sees the mean over the
    // azimuth.
    auto note_seen = [&](int component, int i) {
        const int first = MomentLayout::kVisiblePlanes * component;
        const int mean = component / layout_.visible_terms * layout_.visible_terms;
        const double seen = 1 + truth(layout_.visible + MomentLayout::kVisiblePlanes * mean, i);
        const double per_seen = 1 / std::max(seen, kLeastSeen);
        const double area_error = value(first, i) - truth(layout_.visible + first, i);
        for (int c = 0; c < 3; ++c) {
            const int at = first + 3 - c; // B G R
            const double error = value(at, i) - truth(layout_.visible + at, i);
            note(std::abs(error - area_error * truth(layout_.color + c, i)) * per_seen);
        }
    };
    auto note_weight = [&](double kept, double weight) {
        note(weight > 0 ? std::abs(kept / weight - 1) : kept);
    };
    for (int i = 0; i < count; ++i) {
        switch (map_) {
        case Map::slope:
            note_slope(i, 0, 3, 1, 4, 2);
            break;
        case Map::bumpslopes:
            note_slope(i, 1, 2, 3, 4, 5);
            break;
        case Map::height:
            note(covariance_error(value(0, i), value(0, i), value(1, i),
                                  truth(layout_.height_var, i)));
            break;
        case Map::color:
            for (int c = 0; c < 3; ++c)
                note(std::abs(value(c, i) - truth(layout_.color + c, i)));
            break;
        case Map::colorheight:
            for (int c = 0; c < 3; ++c)
                note_product(c, layout_.color_height + c, layout_.color + c, layout_.height, i);
            break;
        case Map::colorslope:
            for (int c = 0; c < 3; ++c) {
                note_product(4 - 2 * c, layout_.color_slope_s + c, layout_.color + c,
                             layout_.slope_s, i);
                note_product(5 - 2 * c, layout_.color_slope_t + c, layout_.color + c,
                             layout_.slope_t, i);
            }
            break;
        case Map::rank: {
            const int terms = layout_.rank_terms;
            for (int n = 0; n < terms; ++n)
                for (int c = 0; c < 3; ++c)
                    note(std::abs(value((2 - c) * terms + n, i) -
                                  truth(layout_.rank + 3 * n + c, i)));
            break;
        }
        case Map::visible:
            for (int n = 0; n < layout_.visible_components; ++n)
                note_seen(n, i);
            break;
        case Map::tail:
            note(std::abs(value(0, i) - tail_of(layout_, row, i).tau));
            break;
        case Map::coverage:
            note_weight(value(0, i), truth(MomentLayout::weight, i));
            break;
        case Map::exponent: // float, always
        case Map::map:
            break;
        }
    }
    return largest;
}

void StorageError::texels(int level, int /*y*/, int x0, int count, MomentRow row)
{
    if (map_ == Map::visible && level < kFirstSeenLevel)
        return;
    auto& blocks = blocks_[static_cast<size_t>(level)];
    Largest& own = blocks[static_cast<size_t>(x0 / kBlockColumns)];
    for (int x = 0; x < count; x += kTileSize) {
        const int run = std::min(kTileSize, count - x);
        own.half = std::max(own.half, largest_error<StoreHalf>(level, row.from(x), run));
        own.single = std::max(own.single, largest_error<StoreFloat>(level, row.from(x), run));
    }
    if (map_ == Map::bumpslopes && scale_.has_height) {
        own.half_height = std::max(own.half_height, world_height_error<StoreHalf>(row, count));
        own.single_height = std::max(own.single_height, world_height_error<StoreFloat>(row, count));
    }
    auto raise = [count](double& largest, const double* values) {
        for (int i = 0; i < count; ++i)
            largest = std::max(largest, std::abs(values[i]));
    };
    if (layout_.slope_ss >= 0) {
        raise(own.variance, row.plane(layout_.slope_ss));
        raise(own.variance, row.plane(layout_.slope_tt));
        double s = 0, t = 0;
        raise(s, row.plane(layout_.slope_s));
        raise(t, row.plane(layout_.slope_t));
        own.square = std::max({own.square, s * s, t * t});
    }
    if (layout_.color >= 0)
        for (int c = 0; c < 3; ++c)
            raise(own.color, row.plane(layout_.color + c));

    if (level + 1 == static_cast<int>(blocks_.size())) { // the one texel of the last level
        if (layout_.color_var >= 0)
            for (int c = 0; c < 3; ++c)
                color_deviation_ =
                    std::max(color_deviation_, std::sqrt(row.plane(layout_.color_var + c)[0]));
        if (layout_.slope_ss >= 0)
            slope_deviation_ =
                std::sqrt(std::max(row.plane(layout_.slope_ss)[0], row.plane(layout_.slope_tt)[0]));
        largest_color_ = own.color;
    }
}

StorageError::Largest StorageError::largest_of(size_t level) const
{
    Largest all;
    for (const Largest& block : blocks_[level]) {
        all.half = std::max(all.half, block.half);
        all.single = std::max(all.single, block.single);
        all.half_height = std::max(all.half_height, block.half_height);
        all.single_height = std::max(all.single_height, block.single_height);
        all.variance = std::max(all.variance, block.variance);
        all.square = std::max(all.square, block.square);
        all.color = std::max(all.color, block.color);
    }
    return all;
}

double StorageError::yardstick(const Largest& level, const Largest& next) const
{
    constexpr double kResolved = 1e-6; // of a mean square: the error of float, some 10 times
    constexpr double kSeen = 0.1;      // of the largest color: a percent of it nobody sees
    switch (map_) {
    case Map::slope:
    case Map::bumpslopes: {
        const double variance = std::max(level.variance, next.variance);
        return std::max(variance, kResolved * (level.square + level.variance));
    }
    case Map::color:
    case Map::visible: // read as a color
        return level.color;
    case Map::colorheight:
    case Map::rank:
        return std::max(color_deviation_, kSeen * largest_color_);
    case Map::colorslope:
        return std::max(color_deviation_, kSeen * largest_color_) * slope_deviation_;
    case Map::height:
    case Map::exponent:
    case Map::map:
    case Map::tail:
    case Map::coverage:
        break;
    }
    return 1;
}

double StorageError::relative(double Largest::*error, double Largest::*height_error) const
{
    double largest = 0;
    for (size_t l = 0; l < blocks_.size(); ++l) {
        const Largest level = largest_of(l);
        const Largest next = largest_of(std::min(l + 1, blocks_.size() - 1));
        if (level.*error > 0)
            largest = std::max(largest, level.*error / yardstick(level, next));
        largest = std::max(largest, level.*height_error);
    }
    return std::min(largest, kLost);
}

double StorageError::half_error() const { return relative(&Largest::half, &Largest::half_height); }

double StorageError::float_error() const
{
    return relative(&Largest::single, &Largest::single_height);
}

} // namespace scree
