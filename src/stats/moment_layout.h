#pragma once

#include <array>
#include <vector>

namespace scree {

/// Which statistics of a footprint are carried.
struct MomentSet {
    bool slope = true;         ///< mean and covariance of the slope
    bool tail = false;         ///< its third and fourth central moments (needs slope)
    bool height = false;       ///< mean and variance of the normalised height
    bool color = false;        ///< mean color
    bool color_height = false; ///< variance of color, its covariance with height (needs both)
    bool color_slope = false;  ///< variance of color, its covariance with the slope (needs both)
    int rank_terms = 0;        ///< coefficients of the color by height rank (needs color, height)
    int visible_nodes = 0;     ///< of a table of visibility (needs color)
    int visible_terms = 1;     ///< of a node, the one from all sides first
    int tried = 0;             ///< components of another table, to choose from (needs color)
    int views = 0;             ///< single views (needs color)
};

/// Where each statistic of a footprint lies among the planes of a row.
///
/// A row of texels is stored as planes of `double`, one a statistic: the weight first, then
/// means, then central moments. Plane indices are -1 for what is not carried. Merging needs no
/// more than these lists, so a new pair of variables is one more line here.
struct MomentLayout {
    /// cov(a, b), with a and b indices into `means`.
    struct Covariance {
        int plane;
        int a;
        int b;
    };

    explicit MomentLayout(const MomentSet& set);

    int planes = 1;
    int merged_planes = 1; ///< the first ones, which merge() makes; the rest is merged elsewhere
    static constexpr int kMaxMergedPlanes = 32;
    int texel_planes = 1; ///< the first ones, which texels of level 0 have; see MomentRow::seen
    static constexpr int weight = 0; ///< coverage in [0, 1]; 0 is no data

    int slope_s = -1, slope_t = -1;
    int slope_ss = -1, slope_tt = -1, slope_st = -1;
    /// Central moments sss sst stt ttt ssss ssst sstt sttt tttt, in consecutive planes.
    int slope_tail = -1;
    static constexpr int kTailPlanes = 9;

    int height = -1, height_var = -1;

    int color = -1;                             ///< R G B, consecutive
    int color_var = -1, color_height = -1;      ///< R G B, consecutive
    int color_slope_s = -1, color_slope_t = -1; ///< R G B, consecutive

    int rank = -1;      ///< a_1 of R G B, a_2 of R G B, ... (stats/ranks.h), consecutive
    int rank_terms = 0; ///< how many of them

    /// Of each component of a table of visibility E[v], E[B v], E[G v], E[R v] with v what it sees
    /// more than the mean (visibility/view_components.h), consecutive; of the table tried and of
    /// single views likewise. From level 1 on: a texel of level 0 has one color.
    int visible = -1, tried = -1, views = -1;
    int visible_components = 0; ///< nodes times terms, node by node
    int visible_terms = 1;
    int tried_components = 0;
    int view_count = 0;
    static constexpr int kVisiblePlanes = 4; ///< of a component, of a view
    /// Of both tables and the views, one after the other in this order.
    [[nodiscard]] int seen_components() const
    {
        return visible_components + tried_components + view_count;
    }

    std::vector<int> means;              ///< planes of the means
    std::vector<Covariance> covariances; ///< all second central moments
};

/// One row of texels: `planes` arrays of doubles, `stride` apart; of level 0 `texel_planes`.
struct MomentRow {
    double* data = nullptr;
    int stride = 0;
    float* seen = nullptr; ///< of level 0: v of each component, as many arrays, `stride` apart

    [[nodiscard]] double* plane(int index) const
    {
        return data + static_cast<long>(index) * stride;
    }
    /// The same row from texel x on.
    [[nodiscard]] MomentRow from(int x) const
    {
        return {data + x, stride, seen == nullptr ? nullptr : seen + x};
    }
    [[nodiscard]] float* seen_of(int component) const
    {
        return seen + static_cast<long>(component) * stride;
    }
};

} // namespace scree
