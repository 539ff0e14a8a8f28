#include "tables/linear_light_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSteps = 40; // of Newton: more than are needed, for what they cost here

double between(double first, double last, int i, int count)
{
    return first + (last - first) * i / (count - 1);
}

std::vector<double> evenly_spaced(double first, double last, int count)
{
    std::vector<double> all(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i)
        all[static_cast<size_t>(i)] = between(first, last, i, count);
    return all;
}

double sine_of(double cosine) { return std::sqrt(std::max(1 - cosine * cosine, 0.0)); }

/// One row of the table over angles: all views of a normal.
void fill_angles(const LinearLightResolution& size, int normal, int azimuth, float* row)
{
    const double cos_n = between(-1, 1, normal, size.normals), sin_n = sine_of(cos_n);
    const double phi_n = between(0, kPi, azimuth, size.azimuths);
    const Imath::V3d n(sin_n * std::cos(phi_n), sin_n * std::sin(phi_n), cos_n);
    for (int i = 0; i < size.views; ++i) {
        const double cos_v = between(0, 1, i, size.views);
        const auto peak = filter::linear_peak(Imath::V3d(sine_of(cos_v), 0, cos_v), n, kSteps);
        // Never negative where phi_n is not, but for the rounding of pi.
        *row++ = static_cast<float>(std::abs(peak.phi));
        *row++ = static_cast<float>(peak.k);
        *row++ = static_cast<float>(peak.tan2);
    }
}

/// The same over the cone; see scree_linear_cone_coordinates.
void fill_cone(const LinearLightResolution& size, int ratio, int side, float* row)
{
    constexpr double kInfinite = 1e9;
    const double y = between(0, 1, ratio, size.normals), z = between(0, 1, side, size.azimuths);
    const double na = y < 1 ? (3 * y - 1) / (1 - y) : kInfinite;
    const double nb = std::max(z, 1e-6);
    for (int i = 0; i < size.views; ++i) {
        const double cos_v = between(0, 1, i, size.views);
        *row++ = static_cast<float>(
            kernel::scree_linear_stretch(cos_v, na, nb * nb, std::max(1 - nb * nb, 0.0), kSteps));
    }
}

/// Channels of a table at texture coordinates, linear between texel centres as a sampler is.
template <size_t channels>
std::array<float, channels> fetch(const LinearLightTable& table, const std::array<float, 3>& at)
{
    const std::array<int, 3> count = {table.size.views, table.size.normals, table.size.azimuths};
    std::array<size_t, 3> texel{};
    std::array<float, 3> share{};
    for (size_t i = 0; i < 3; ++i) {
        const float x = at[i] * static_cast<float>(count[i]) - 0.5F;
        const int low = std::clamp(static_cast<int>(x), 0, count[i] - 2);
        texel[i] = static_cast<size_t>(low);
        share[i] = std::clamp(x - static_cast<float>(low), 0.0F, 1.0F);
    }
    const size_t right = channels, down = right * static_cast<size_t>(count[0]),
                 next = down * static_cast<size_t>(count[1]);
    const float* first = table.values.data() + texel[0] * right + texel[1] * down + texel[2] * next;
    std::array<float, channels> out{};
    for (size_t c = 0; c < channels; ++c) {
        auto mixed = [&](const float* p) { return p[c] + share[0] * (p[c + right] - p[c]); };
        auto square = [&](const float* p) {
            return mixed(p) + share[1] * (mixed(p + down) - mixed(p));
        };
        out[c] = square(first) + share[2] * (square(first + next) - square(first));
    }
    return out;
}

filter::LinearPeak<float> peak_over_angles(const LinearLightTable& table, const Imath::V3f& viewer,
                                           const Imath::V3f& normal)
{
    std::array<float, 3> at{};
    kernel::scree_linear_angle_coordinates(
        viewer.z, normal.x, normal.y, normal.z, static_cast<float>(table.size.views),
        static_cast<float>(table.size.normals), static_cast<float>(table.size.azimuths), at[0],
        at[1], at[2]);
    const auto [phi, k, tan2] = fetch<3>(table, at);
    return {normal.y < 0 ? -phi : phi, k, tan2};
}

