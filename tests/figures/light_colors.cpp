#include "figures/light_colors.h"

#include "figures/visibility_truth.h"

namespace scree::test {
namespace {

Rgbf rgbf(const reference::Rgb& color)
{
    return {static_cast<float>(color[0]), static_cast<float>(color[1]),
            static_cast<float>(color[2])};
}

} // namespace

std::vector<LightSource> light_sources(const VisibilityRecord& harmonics,
                                       const VisibilityRecord& axes)
{
    const size_t numbers_of_term = 4 * harmonics.node_angles_deg.size();
    std::vector<LightSource> all;
    for (int h = 0; h <= harmonics.harmonics; ++h) {
        const ColorOfView table = table_color(harmonics, h);
        all.push_back({table.name, numbers_of_term * (1 + 2 * static_cast<size_t>(h)), table});
    }
    constexpr size_t kTermsOfAxes = 5;
    const ColorOfView table = axes_color(axes);
    all.push_back({table.name, numbers_of_term * kTermsOfAxes, table});
    all.push_back({"exact", {}, {}});
    return all;
}

size_t most_harmonics(const std::vector<LightSource>& sources) { return sources.size() - 3; }
size_t along_axes(const std::vector<LightSource>& sources) { return sources.size() - 2; }
size_t exact(const std::vector<LightSource>& sources) { return sources.size() - 1; }

PairColors pair_colors(const SetTexel& texel, const DirectionColors& colors,
                       const LightPairs& pairs, size_t view, size_t light)
{
    return {texel, Vec3f(pairs.views[view]), Vec3f(pairs.lights[light]), colors.seen[view],
            colors.lit[light]};
}

DirectionColors table_colors(const ColorOfView& table, const SetTexel& texel,
                             const LightPairs& pairs)
{
    DirectionColors colors;
    for (const Vec3& w : pairs.views)
        colors.seen.push_back(table.color(texel, Vec3f(w)));
    for (const Vec3& w : pairs.lights)
        colors.lit.push_back(table.color(texel, Vec3f(w)));
    return colors;
}

std::vector<DirectionColors> exact_colors(const reference::DisplacedSurface& surface,
                                          const FootprintsOfSize& footprints,
                                          const LightPairs& pairs, uint64_t seed)
{
    reference::GatherPlan plan;
    plan.views = pairs.views; // the first: straight above, which SeenOfSize::color goes by
    plan.views.insert(plan.views.end(), pairs.lights.begin(), pairs.lights.end());
    plan.grid = footprints.grid;
    plan.seed = seed;
    const SeenOfSize seen = see(surface, footprints, plan);
    std::vector<DirectionColors> all;
    for (size_t i = 0; i < seen.truth.size(); ++i) {
        DirectionColors& colors = all.emplace_back();
        for (size_t v = 0; v < plan.views.size(); ++v) {
            const bool sees = seen.truth[i].all.seen[v].area > 0;
            (v < pairs.views.size() ? colors.seen : colors.lit)
                .push_back(rgbf(sees ? seen.color(i, seen.truth[i].all, v) : seen.mean_color[i]));
        }
    }
    return all;
}

} // namespace scree::test
