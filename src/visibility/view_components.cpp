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

/// Turns sums into a table.
///
/// matrix  count x count, row by row
/// planes  count of them, `texels` numbers each
[[gnu::target_clones("avx2", "default")]] void solve(const float* matrix, int count, size_t texels,
                                                     float* const* planes)
{
    constexpr size_t kRun = 64;
    std::vector<float> sums(static_cast<size_t>(count) * kRun);
    for (size_t first = 0; first < texels; first += kRun) {
        const size_t run = std::min(kRun, texels - first);
        for (int i = 0; i < count; ++i)
            std::copy_n(planes[i] + first, run, sums.data() + static_cast<size_t>(i) * kRun);
        for (int i = 0; i < count; ++i) {
            float* solved = planes[i] + first;
            std::fill_n(solved, run, 0.0F);
            for (int j = 0; j < count; ++j) {
                const float factor = matrix[i * count + j];
                const float* sum = sums.data() + static_cast<size_t>(j) * kRun;
                for (size_t k = 0; k < run; ++k)
                    solved[k] += factor * sum[k];
            }
        }
    }
}

} // namespace

ViewComponents::ViewComponents(const std::vector<VisibilityPlan>& tables,
                               const std::vector<ViewAngles>& views)
{
    for (const VisibilityPlan& table : tables) {
        if (table.node_angles_deg.empty())
            continue;
        if (table.axes)
            add_axes(table);
        else
            add_harmonics(table);
        count_ += table.components();
    }
    for (const ViewAngles& view : views)
        add(view, count_++, 1);
}

void ViewComponents::add_harmonics(const VisibilityPlan& table)
{
    const double share = 1.0 / table.azimuths;
    for (int j = 0; j < table.azimuths; ++j)
        for (size_t node = 0; node < table.node_angles_deg.size(); ++node) {
            const ViewAngles view{table.node_angles_deg[node], swept_azimuth_deg(table, j)};
            const int first = count_ + static_cast<int>(node) * table.terms();
            add(view, first, share);
            for (int h = 1; h <= table.harmonics; ++h) {
                const double phase = h * view.azimuth_deg * kRadian;
                add(view, first + h, 2 * share * std::cos(phase));
                add(view, first + table.harmonics + h, 2 * share * std::sin(phase));
            }
        }
}

void ViewComponents::add_axes(const VisibilityPlan& table)
{
    const AxesFit fit(table);
    for (int j = 0; j < table.azimuths; ++j)
        for (const double angle_deg : fit.angles_deg()) {
            const ViewAngles view{angle_deg, swept_azimuth_deg(table, j)};
            for (const TableShare& share : fit.shares(view))
                add(view, count_ + share.component, share.weight);
        }
    solves_.push_back({count_, table.components(), fit.inverse()});
}

void ViewComponents::add(const ViewAngles& view, int component, double factor)
{
    Sweep& sweep = sweep_at(view.azimuth_deg);
    sweep.terms.push_back(
        {elevation_of(sweep, view.angle_deg), component, static_cast<float>(factor)});
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
    for (const Solve& of : solves_)
        solve(of.matrix.data(), of.count, texels, excess + of.first);
}

} // namespace scree