filter::LinearPeak<float> peak_over_cone(const LinearLightTable& table, const Imath::V3f& viewer,
                                         const Imath::V3f& normal)
{
    float ch = 0, sh = 0, na = 0, nb = 0, radius = 0;
    kernel::scree_linear_cone(viewer.x, viewer.z, normal.x, normal.y, normal.z, ch, sh, na, nb,
                              radius);
    std::array<float, 3> at{};
    kernel::scree_linear_cone_coordinates(
        viewer.z, na, nb, radius, static_cast<float>(table.size.views),
        static_cast<float>(table.size.normals), static_cast<float>(table.size.azimuths), at[0],
        at[1], at[2]);
    Imath::V3f half;
    kernel::scree_linear_half(fetch<1>(table, at)[0], viewer.z, normal.y, ch, sh, nb, half.x,
                              half.y, half.z);
    filter::LinearPeak<float> out;
    kernel::scree_linear_peak_at(viewer.x, viewer.z, normal.x, normal.y, normal.z, half.x, half.y,
                                 half.z, out.phi, out.k, out.tan2);
    return out;
}

} // namespace

LinearLightResolution usual_resolution(LinearLightCoordinates coordinates)
{
    if (coordinates == LinearLightCoordinates::angles)
        return {32, 128, 64};
    return {32, 64, 32};
}

filter::LinearPeak<float> LinearLightTable::peak(const Imath::V3f& viewer,
                                                 const Imath::V3f& normal) const
{
    return coordinates == LinearLightCoordinates::angles ? peak_over_angles(*this, viewer, normal)
                                                         : peak_over_cone(*this, viewer, normal);
}

LinearLightTable linear_light_table(LinearLightCoordinates coordinates,
                                    const LinearLightResolution& size,
                                    const std::function<void(double)>& progress)
{
    LinearLightTable table{coordinates, size, {}};
    const auto row = table.channels() * static_cast<size_t>(size.views);
    const auto slice = row * static_cast<size_t>(size.normals);
    table.values.resize(slice * static_cast<size_t>(size.azimuths));
    const auto fill = coordinates == LinearLightCoordinates::angles ? fill_angles : fill_cone;
    for (int azimuth = 0; azimuth < size.azimuths; ++azimuth) {
        float* first = table.values.data() + slice * static_cast<size_t>(azimuth);
        tbb::parallel_for(0, size.normals, [&](int normal) {
            fill(size, normal, azimuth, first + row * static_cast<size_t>(normal));
        });
        progress(static_cast<double>(azimuth + 1) / size.azimuths);
    }
    return table;
}

TableManifest linear_light_manifest(LinearLightCoordinates coordinates,
                                    const LinearLightResolution& size)
{
    TableManifest manifest;
    manifest.kind = "linear-light";
    manifest.description = "Where the reflection of a linear light is brightest, and how it falls "
                           "off: exp(-(tan2 + k^2 (x - Phi)^2) / sigma^2) over the angle x along "
                           "the light.";
    manifest.axes = {{"cos theta_v", "1",
                      "cosine between the viewer and the normal w of light and point",
                      evenly_spaced(0, 1, size.views)}};
    if (coordinates == LinearLightCoordinates::angles) {
        manifest.axes.push_back({"cos theta_n", "1", "cosine between the surface's normal and w",
                                 evenly_spaced(-1, 1, size.normals)});
        manifest.axes.push_back({"phi_n", "radians",
                                 "azimuth about w from the viewer to the surface's normal; of a "
                                 "negative one the absolute value, with -Phi for Phi",
                                 evenly_spaced(0, kPi, size.azimuths)});
        manifest.channels = {
            {"R", "Phi", "radians",
             "azimuth about w, from the viewer's, of the light's point whose half vector is "
             "closest to the normal"},
            {"G", "k", "1 / radians", "speed of the half vector there, on the plane tangent at n"},
            {"B", "tan2", "1",
             "squared tangent of its angle from the normal; 1e6 where the surface cannot be seen"},
        };
    } else {
        manifest.axes.push_back(
            {"(r + 1) / (r + 3)", "1",
             "r = n_a / sqrt(n_b^2 + cos theta_v n_e^2), -1 and more; 1 / 2 on the cone",
             evenly_spaced(0, 1, size.normals)});
        manifest.axes.push_back({"side", "1", "|n_b| / sqrt(n_b^2 + cos theta_v n_e^2)",
                                 evenly_spaced(0, 1, size.azimuths)});
        manifest.channels = {{"R", "stretch", "1",
                              "of the half vector along e, over the normal's: for "
                              "scree_linear_half; 1 on the cone"}};
    }
    return manifest;
}

} // namespace scree
