#include <cmath>
#include <random>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/plain_code.h"
#include "failures/surfaces.h"
#include "figures/uniform.h"

namespace scree::test {
namespace {

// --- 21 ------------------------------------------------------------------------------------------

/// A normal map of random slopes about a mean, correlated between s and t.
MemorySource random_slopes(double mean_s, double mean_t, unsigned seed)
{
    std::mt19937 random(seed);
    return slope_map_of(256, 256, [&](int, int) {
        const double a = uniform(random) - 0.5, b = uniform(random) - 0.5;
        return std::array<double, 2>{mean_s + a, mean_t + 0.6 * a + 0.3 * b};
    });
}

MemorySource sum_of(const MemorySource& a, const MemorySource& b)
{
    return slope_map_of(a.map_width, a.map_height, [&](int x, int y) {
        const auto i = index_of(a, x, y);
        return std::array<double, 2>{a.slopes[i][0] + b.slopes[i][0],
                                     a.slopes[i][1] + b.slopes[i][1]};
    });
}

/// Variance along s of independent layers: covariances add.
double layered(const SetTexel& a, const SetTexel& b)
{
    return static_cast<double>(slopes_of(a).covariance.ss + slopes_of(b).covariance.ss);
}

/// The same from textures added channel by channel, of which a shader takes the variance.
std::optional<double> added(const MemorySource& a, const MemorySource& b)
{
    std::array<double, 2> sums{}; // E[s], E[ss]
    for (const MemorySource* map : {&a, &b}) {
        const auto levels = maketx_levels(normal_image(*map), "-d float --bumpformat normal");
        if (!levels)
            return {};
        sums[0] += *of_top(levels, kMeanS);
        sums[1] += *of_top(levels, kMeanSs);
    }
    return sums[1] - sums[0] * sums[0];
}

Figure layers(const std::string& what, const MemorySource& a, const MemorySource& b, double bound)
{
    return Figure(what + ": variance along s", variance_of_slopes(sum_of(a, b)))
        .peer("maketx, channels added", added(a, b))
        .ours(layered(baked(a, plain_options()).top(), baked(b, plain_options()).top()))
        .bound(bound);
}

/// Variance along an axis 30 degrees off s.
Figure turned(const MemorySource& map)
{
    const double c = std::cos(std::acos(-1.0) / 6), s = 0.5;
    const auto along = slope_map_of(map.map_width, map.map_height, [&](int x, int y) {
        const auto& slope = map.slopes[index_of(map, x, y)];
        return std::array<double, 2>{c * slope[0] + s * slope[1], 0};
    });
    const auto slopes = slopes_of(baked(map, plain_options()).top());
    const auto ss = static_cast<double>(slopes.covariance.ss);
    const auto tt = static_cast<double>(slopes.covariance.tt);
    const auto ours = filter::slope_along({static_cast<float>(c), static_cast<float>(s)},
                                          slopes.mean, slopes.covariance);
    return Figure("turned by 30 degrees: variance along s", variance_of_slopes(along))
        .peer("plain code, no mixed term", c * c * ss + s * s * tt)
        .ours(static_cast<double>(ours.deviation * ours.deviation))
        .bound(1e-5);
}

Measured layers_and_turns()
{
    const auto hill = random_slopes(0.5, 0.1, 1), detail = random_slopes(0.4, -0.2, 2);
    return {{layers("detail on a hillside", hill, detail, 0.005), // chance, of 65536 texels
             turned(detail), layers("a map on top of itself", detail, detail, 0.51)},
            {}};
}

// --- 22 ------------------------------------------------------------------------------------------

/// Means over the whole map, which repeats, of what the bilinear surface has along s: E[s^2], and
/// the square of the mean over a texel.
struct BilinearMeans {
    double square = 0, squared_mean = 0;
};

/// In a cell ds h goes evenly from D of its upper row to D of its lower: mean square (D^2 + D D' +
/// D'^2) / 3. The mean over a texel weights the cells of its rows and columns with what it covers.
BilinearMeans bilinear_means(const MemorySource& map)
{
    const int width = map.map_width, height = map.map_height;
    const auto d = [&](int x, int y) {
        return map.heights[index_of(map, x + 1, y)] - map.heights[index_of(map, x, y)];
    };
    BilinearMeans means;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double a = d(x, y), b = d(x, y + 1);
            means.square += (a * a + a * b + b * b) / 3;
            const auto across = [&](int row) { return (d(x - 1, row) + d(x, row)) / 2; };
            const double mean = 0.75 * across(y) + 0.125 * (across(y - 1) + across(y + 1));
            means.squared_mean += mean * mean;
        }
    means.square /= width * height;
    means.squared_mean /= width * height;
    return means;
}

Measured finest_level()
{
    const auto noise = white_noise(64, 64, 1);
    const BilinearMeans truth = bilinear_means(noise);
    BakedSet set = baked(noise, plain_options());
    const auto levels = maketx_levels(height_image(noise), "-d float --wrap periodic");
    const auto peer_inside = of_levels(levels, [](const std::vector<Image>& all) {
        double sum = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                sum += variance_s(all[0], x, y) / (64 * 64);
        return sum;
    });
    return {{Figure("mean variance of the slope inside a texel of level 0",
                    truth.square - truth.squared_mean)
                 .peer("maketx", peer_inside)
                 .ours(mean_over(set, 0, raw_variance_s))
                 .bound(1e-5),
             Figure("E[ss] of the whole map", truth.square)
                 .peer("maketx", of_top(levels, kMeanSs))
                 .ours(mean_ss(set.top()))
                 .bound(1e-5)},
            {}};
}

// --- 23 ------------------------------------------------------------------------------------------

/// What a texture filter makes of two texels: their channels, blended evenly.
SetTexel blended(const SetTexel& a, const SetTexel& b)
{
    const auto mix = [](float x, float y) { return (x + y) / 2; };
    const auto mix3 = [&](const std::array<float, 3>& x, const std::array<float, 3>& y) {
        return std::array<float, 3>{mix(x[0], y[0]), mix(x[1], y[1]), mix(x[2], y[2])};
    };
    SetTexel out;
    out.slope = {mix(a.slope.s, b.slope.s), mix(a.slope.ss, b.slope.ss),
                 mix(a.slope.st, b.slope.st), mix(a.slope.t, b.slope.t),
                 mix(a.slope.tt, b.slope.tt)};
    out.tau = mix(a.tau, b.tau);
    out.h = mix(a.h, b.h);
    out.hh = mix(a.hh, b.hh);
    out.color = mix3(a.color, b.color);
    out.color_height = mix3(a.color_height, b.color_height);
    for (size_t n = 0; n < out.rank.size(); ++n)
        out.rank[n] = mix3(a.rank[n], b.rank[n]);
    return out;
}

double variance(const SetTexel& texel)
{
    return static_cast<double>(slopes_of(texel).covariance.ss);
}

/// Slopes -0.5 and +0.5, 8 texels each.
MemorySource two_facets()
{
    return slope_map_of(64, 64, [](int x, int) {
        return std::array<double, 2>{x % 16 < 8 ? -0.5 : 0.5, 0};
    });
}

/// Joints and bricks, 8 texels each.
MemorySource two_colors()
{
    return painted(heights_of(64, 64, [](int x, int) { return x % 16 < 8 ? 0.0 : 1.0; }),
                   [](int, int, double h) { return h > 0.5 ? 0.7 : 0.1; });
}

Measured between_texels()
{
    BakedSet facets = baked(two_facets(), plain_options());
    const SetTexel left = facets.texel(3, 0, 0), right = facets.texel(3, 1, 0),
                   both = facets.texel(4, 0, 0);
    const auto plain = [](const SetTexel& a, const SetTexel& b) {
        return (variance(a) + variance(b)) / 2;
    };
    BakedSet colors = baked(two_colors(), plain_options());
    const SetTexel seam = blended(colors.texel(3, 0, 0), colors.texel(3, 1, 0));
    const double truth = color_by_definition({{0.5, 0.1}, {0.5, 0.7}}, 1);
    return {{Figure("variance halfway between two facets", 0.25)
                 .peer("plain code, roughness filtered", plain(left, right))
                 .ours(variance(blended(left, right)))
                 .bound(1e-5),
             Figure("variance halfway between a facet and the level above", 0.1875)
                 .peer("plain code, roughness filtered", plain(left, both))
                 .ours(variance(blended(left, both)))
                 .bound(1e-5),
             Figure("visible color halfway between brick and joint, Lambda = 1, linear in height",
                    truth)
                 .peer("mean color", 0.4)
                 .ours(red_by_height(seam, 1))
                 .bound(0.05),
             Figure("visible color halfway between brick and joint, Lambda = 1, rank table", truth)
                 .peer("mean color", 0.4)
                 .ours(red_by_rank(seam, 1))
                 .bound(0.3)},
            {}};
}

} // namespace

