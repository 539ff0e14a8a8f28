#include "stats/moment_layout.h"

#include <cstddef>

namespace scree {

MomentLayout::MomentLayout(const MomentSet& set)
{
    auto mean = [this] {
        means.push_back(planes);
        return planes++;
    };
    auto index_of = [this](int plane) {
        int index = 0;
        while (means[static_cast<size_t>(index)] != plane)
            ++index;
        return index;
    };
    auto covariance = [&](int plane_a, int plane_b) {
        covariances.push_back({planes, index_of(plane_a), index_of(plane_b)});
        return planes++;
    };
    auto color_covariance = [&](int other) {
        const int first = covariance(color, other);
        covariance(color + 1, other);
        covariance(color + 2, other);
        return first;
    };

    if (set.slope) {
        slope_s = mean();
        slope_t = mean();
    }
    if (set.height)
        height = mean();
    if (set.color) {
        color = mean();
        mean();
        mean();
    }

    if (set.slope) {
        slope_ss = covariance(slope_s, slope_s);
        slope_tt = covariance(slope_t, slope_t);
        slope_st = covariance(slope_s, slope_t);
    }
    if (set.height)
        height_var = covariance(height, height);
    if (set.color && (set.color_height || set.color_slope)) {
        color_var = covariance(color, color);
        covariance(color + 1, color + 1);
        covariance(color + 2, color + 2);
    }
    if (set.color && set.color_height && set.height)
        color_height = color_covariance(height);
    if (set.color && set.color_slope && set.slope) {
        color_slope_s = color_covariance(slope_s);
        color_slope_t = color_covariance(slope_t);
    }
    if (set.slope && set.tail) {
        slope_tail = planes;
        planes += kTailPlanes;
    }
    merged_planes = planes;
    if (set.rank_terms > 0 && set.color && set.height) {
        rank_terms = set.rank_terms;
        rank = planes;
        planes += 3 * rank_terms;
    }
    texel_planes = planes;
    if (set.visible_nodes > 0 && set.color) {
        visible_terms = set.visible_terms;
        visible_components = set.visible_nodes * visible_terms;
        visible = planes;
        planes += kVisiblePlanes * visible_components;
    }
    if (set.tried > 0 && set.color) {
        tried_components = set.tried;
        tried = planes;
        planes += kVisiblePlanes * tried_components;
    }
    if (set.views > 0 && set.color) {
        view_count = set.views;
        views = planes;
        planes += kVisiblePlanes * view_count;
    }
}

} // namespace scree
