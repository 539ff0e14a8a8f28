#include "stats/slope_map.h"

namespace scree {

namespace {

void map_covariances(const MomentLayout& layout, const SlopeMap* maps, int count, MomentRow row)
{
    double* ss = row.plane(layout.slope_ss);
    double* st = row.plane(layout.slope_st);
    double* tt = row.plane(layout.slope_tt);
    for (int x = 0; x < count; ++x) {
        const auto a = static_cast<double>(maps[x].a), b = static_cast<double>(maps[x].b),
                   c = static_cast<double>(maps[x].c);
        tt[x] = b * b * ss[x] + 2 * b * c * st[x] + c * c * tt[x];
        st[x] = a * (b * ss[x] + c * st[x]);
        ss[x] = a * a * ss[x];
    }
}

/// Of sss sst stt ttt ssss ssst sstt sttt tttt.
void map_tails(const MomentLayout& layout, const SlopeMap* maps, int count, MomentRow row)
{
    double* tail[MomentLayout::kTailPlanes];
    for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
        tail[i] = row.plane(layout.slope_tail + i);
    auto& [sss, sst, stt, ttt, ssss, ssst, sstt, sttt, tttt] = tail;
    for (int x = 0; x < count; ++x) {
        const auto a = static_cast<double>(maps[x].a), b = static_cast<double>(maps[x].b),
                   c = static_cast<double>(maps[x].c);
        const double aa = a * a, bb = b * b, cc = c * c;
        ttt[x] = b * bb * sss[x] + 3 * bb * c * sst[x] + 3 * b * cc * stt[x] + c * cc * ttt[x];
        stt[x] = a * (bb * sss[x] + 2 * b * c * sst[x] + cc * stt[x]);
        sst[x] = aa * (b * sss[x] + c * sst[x]);
        sss[x] = aa * a * sss[x];
        tttt[x] = bb * bb * ssss[x] + 4 * bb * b * c * ssst[x] + 6 * bb * cc * sstt[x] +
                  4 * b * cc * c * sttt[x] + cc * cc * tttt[x];
        sttt[x] =
            a * (bb * b * ssss[x] + 3 * bb * c * ssst[x] + 3 * b * cc * sstt[x] + cc * c * sttt[x]);
        sstt[x] = aa * (bb * ssss[x] + 2 * b * c * ssst[x] + cc * sstt[x]);
        ssst[x] = aa * a * (b * ssss[x] + c * ssst[x]);
        ssss[x] = aa * aa * ssss[x];
    }
}

} // namespace

void map_slopes(const MomentLayout& layout, const SlopeMap* maps, int count, MomentRow moments)
{
    double* s = moments.plane(layout.slope_s);
    double* t = moments.plane(layout.slope_t);
    for (int x = 0; x < count; ++x) {
        const double before = s[x];
        s[x] = static_cast<double>(maps[x].a) * before;
        t[x] = static_cast<double>(maps[x].b) * before + static_cast<double>(maps[x].c) * t[x];
    }
    map_covariances(layout, maps, count, moments);
    if (layout.slope_tail >= 0)
        map_tails(layout, maps, count, moments);
}

} // namespace scree
