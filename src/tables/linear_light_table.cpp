#include "tables/linear_light_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "kernel/linear_light.h"

namespace scree {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSteps = 40; // of Newton: no fewer are needed than here they cost little

double between(double first, double last, int i, int count)
{
    return first + (last - first) * i / (count - 1);
}

std::vector<double> evenly_spaced(double first, double last, int count)
{
    std::vector<double> all;
    for (int i = 0; i < count; ++i)
        all.push_back(between(first, last, i, count));
    return all;
}

double sine_of(double cosine) { return std::sqrt(std::max(1 - cosine * cosine, 0.0)); }

/// One row of the table: all views of a normal.
void fill_row(const LinearLightResolution& size, double cos_n, double phi_n, float* row)
{
    const double sin_n = sine_of(cos_n);
    const Imath::V3d normal(sin_n * std::cos(phi_n), sin_n * std::sin(phi_n), cos_n);
    for (int i = 0; i < size.views; ++i) {
        const double cos_v = between(0, 1, i, size.views);
        const auto peak = filter::linear_peak(Imath::V3d(sine_of(cos_v), 0, cos_v), normal, kSteps);
        // Never negative where phi_n is not, but for the rounding of pi.
        *row++ = static_cast<float>(std::abs(peak.phi));
        *row++ = static_cast<float>(peak.k);
        *row++ = static_cast<float>(peak.tan2);
    }
}

} // namespace

std::array<float, 3> LinearLightTable::at(int view, int normal, int azimuth) const
{
    const auto row = static_cast<size_t>(azimuth) * static_cast<size_t>(size.normals) +
                     static_cast<size_t>(normal);
    const size_t first = 3 * (row * static_cast<size_t>(size.views) + static_cast<size_t>(view));
    return {values[first], values[first + 1], values[first + 2]};
}

LinearLightTable linear_light_table(const LinearLightResolution& size,
                                    const std::function<void(double)>& progress)
{
    const auto row = 3 * static_cast<size_t>(size.views);
    const auto slice = row * static_cast<size_t>(size.normals);
    LinearLightTable table{size, std::vector<float>(slice * static_cast<size_t>(size.azimuths))};
    for (int azimuth = 0; azimuth < size.azimuths; ++azimuth) {
        float* first = table.values.data() + slice * static_cast<size_t>(azimuth);
        const double phi_n = between(0, kPi, azimuth, size.azimuths);
        tbb::parallel_for(0, size.normals, [&](int normal) {
            fill_row(size, between(-1, 1, normal, size.normals), phi_n,
                     first + row * static_cast<size_t>(normal));
        });
        progress(static_cast<double>(azimuth + 1) / size.azimuths);
    }
    return table;
}

TableManifest linear_light_manifest(const LinearLightResolution& size)
{
    TableManifest manifest;
    manifest.kind = "linear-light";
    manifest.description = "Where the reflection of a linear light is brightest, and how it falls "
                           "off: exp(-(tan2 + k^2 (x - Phi)^2) / sigma^2) over the angle x along "
                           "the light.";
    manifest.axes = {
        {"cos theta_v", "1", "cosine between the viewer and the normal w of light and point",
         evenly_spaced(0, 1, size.views)},
        {"cos theta_n", "1", "cosine between the surface's normal and w",
         evenly_spaced(-1, 1, size.normals)},
        {"phi_n", "radians",
         "azimuth about w from the viewer to the surface's normal; of a negative one the absolute "
         "value, with -Phi for Phi",
         evenly_spaced(0, kPi, size.azimuths)},
    };
    manifest.channels = {
        {"R", "Phi", "radians",
         "azimuth about w, from the viewer's, of the light's point whose half vector is closest to "
         "the normal"},
        {"G", "k", "1 / radians", "speed of the half vector there, on the plane tangent at n"},
        {"B", "tan2", "1",
         "squared tangent of its angle from the normal; 1e6 where the surface "
         "cannot be seen"},
    };
    return manifest;
}

} // namespace scree
