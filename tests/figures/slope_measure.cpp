#include "figures/slope_measure.h"

#include <cmath>
#include <functional>

#include "figures/slope_shading.h"

namespace scree::test {
namespace {

using Covariance = filter::Covariance<double>;

double frobenius(const Covariance& a, const Covariance& b)
{
    return std::sqrt((a.ss - b.ss) * (a.ss - b.ss) + 2 * (a.st - b.st) * (a.st - b.st) +
                     (a.tt - b.tt) * (a.tt - b.tt));
}

/// A view of a footprint.
struct Place {
    size_t footprint = 0, view = 0;
};

/// A way to tell the slopes, and the color if it does.
struct Way {
    std::string name;
    std::function<SeenSlopes(const Place&)> slopes;
    std::function<double(const Place&)> color;
};

/// Compares one size of footprints.
class SlopeComparison {
public:
    SlopeComparison(const SlopesOfSize& size, const SlopeViews& views, double rms_slope)
        : size_(size), views_(views), rms_slope_(rms_slope), gain_(fitted_gain(size, views))
    {}

    SlopeSizeFigures run();

private:
    [[nodiscard]] std::vector<Way> ways();
    [[nodiscard]] Way table(size_t harmonics, SlopeTable::Frame frame);
    [[nodiscard]] const reference::Seen& seen(const Place& at) const
    {
        return size_.judged[0][at.footprint].all.seen[at.view];
    }
    [[nodiscard]] const reference::Lit& lit(const Place& at, size_t light, size_t base) const
    {
        const reference::Gathered& all = size_.judged[base][at.footprint].all;
        return all.lit[at.view * views_.lights.size() + light];
    }
    [[nodiscard]] double baked_trace(const Place& at) const
    {
        const Covariance& baked = size_.baked[at.footprint].covariance;
        return baked.ss + baked.tt;
    }
    [[nodiscard]] size_t angle(const Place& at) const { return at.view / SlopeViews::kAzimuths; }

    void for_all(const std::function<void(const Place&)>& work) const;
    WayFigures judge(const Way& way) const;
    void add_slopes(WayFigures& figures, const Place& at, const SeenSlopes& told) const;
    void add_shading(WayFigures& figures, const Place& at, const SeenSlopes& told) const;
    WayFigures judge_kernel(const std::string& name, bool base_masks) const;
    WayFigures judge_noise() const;

