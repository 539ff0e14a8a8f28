#include <algorithm>
#include <cmath>
#include <utility>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/plain_code.h"
#include "failures/surfaces.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

double cot_deg(double angle) { return std::tan((90 - angle) * kPi / 180); }

// --- 7 -------------------------------------------------------------------------------------------

/// A share of the surface that has one slope, along the view.
struct Facet {
    double share, slope;
};

/// 1 / (1 + Lambda), Lambda = E[max(0, slope - cot)] / (cot - E[slope]), by its definition.
double g1_by_definition(const std::vector<Facet>& facets, double angle)
{
    const double cot = cot_deg(angle);
    double hidden = 0, mean = 0;
    for (const Facet& facet : facets) {
        hidden += facet.share * std::max(0.0, facet.slope - cot);
        mean += facet.share * facet.slope;
    }
    return 1 / (1 + hidden / (cot - mean));
}

/// Dunes: rising by 0.25 over 12 texels, falling by 0.75 over 4.
MemorySource dunes()
{
    return heights_of(
        64, 32, [](int x, int) { return x % 16 < 12 ? 0.25 * (x % 16) : 0.75 * (16 - x % 16); });
}

/// G1 of a map by Smith's Gaussian formula with maketx's mean and variance.
std::optional<double> maketx_g1(const std::optional<std::vector<Image>>& levels, double angle)
{
    return of_levels(levels, [=](const std::vector<Image>& found) {
        return plain_g1(cot_deg(angle), static_cast<double>(found.back().at(0, 0, kMeanS)),
                        std::sqrt(variance_of_top(found)));
    });
}

Measured few_slopes()
{
    const auto levels_of = [](const MemorySource& map) {
        return maketx_levels(height_image(map), "-d float --wrap periodic");
    };
    const auto of_groove = levels_of(v_groove(64, 32, 0.5)), of_dunes = levels_of(dunes());
    BakedSet groove = baked(v_groove(64, 32, 0.5), plain_options());
    BakedSet dune = baked(dunes(), plain_options());
    Measured all;
    const auto add_g1 = [&](const std::string& what, const std::vector<Facet>& facets,
                            const std::optional<std::vector<Image>>& levels, const SetTexel& texel,
                            double angle, double azimuth, double bound) {
        all.figures.push_back(
            Figure(what + ": G1 at " + degrees(angle), g1_by_definition(facets, angle))
                .peer("Smith, maketx's moments", maketx_g1(levels, angle))
                .ours(g1_of(slopes_of(texel), toward(angle, azimuth)))
                .bound(bound));
    };
    const std::vector<Facet> roof = {{0.5, -0.5}, {0.5, 0.5}};
    add_g1("groove", roof, of_groove, groove.top(), 80, 0, 0.14);
    add_g1("groove", roof, of_groove, groove.top(), 60, 0, 0.06);
    add_g1("groove", roof, of_groove, groove.top(), 70, 0, 0.001);
    add_g1("groove", roof, of_groove, groove.top(), 75, 0, 0.07);
    add_g1("groove", roof, of_groove, groove.top(), 85, 0, 0.20);
    add_g1("dunes from the steep side", {{0.75, 0.25}, {0.25, -0.75}}, of_dunes, dune.top(), 75, 0,
           0.25);
    add_g1("dunes from the gentle side", {{0.75, -0.25}, {0.25, 0.75}}, of_dunes, dune.top(), 75,
           180, 0.25);

    const auto seen = filter::visible_slopes(toward(75), slopes_of(groove.top()));
    all.figures.push_back(Figure("groove: mean slope seen from 75 degrees", -0.5)
                              .ours(static_cast<double>(seen.mean.x))
                              .bound(0.03));
    all.figures.push_back(Figure("groove: E[ss]", 0.25)
                              .peer("maketx", of_top(of_groove, kMeanSs))
                              .ours(mean_ss(groove.top()))
                              .bound(1e-6));
    all.figures.push_back(
        Figure("groove: kurtosis", 8.0 / 3).ours(*groove.summary().kurtosis).bound(1e-5));
    add_words(all, flags_of("the groove", v_groove(64, 32, 0.5)));
    add_words(all, flags_of("the dunes", dunes()));
    return all;
}

// --- 8 -------------------------------------------------------------------------------------------

/// Digits of i in a base, mirrored at the point: an even cover of [0, 1).
double halton(unsigned i, unsigned base)
{
    double value = 0, digit = 1;
    for (; i > 0; i /= base) {
        digit /= base;
        value += digit * (i % base);
    }
    return value;
}

/// A normal map of 256x256 Gaussian slopes, their variance sigma^2 times scale(u), u even in (0,
/// 1).
template <class Scale>
MemorySource gaussian_mixture(double sigma, Scale scale)
{
    unsigned next = 0;
    return slope_map_of(256, 256, [&](int, int) {
        ++next;
        const double square = -2 * std::log(1 - halton(next, 2)) * scale(halton(next, 5));
        const double angle = 2 * kPi * halton(next, 3), length = sigma * std::sqrt(square);
        return std::array<double, 2>{length * std::cos(angle), length * std::sin(angle)};
    });
}

/// Lambda by its definition over the map's own slopes.
double lambda_by_definition(const MemorySource& map, double angle)
{
    const double cot = cot_deg(angle);
    return mean_of_slopes(map, [=](double s, double) { return std::max(0.0, s - cot); }) /
           (cot - mean_of_slopes(map, [](double s, double) { return s; }));
}