std::vector<FailureCase> filter_cases()
{
    return {
        {21, "Layers and turned maps",
         R"(Normal maps of random slopes, 256x256: detail of mean slope (0.4, -0.2), on a hillside of mean
slope (0.5, 0.1), turned by 30 degrees, on top of itself.)",
         R"(Of independent layers means and covariances add. E[ss] does not: adding textures channel by
channel leaves out 2 E[s] E[s], and on a slope the variance turns negative. Turning needs E[st].
Layers that follow one another have a covariance that neither of their textures knows, and the sum
of their variances is as wrong as that is large: by half for a layer on top of itself.)",
         R"(Add means and covariances (after `filter::slopes`), never channels. Of layers that follow one
another, such as moss in the cracks of the rock below it, bake the sum of the heights.)",
         layers_and_turns},
        {22, "The finest level", "White noise, 64x64, periodic.",
         R"(At level 0 a texel is taken for flat, though a surface through its neighbours' heights is not:
close up, a bump map turns smooth where displacement would not. And the kernel that takes the
slope blurs: Sobel keeps a seventh of the variance of the noisiest map. Scree takes the moments
of the bilinear surface over the texel.)",
         R"(Where the renderer displaces with a smoother surface than bilinear, or takes bumps by central
differences, bake what it does: `--reconstruction central` or `sobel`.)",
         finest_level},
        {23, "Between texels and levels",
         R"(Facets of slopes -0.5 and +0.5, 8 texels each; light bricks and dark joints, 8 texels each;
level 3, where a texel is one of them, looked up halfway.)",
         R"(A texture filter blends numbers, and what it blends must be moments: a roughness or a covariance
halfway between two facets that lean apart is that of a facet, not of both. The rank table is no
moment: each texel knows the order of its own heights only, and halfway it does not know which
of the two is higher.)",
         R"(At fine levels, where neighbouring texels have one height each, prefer `colorheight`; the rank
table is right where a texel has seen all heights.)",
         between_texels},
    };
}

} // namespace scree::test