    const SlopesOfSize& size_;
    const SlopeViews& views_;
    double rms_slope_;
    SlopeGain gain_;
};

void SlopeComparison::for_all(const std::function<void(const Place&)>& work) const
{
    for (size_t i = 0; i < size_.baked.size(); ++i)
        for (size_t view = 0; view < views_.judged.size(); ++view)
            if (seen({i, view}).area > 0)
                work({i, view});
}

Way SlopeComparison::table(size_t harmonics, SlopeTable::Frame frame)
{
    std::vector<SlopeTable> tables;
    for (const reference::Estimate& fitted : size_.fitted) {
        const std::vector<reference::Seen>& seen = fitted.all.seen;
        tables.emplace_back(views_, seen.front(),
                            std::vector<reference::Seen>(seen.begin() + 1, seen.end()), harmonics,
                            frame);
    }
    const auto told = [this, tables](const Place& at) {
        return tables[at.footprint].at(views_.judged[at.view], size_.baked[at.footprint]);
    };
    return {"table " + std::to_string(harmonics) + (frame == SlopeTable::Frame::map ? ", map" : ""),
            [told](const Place& at) { return told(at).slopes; },
            [told](const Place& at) { return told(at).color; }};
}

std::vector<Way> SlopeComparison::ways()
{
    const auto baked = [this](const Place& at) { return size_.baked[at.footprint]; };
    const auto view = [this](const Place& at) { return views_.judged[at.view]; };
    std::vector<Way> all = {
        {"unchanged", [=](const Place& at) { return unchanged(baked(at)); },
         [this](const Place& at) { return size_.fitted[at.footprint].all.seen.front().color[1]; }},
        {"Gaussian", [=](const Place& at) { return closed_form(view(at), baked(at), 0); }, {}},
        {"K0", [=](const Place& at) { return closed_form(view(at), baked(at), 1); }, {}},
        {"mixture",
         [=](const Place& at) { return closed_form(view(at), baked(at), baked(at).tau); },
         {}},
        {"gain of mean",
         [=](const Place& at) {
             return gained(view(at), baked(at), {gain_.mean, 1});
         },
         {}},
        {"gain of both", [=](const Place& at) { return gained(view(at), baked(at), gain_); }, {}},
    };
    for (const auto frame : {SlopeTable::Frame::view, SlopeTable::Frame::map})
        for (size_t harmonics = 0; harmonics <= 2; ++harmonics)
            all.push_back(table(harmonics, frame));
    all.push_back({"true moments", [this](const Place& at) { return seen_slopes(seen(at)); }, {}});
    return all;
}

void SlopeComparison::add_slopes(WayFigures& figures, const Place& at, const SeenSlopes& told) const
{
    const SeenSlopes truth = seen_slopes(seen(at));
    const double area = seen(at).area;
    figures[Figure::mean][angle(at)].add(area, (told.mean - truth.mean).length(), rms_slope_);
    figures[Figure::covariance][angle(at)].add(area, frobenius(told.covariance, truth.covariance),
                                               baked_trace(at));
}

void SlopeComparison::add_shading(WayFigures& figures, const Place& at,
                                  const SeenSlopes& told) const
{
    const SeenSlopes truth = seen_slopes(seen(at));
    const double area = seen(at).area;
    const Vec3& wo = views_.judged[at.view];
    for (size_t light = 0; light < views_.lights.size(); ++light) {
        const Vec3& wi = views_.lights[light];
        const double open = shadowing(wo, wi, size_.baked[at.footprint]);
        const double diffuse = diffuse_of(told, open, wi);
        const double true_diffuse = lit(at, light, 0).diffuse[0];
        figures[Figure::diffuse_by_moments][angle(at)].add(
            area, diffuse - diffuse_of(truth, open, wi), true_diffuse);
        figures[Figure::diffuse][angle(at)].add(area, diffuse - true_diffuse, true_diffuse);
        for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
            const double specular = specular_of(told, open, wo, wi, kBaseAlphas[base]);
            const double true_specular = lit(at, light, base).specular;
            figures[kSpecularByMoments[base]][angle(at)].add(
                area, specular - specular_of(truth, open, wo, wi, kBaseAlphas[base]),
                true_specular);
            figures[kSpecular[base]][angle(at)].add(area, specular - true_specular, true_specular);
        }
    }
}

WayFigures SlopeComparison::judge(const Way& way) const
{
    WayFigures figures{way.name, {}};
    for_all([&](const Place& at) {
        const SeenSlopes told = way.slopes(at);
        add_slopes(figures, at, told);
        add_shading(figures, at, told);
        if (way.color)
            figures[Figure::color][angle(at)].add(seen(at).area, way.color(at) - seen(at).color[1],
                                                  1);
    });
    return figures;
}

WayFigures SlopeComparison::judge_kernel(const std::string& name, bool base_masks) const
{
    WayFigures figures{name, {}};
    for_all([&](const Place& at) {
        const filter::Slopes<double>& baked = size_.baked[at.footprint];
        const Vec3& wo = views_.judged[at.view];
        for (size_t light = 0; light < views_.lights.size(); ++light)
            for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
                const Vec3& wi = views_.lights[light];
                const double specular =
                    base_masks ? filter::specular(wo, wi, baked, kBaseAlphas[base])
                               : specular_without_base_masking(wo, wi, baked, kBaseAlphas[base]);
                const double truth = lit(at, light, base).specular;
                figures[kSpecular[base]][angle(at)].add(seen(at).area, specular - truth, truth);
            }
    });
    return figures;
}

WayFigures SlopeComparison::judge_noise() const
{
    WayFigures figures{"noise", {}};
    for_all([&](const Place& at) {
        const auto& halves = size_.judged[0][at.footprint].halves;
        const reference::Seen &one = halves[0].seen[at.view], &other = halves[1].seen[at.view];
        if (!(one.area > 0 && other.area > 0))
            return;
        const double area = seen(at).area;
        const SeenSlopes a = seen_slopes(one), b = seen_slopes(other);
        figures[Figure::mean][angle(at)].add(area, (a.mean - b.mean).length() / 2, rms_slope_);
        figures[Figure::covariance][angle(at)].add(area, frobenius(a.covariance, b.covariance) / 2,
                                                   baked_trace(at));
        figures[Figure::color][angle(at)].add(area, (one.color[1] - other.color[1]) / 2, 1);
        for (size_t light = 0; light < views_.lights.size(); ++light) {
            const size_t pair = at.view * views_.lights.size() + light;
            figures[Figure::diffuse][angle(at)].add(
                area, (halves[0].lit[pair].diffuse[0] - halves[1].lit[pair].diffuse[0]) / 2,
                lit(at, light, 0).diffuse[0]);
            for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
                const auto& of_base = size_.judged[base][at.footprint].halves;
                figures[kSpecular[base]][angle(at)].add(
                    area, (of_base[0].lit[pair].specular - of_base[1].lit[pair].specular) / 2,
                    lit(at, light, base).specular);
            }
        }
    });
    return figures;
}

SlopeSizeFigures SlopeComparison::run()
{
    SlopeSizeFigures all{size_.name, gain_, 0, {}};
    for (const filter::Slopes<double>& baked : size_.baked)
        all.tau += baked.tau / static_cast<double>(size_.baked.size());
    for (const Way& way : ways())
        all.ways.push_back(judge(way));
    all.ways.push_back(judge_kernel("kernel", true));
    all.ways.push_back(judge_kernel("kernel, base not masking", false));
    all.ways.push_back(judge_noise());
    return all;
}

} // namespace

SlopeSizeFigures measure_slopes(const SlopesOfSize& size, const SlopeViews& views, double rms_slope)
{
    return SlopeComparison(size, views, rms_slope).run();
}

} // namespace scree::test
