#include "figures/light_truth.h"

#include "figures/visibility_truth.h"

namespace scree::test {
namespace {

std::vector<SeenLit> pairs_of(const reference::Gathered& gathered, const reference::Rgb& mean_color)
{
    const size_t lights = gathered.lit.size() / gathered.seen.size();
    std::vector<SeenLit> all;
    for (size_t pair = 0; pair < gathered.lit.size(); ++pair) {
        const reference::Lit& lit = gathered.lit[pair];
        SeenLit& seen = all.emplace_back();
        seen.sent = lit.white * gathered.seen[pair / lights].area;
        if (seen.sent > 0)
            for (size_t c = 0; c < 3; ++c) // views begin with one from straight above
                seen.color[c] =
                    lit.diffuse[c] / lit.white + mean_color[c] - gathered.seen.front().color[c];
    }
    return all;
}

/// error  squared error of R, G, B together, of a footprint, a view and a light, all of which send
template <typename Error>
SquaresOfPairs mean_squares(const std::vector<LitFootprint>& truth, const LightPairs& pairs,
                            Error&& error)
{
    const size_t light_angles = pairs.light_angles_deg.size();
    SquaresOfPairs sums(pairs.view_angles_deg.size() * light_angles), sent(sums.size());
    for (size_t i = 0; i < truth.size(); ++i)
        for (size_t v = 0; v < pairs.views.size(); ++v)
            for (size_t l = 0; l < pairs.lights.size(); ++l) {
                const double weight = truth[i].all[v * pairs.lights.size() + l].sent;
                if (!(weight > 0))
                    continue;
                const size_t cell = pairs.view_angle(v) * light_angles + pairs.light_angle(l);
                sums[cell] += weight * error(i, v, l) / 3;
                sent[cell] += weight;
            }
    for (size_t cell = 0; cell < sums.size(); ++cell)
        sums[cell] /= sent[cell];
    return sums;
}

} // namespace

std::vector<LitFootprint> light(const reference::DisplacedSurface& surface,
                                const FootprintsOfSize& footprints, const LightPairs& pairs,
                                uint64_t seed)
{
    reference::GatherPlan plan;
    plan.views = pairs.views;
    plan.lights = pairs.lights;
    plan.grid = footprints.grid;
    plan.seed = seed;
    const auto gathered = reference::gather_all(surface, footprints.places, plan);
    std::vector<LitFootprint> all;
    for (size_t i = 0; i < gathered.size(); ++i) {
        const reference::Rgb mean = mean_color_of(surface.relief(), footprints.places[i]);
        all.push_back(
            {pairs_of(gathered[i].all, mean),
             {pairs_of(gathered[i].halves[0], mean), pairs_of(gathered[i].halves[1], mean)}});
    }
    return all;
}

SquaresOfPairs
squares_of(const std::function<Rgbf(size_t footprint, size_t view, size_t light)>& color,
           const std::vector<LitFootprint>& truth, const LightPairs& pairs, double mean_color)
{
    return mean_squares(truth, pairs, [&](size_t i, size_t v, size_t l) {
        const Rgbf shown = color(i, v, l);
        const SeenLit& lit = truth[i].all[v * pairs.lights.size() + l];
        double sum = 0;
        for (size_t c = 0; c < 3; ++c) {
            const double error = (static_cast<double>(shown[c]) - lit.color[c]) / mean_color;
            sum += error * error;
        }
        return sum;
    });
}

SquaresOfPairs squares_of_noise(const std::vector<LitFootprint>& truth, const LightPairs& pairs,
                                double mean_color)
{
    return mean_squares(truth, pairs, [&](size_t i, size_t v, size_t l) {
        const size_t pair = v * pairs.lights.size() + l;
        const SeenLit& one = truth[i].halves[0][pair];
        const SeenLit& other = truth[i].halves[1][pair];
        if (!(one.sent > 0 && other.sent > 0))
            return 0.0;
        double sum = 0;
        for (size_t c = 0; c < 3; ++c) {
            const double error = (one.color[c] - other.color[c]) / 2 / mean_color;
            sum += error * error;
        }
        return sum;
    });
}

} // namespace scree::test
