#include "visibility/view_components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scree {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadian = kPi / 180;

[[gnu::target_clones("avx2", "default")]] void add_excess(const float* visible, float factor,
                                                          size_t count, float* sum)
{
    for (size_t i = 0; i < count; ++i)
        sum[i] += factor * (visible[i] - 1);
}

} // namespace

std::vector<double> best_node_angles(int nodes)
{
    static const std::vector<double> kAngles[kMaxNodes] = {{80},
                                                           {68, 84},
                                                           {55, 74, 84},
                                                           {55, 74, 84, 87},
                                                           {55, 74, 80, 84, 87},
                                                           {50, 64, 74, 80, 84, 87}};
    return kAngles[std::clamp(nodes, 1, kMaxNodes) - 1];
}

ViewComponents::ViewComponents(const VisibilityPlan& table, const std::vector<ViewAngles>& views)
{
    const int terms = table.terms();
    for (int j = 0; j < table.azimuths && terms > 0; ++j) {
        const double azimuth_deg = (j + 0.25) * 360 / table.azimuths;
        for (size_t node = 0; node < table.node_angles_deg.size(); ++node) {
            Sweep& sweep = sweep_at(azimuth_deg);
            const int elevation = elevation_of(sweep, table.node_angles_deg[node]);
            const int first = static_cast<int>(node) * terms;
            sweep.terms.push_back({elevation, first, 1.0F / static_cast<float>(table.azimuths)});
            for (int h = 1; h <= table.harmonics; ++h) {
                const double phase = h * azimuth_deg * kRadian, share = 2.0 / table.azimuths;
                sweep.terms.push_back(
                    {elevation, first + h, static_cast<float>(share * std::cos(phase))});
                sweep.terms.push_back({elevation, first + table.harmonics + h,
                                       static_cast<float>(share * std::sin(phase))});
            }
        }
    }
    count_ = table.components();
    for (const ViewAngles& view : views) {
        Sweep& sweep = sweep_at(view.azimuth_deg);
        sweep.terms.push_back({elevation_of(sweep, view.angle_deg), count_++, 1});
    }
}

ViewComponents::Sweep& ViewComponents::sweep_at(double azimuth_deg)
{
    const double azimuth_rad = azimuth_deg * kRadian;
    const auto found =
        std::find_if(sweeps_.begin(), sweeps_.end(), [azimuth_rad](const Sweep& sweep) {
            return sweep.azimuth_rad == azimuth_rad;
        });
    if (found != sweeps_.end())
        return *found;
    return sweeps_.emplace_back(Sweep{azimuth_rad, {}, {}});
}

int ViewComponents::elevation_of(Sweep& sweep, double angle_deg)
{
    const double cotangent = 1 / std::tan(angle_deg * kRadian);
    const auto found = std::find(sweep.cotangents.begin(), sweep.cotangents.end(), cotangent);
    const auto index = found - sweep.cotangents.begin();
    if (found == sweep.cotangents.end())
        sweep.cotangents.push_back(cotangent);
    return static_cast<int>(index);
}

void ViewComponents::see(const HeightGrid& heights, const TexelBlock& block,
                         float* const* excess) const
{
    const size_t texels = static_cast<size_t>(block.width) * static_cast<size_t>(block.height);
    for (int i = 0; i < count_; ++i)
        std::fill_n(excess[i], texels, 0.0F);
    std::vector<float> visible;
    std::vector<float*> planes;
    for (const Sweep& sweep : sweeps_) {
        visible.resize(sweep.cotangents.size() * texels);
        planes.clear();
        for (size_t k = 0; k < sweep.cotangents.size(); ++k)
            planes.push_back(visible.data() + k * texels);
        scree::sweep(heights, block, sweep.azimuth_rad, sweep.cotangents, planes.data());
        for (const Term& term : sweep.terms)
            add_excess(planes[static_cast<size_t>(term.elevation)], term.factor, texels,
                       excess[term.component]);
    }
}

} // namespace scree