/// Mardia's kurtosis of the map's own slopes.
double kurtosis_by_definition(const MemorySource& map)
{
    const auto mean_of = [&](auto of) { return mean_of_slopes(map, of); };
    const double ms = mean_of([](double s, double) { return s; });
    const double mt = mean_of([](double, double t) { return t; });
    const double ss = mean_of([=](double s, double) { return (s - ms) * (s - ms); });
    const double tt = mean_of([=](double, double t) { return (t - mt) * (t - mt); });
    const double st = mean_of([=](double s, double t) { return (s - ms) * (t - mt); });
    return mean_of([=](double s, double t) {
        const double a = s - ms, b = t - mt;
        const double square = (tt * a * a - 2 * st * a * b + ss * b * b) / (ss * tt - st * st);
        return square * square;
    });
}

/// Lambda of two materials side by side, each from its own set: all that faces the view over what
/// of the plane does.
double lambda_of_both(const SetTexel& a, double share_of_a, const SetTexel& b, const Vec3f& view)
{
    double facing = 0, plane = 0;
    for (const auto& [texel, share] : {std::pair(a, share_of_a), std::pair(b, 1 - share_of_a)}) {
        const auto slopes = slopes_of(texel);
        facing += share * static_cast<double>(filter::projected_area(view, slopes));
        plane += share * static_cast<double>(view.z - view.x * slopes.mean.x);
    }
    return facing / plane - 1;
}

struct Bounded {
    double angle, bound;
};

/// Lambda at some angles and the kurtosis, by maketx's moments and by ours.
void add_figures(const std::string& what, const MemorySource& map,
                 const std::vector<Bounded>& angles, Measured& all)
{
    const auto levels = maketx_levels(normal_image(map), "-d float --bumpformat normal");
    BakedSet set = baked(map, plain_options());
    for (const auto& [angle, bound] : angles) {
        const auto g1 = maketx_g1(levels, angle);
        all.figures.push_back(
            Figure(what + ": Lambda at " + degrees(angle), lambda_by_definition(map, angle))
                .peer("Smith, maketx's moments", g1 ? std::optional(1 / *g1 - 1) : std::nullopt)
                .ours(lambda_of(slopes_of(set.top()), toward(angle)))
                .bound(bound));
    }
    all.figures.push_back(Figure(what + ": kurtosis", kurtosis_by_definition(map))
                              .ours(*set.summary().kurtosis)
                              .bound(1e-4));
}

Measured heavy_tails()
{
    // K0: the variance of a Gaussian is itself exponentially distributed.
    const auto k0 = gaussian_mixture(0.3, [](double u) { return -std::log(1 - u); });
    // One texel in twenty ten times as steep as the others.
    const auto scratched = gaussian_mixture(0.05, [](double u) { return u < 0.05 ? 100.0 : 1.0; });
    const auto one = [](double /*u*/) { return 1.0; };
    const SetTexel fine = baked(gaussian_mixture(0.05, one), plain_options()).top();
    const SetTexel steep = baked(gaussian_mixture(0.5, one), plain_options()).top();
    Measured all;
    add_figures("K0", k0, {{59, 0.012}, {45, 0.005}, {75, 0.005}, {84, 0.005}}, all);
    add_figures("scratches", scratched, {{60, 1}, {75, 0.62}, {85, 0.85}}, all);
    for (const double angle : {60.0, 75.0, 85.0})
        all.figures.push_back(Figure("scratches baked as two sets: Lambda at " + degrees(angle),
                                     lambda_by_definition(scratched, angle))
                                  .ours(lambda_of_both(steep, 0.05, fine, toward(angle)))
                                  .bound(0.005));
    add_words(all, flags_of("K0", k0));
    add_words(all, flags_of("the scratches", scratched));
    return all;
}

} // namespace

std::vector<FailureCase> slope_law_cases()
{
    return {
        {7, "Slopes of two values",
         R"(A V-groove of slopes -0.5 and +0.5, 16 texels wide, seen across; dunes that rise by 0.25 over 12
texels and fall by 0.75 over 4, seen from either side; 64x32.)",
         R"(Roofs, corrugated sheet, machined grooves, dunes. Mean and variance cannot tell two walls from a
bell curve: up to 63 degrees nothing of the groove is hidden and a Gaussian hides 5 %; from 75
degrees on a Gaussian hides too little. Nor do they know a gentle side from a steep one. Scree's
numbers are what any Gaussian of the exact variance gives. maketx's Sobel kernel straddles ridge
and bottom and loses an eighth of that variance.)",
         R"(`scree info` shows a kurtosis well below 8, that of a Gaussian: 2.7 for two slopes. Masking of
such an asset is off by up to a fifth at grazing views, and tables of visibility do not help: they
give colors, and the area that is seen, which over whole periods is the plane's in any case; it is
the area facing the view, of Gaussian slopes, that is wrong. Where that shows, keep the grooves as
geometry near the camera.)",
         few_slopes},
        {8, "Heavy tails",
         R"(Normal maps, 256x256: slopes of K0's law with deviation 0.3 (Laplace distributed along every
direction); scratched metal, 95 % of the slopes of deviation 0.05, 5 % of 0.5.)",
         R"(Real surfaces have more steep facets than a Gaussian of their variance. Moderate views then hide
more than it says, and highlights lose their halo. Scree bakes the kurtosis as tau, the weight
of K0 against a Gaussian, and follows it from 8 up to 16. A kurtosis beyond that is taken for
16: better than a Gaussian, still far off.)",
         R"(Keep the `tail` texture (it is baked unless `--maps` leaves it out). A kurtosis far above 16 in
`scree info` means one material over another: bake them as two sets and mix what the kernel
makes of each, as the figures of two sets show.)",
         heavy_tails},
    };
}

} // namespace scree::test
