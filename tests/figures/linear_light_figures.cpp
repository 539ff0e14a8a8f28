// The figures of docs/linear-lights.md but for times:
//
//   scree_linear_light_figures
//
// what each step of the approximation costs, what tables add, and where the Gaussian fails. Over
// the random configurations of the tests; rms of the error over rms of the value, in percent.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <vector>

#include "kernel/linear_scenes.h"
#include "tables/linear_light_table.h"

namespace scree::test {
namespace {

using filter::LinearView;
using Imath::V3d;

constexpr int kCount = 4000;
constexpr double kPi = 3.14159265358979323846;

void print_steps()
{
    fmt::print(
        "Steps, each against the one before (terms against the full integral)\n\n"
        "| sigma^2 | terms at Phi | terms at phi_s, no root | Gaussian for W | with the bend "
        "| all as published | bend, terms at the mean angle |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const double sigma2 : {0.0005, 0.002, 0.02, 0.1, 0.3}) {
        RelativeRms at_phi, at_middle, gaussian, bend, published, ours;
        look_at_scenes(kCount, sigma2, [&](const LinearScene& scene, const LinearAngles& angles) {
            const auto view = view_of<double>(scene);
            const auto peak = filter::linear_peak(view.viewer, view.normal, 8);
            const double full = reflected_exactly(scene), lobe = lobe_integral(scene, angles);
            const double straight = lobe_of(view, peak, peak.k, sigma2);
            const double middle = constant_terms(scene, angles, angles.centre, false);
            at_phi.add(constant_terms(scene, angles, scanned_peak(scene, angles).phi, true) * lobe,
                       full);
            at_middle.add(middle * lobe, full);
            gaussian.add(straight, lobe);
            bend.add(lobe_of(view, peak, curved_k(view, peak), sigma2), lobe);
            published.add(middle * straight, full);
            ours.add(filter::linear_reflection(view, peak, sigma2), full);
        });
        fmt::print("| {} | {:.2f} | {:.1f} | {:.2f} | {:.2f} | {:.1f} | {:.2f} |\n", sigma2,
                   at_phi.percent(), at_middle.percent(), gaussian.percent(), bend.percent(),
                   published.percent(), ours.percent());
    }
}

void print_tables()
{
    const std::vector<std::pair<LinearLightCoordinates, LinearLightResolution>> all = {
        {LinearLightCoordinates::angles, {32, 128, 64}},
        {LinearLightCoordinates::angles, {64, 256, 128}},
        {LinearLightCoordinates::angles, {128, 512, 256}},
        {LinearLightCoordinates::cone, {8, 16, 8}},
        {LinearLightCoordinates::cone, {16, 32, 16}},
        {LinearLightCoordinates::cone, {32, 64, 32}},
    };
    fmt::print("\nWhat a lookup adds to the Gaussian of W (its own error: {})\n\n"
               "| table | kB | 0.002 | 0.02 | 0.3 |\n| --- | --- | --- | --- | --- |\n",
               "column `Gaussian for W` above");
    for (const auto& [coordinates, size] : all) {
        const auto table = linear_light_table(coordinates, size, [](double) {});
        fmt::print("| {} {}x{}x{} | {:.0f} |",
                   coordinates == LinearLightCoordinates::cone ? "cone" : "angles", size.views,
                   size.normals, size.azimuths, static_cast<double>(table.values.size()) * 4e-3);
        for (const double sigma2 : {0.002, 0.02, 0.3}) {
            RelativeRms added;
            look_at_scenes(kCount, sigma2, [&](const LinearScene& scene, const LinearAngles&) {
                const auto view = view_of<float>(scene);
                const auto exact = filter::linear_peak(view.viewer, view.normal, 8);
                const auto looked_up = table.peak(view.viewer, view.normal);
                added.add(lobe_of(view, looked_up, looked_up.k, sigma2),
                          lobe_of(view, exact, exact.k, sigma2));
            });
            fmt::print(" {:.3f} |", added.percent());
        }
        fmt::print("\n");
    }
}

using Bin = std::function<int(const LinearScene&, const LinearView<double>&)>;

void print_bins(const char* title, const std::vector<std::string>& names, const Bin& bin_of)
{
    fmt::print("\n{}: Gaussian with bend / 8 points, and the share of the light's energy there\n\n"
               "| | 0.002 | 0.02 | 0.1 | 0.3 |\n| --- | --- | --- | --- | --- |\n",
               title);
    std::vector<std::string> rows(names.size());
    for (const double sigma2 : {0.002, 0.02, 0.1, 0.3}) {
        std::vector<RelativeRms> gaussian(names.size()), points(names.size());
        std::vector<double> energy(names.size());
        double all = 0;
        look_at_scenes(
            kCount, sigma2,
            [&](const LinearScene& scene, const LinearAngles&) {
                const auto view = view_of<double>(scene);
                const auto bin = static_cast<size_t>(bin_of(scene, view));
                const auto peak = filter::linear_peak(view.viewer, view.normal, 8);
                const double full = reflected_exactly(scene);
                gaussian[bin].add(filter::linear_reflection(view, peak, sigma2), full);
                points[bin].add(filter::linear_quadrature(view, peak, sigma2, 2), full);
                energy[bin] += full;
                all += full;
            },
            0.02);
        for (size_t i = 0; i < names.size(); ++i)
            rows[i] += fmt::format(" {:.1f} / {:.2f} ({:.0f} %) |", gaussian[i].percent(),
                                   points[i].percent(), 100 * energy[i] / all);
    }
    for (size_t i = 0; i < names.size(); ++i)
        fmt::print("| {} |{}\n", names[i], rows[i]);
}

/// Angle of the normal from the piece of plane across which Phi jumps; 3: not beside it.
int jump_bin(const LinearScene&, const LinearView<double>& view)
{
    const double q = view.viewer.z;
    const V3d w(0, 0, 1);
    const V3d a = (view.viewer + w).normalized(), b = (view.viewer - w).normalized();
    const double along = std::atan2(std::abs(view.normal.y), view.normal.dot(a));
    const double focus = std::atan2(1 - q, 2 * std::sqrt(q));
    const double from_plane = std::asin(std::abs(view.normal.dot(b))) * 180 / kPi;
    if (along > focus || from_plane > 20)
        return 3;
    return from_plane < 3 ? 0 : (from_plane < 10 ? 1 : 2);
}

void print_failures()
{
    print_bins("By the viewer's angle from the normal",
               {"0 to 45", "45 to 70", "70 to 80", "80 to 89"},
               [](const LinearScene& scene, const LinearView<double>&) {
                   const double degrees = std::acos(scene.viewer.z) * 180 / kPi;
                   return degrees < 45 ? 0 : (degrees < 70 ? 1 : (degrees < 80 ? 2 : 3));
               });
    print_bins("By the normal's angle from where Phi jumps",
               {"0 to 3 degrees", "3 to 10", "10 to 20", "elsewhere"}, jump_bin);
}

} // namespace
} // namespace scree::test

int main()
{
    scree::test::print_steps();
    scree::test::print_tables();
    scree::test::print_failures();
}
