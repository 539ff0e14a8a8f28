// Error against time of every way to reflect a linear light; run on request:
//
//   scree_bench_linear_light [docs/linear-lights.svg]
//
// prints a table in Markdown and draws its column for sigma^2 = 0.02. Errors: rms of what is
// reflected over rms of the truth, adaptive quadrature of the full integral, over the random
// configurations of the tests (viewers within acos(0.3) of the normal). Times: processor time of
// one thread, median of nine rounds over 1024 configurations, frame and angles of the light
// included.

#include <fmt/format.h>
#include <time.h> // NOLINT(modernize-deprecated-headers): clocks of POSIX

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <vector>

#include "kernel/linear_scenes.h"
#include "report/chart.h"
#include "tables/linear_light_table.h"

namespace scree::test {
namespace {

using filter::LinearPeak;
using filter::LinearView;
using Imath::V3f;

constexpr float kPi = 3.14159265F;
constexpr std::array<double, 3> kSigma2 = {0.002, 0.02, 0.3};
constexpr int kConfigurations = 1024, kRounds = 9;

/// What a renderer has.
struct Lit {
    filter::LinearLight<float> light;
    V3f normal, viewer;
    float sigma2 = 0;
};

struct Tables {
    LinearLightTable angles = make(LinearLightCoordinates::angles);
    LinearLightTable cone = make(LinearLightCoordinates::cone);

    static LinearLightTable make(LinearLightCoordinates coordinates)
    {
        return linear_light_table(coordinates, usual_resolution(coordinates), [](double) {});
    }
};

const Tables& tables()
{
    static const Tables all;
    return all;
}

LinearView<float> view_of(const Lit& lit)
{
    return filter::linear_view(lit.light, lit.normal, lit.viewer);
}

/// The source's error functions, the fast one and the one it calls precise.
float fast_erf(float x)
{
    return std::copysign(1 - std::exp(-x * x) / (1.3F * std::abs(x) + 1), x);
}
float precise_erf(float x)
{
    return std::copysign(
        1 - std::exp(-x * x) / (1.1595F * std::abs(x) + std::sqrt(1 + 0.38F * x * x)), x);
}

/// The source's wardIntegral() and specular(), with its terms at the middle of the light.
template <class Erf>
float as_published(const Lit& lit, const LinearView<float>& view, const LinearPeak<float>& peak,
                   const Erf& erf)
{
    if (view.last <= view.first)
        return 0;
    auto norm = [](float a) { return a - 2 * kPi * std::floor(a / (2 * kPi) + 0.5F); };
    const float scale = peak.k / std::sqrt(lit.sigma2);
    const float lobe = std::exp(-peak.tan2 / lit.sigma2) *
                       std::abs(erf(scale * norm(view.last - peak.phi)) -
                                erf(scale * norm(view.first - peak.phi))) /
                       (8 * std::sqrt(kPi * lit.sigma2) * peak.k);
    const V3f middle = (0.5F * (lit.light.from + lit.light.to)).normalized();
    return lobe * std::max(-middle.dot(lit.light.normal), 0.0F) / view.distance;
}

/// The Gaussian with the source's k, the terms at Phi, ours for the rest.
float straight(const Lit& lit, const LinearView<float>& view, const LinearPeak<float>& peak)
{
    if (view.last <= view.first)
        return 0;
    float centre = 0;
    const float lobe = kernel::scree_linear_integral(view.first, view.last, peak.phi, peak.k,
                                                     peak.tan2, lit.sigma2, centre);
    const float middle = 0.5F * (view.first + view.last);
    const float nearest = middle + kernel::scree_periodic_angle(peak.phi - middle);
    const float at = std::clamp(nearest, view.first, view.last);
    return lobe *
           kernel::scree_linear_terms(at, view.viewer.dot(view.normal), view.normal.x,
                                      view.normal.y, view.light_normal.x, view.light_normal.y) /
           (4 * kPi * lit.sigma2 * view.distance);
}

/// The full integrand at the middles of 50 equal parts of the light above the horizon.
float fifty_samples(const Lit& lit)
{
    constexpr int kSamples = 50;
    float begin = 0, end = 0;
    kernel::scree_clip_segment(lit.light.from.dot(lit.normal), lit.light.to.dot(lit.normal), begin,
                               end);
    const V3f whole = lit.light.to - lit.light.from;
    const V3f from = lit.light.from + whole * begin;
    const V3f step = whole * ((end - begin) / kSamples);
    const float vn = lit.viewer.dot(lit.normal);
    float sum = 0;
    for (int i = 0; i < kSamples; ++i) {
        const V3f p = from + step * (static_cast<float>(i) + 0.5F);
        const float per_length2 = 1 / p.dot(p);
        const V3f l = p * std::sqrt(per_length2);
        const V3f h = l + lit.viewer;
        const float hn = h.dot(lit.normal);
        const float tan2 = h.dot(h) / (hn * hn) - 1;
        sum += std::sqrt(std::max(l.dot(lit.normal), 0.0F) / vn) * std::exp(-tan2 / lit.sigma2) *
               std::max(-l.dot(lit.light.normal), 0.0F) * per_length2;
    }
    return sum * step.length() / (4 * kPi * lit.sigma2);
}

LinearPeak<float> newton(const LinearView<float>& view)
{
    return filter::linear_peak(view.viewer, view.normal, 4);
}

struct Way {
    std::string name, family;
    std::function<float(const Lit&)> reflect;
};

std::vector<Way> ways()
{
    auto with_angles = [](const LinearView<float>& v) {
        return tables().angles.peak(v.viewer, v.normal);
    };
    auto with_cone = [](const LinearView<float>& v) {
        return tables().cone.peak(v.viewer, v.normal);
    };
    auto quadrature = [](int panels) {
        return [panels](const Lit& lit) {
            const auto view = view_of(lit);
            return filter::linear_quadrature(view, newton(view), lit.sigma2, panels);
        };
    };
    return {
        {"fast erf", "as published",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return as_published(lit, view, with_angles(view), fast_erf);
         }},
        {"precise erf", "as published",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return as_published(lit, view, with_angles(view), precise_erf);
         }},
        {"table, terms at Phi", "table over angles",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return straight(lit, view, with_angles(view));
         }},
        {"table, bend", "table over angles",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return filter::linear_reflection(view, with_angles(view), lit.sigma2);
         }},
        {"cone, terms at Phi", "table over the cone",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return straight(lit, view, with_cone(view));
         }},
        {"cone, bend", "table over the cone",
         [=](const Lit& lit) {
             const auto view = view_of(lit);
             return filter::linear_reflection(view, with_cone(view), lit.sigma2);
         }},
        {"Newton, terms at Phi", "Newton",
         [](const Lit& lit) {
             const auto view = view_of(lit);
             return straight(lit, view, newton(view));
         }},
        {"Newton, bend", "Newton",
         [](const Lit& lit) {
             const auto view = view_of(lit);
             return filter::linear_reflection(view, newton(view), lit.sigma2);
         }},
        {"4 points", "quadrature about the peak", quadrature(1)},
        {"8 points", "quadrature about the peak", quadrature(2)},
        {"12 points", "quadrature about the peak", quadrature(3)},
        {"50 samples", "along the light", fifty_samples},
    };
}

struct Configurations {
    std::vector<Lit> lit;
    std::vector<double> truth;

    explicit Configurations(double sigma2)
    {
        std::mt19937 random(20);
        while (lit.size() < kConfigurations) {
            const LinearScene scene = random_scene(random, sigma2, kLowestView);
            const double reflected = reflected_exactly(scene);
            if (reflected <= 0)
                continue;
            lit.push_back({light_of<float>(scene), V3f(scene.normal), V3f(scene.viewer),
                           static_cast<float>(sigma2)});
            truth.push_back(reflected);
        }
    }

    [[nodiscard]] double error(const Way& way) const
    {
        RelativeRms error;
        for (size_t i = 0; i < lit.size(); ++i)
            error.add(static_cast<double>(way.reflect(lit[i])), truth[i]);
        return error.value();
    }
};

double now_ns()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

volatile float checksum = 0; // that the compiler cannot leave out

/// Least, median and largest of the rounds; ways in turns, so that noise meets all alike.
std::vector<std::array<double, 3>> times_of(const std::vector<Way>& all, const Configurations& on)
{
    std::vector<std::vector<double>> times(all.size());
    for (int round = -1; round < kRounds; ++round)
        for (size_t i = 0; i < all.size(); ++i) {
            const double begin = now_ns();
            float sum = 0;
            for (const Lit& lit : on.lit)
                sum += all[i].reflect(lit);
            checksum = sum;
            if (round >= 0)
                times[i].push_back((now_ns() - begin) / kConfigurations);
        }
    std::vector<std::array<double, 3>> out;
    for (auto& of : times) {
        std::sort(of.begin(), of.end());
        out.push_back({of.front(), of[of.size() / 2], of.back()});
    }
    return out;
}

void draw(const std::vector<Way>& all, const std::vector<double>& errors,
          const std::vector<std::array<double, 3>>& times, const char* file)
{
    report::Chart chart;
    chart.title = "Reflection of a linear light, sigma^2 = 0.02";
    chart.x = {"ns a light and point, one thread", true};
    chart.y = {"rms error over rms of the truth", true};
    for (size_t i = 0; i < all.size(); ++i) {
        if (chart.series.empty() || chart.series.back().name != all[i].family)
            chart.series.push_back({all[i].family, {}, false});
        chart.series.back().points.push_back(
            {times[i][1], errors[i], all[i].name, true, times[i][0], times[i][2]});
    }
    std::ofstream(file) << report::to_svg(chart);
}

int run(int argc, char** argv)
{
    const auto all = ways();
    std::vector<std::vector<double>> errors;
    std::vector<std::array<double, 3>> times;
    for (const double sigma2 : kSigma2) {
        const Configurations on(sigma2);
        std::vector<double> of;
        of.reserve(all.size());
        for (const Way& way : all)
            of.push_back(on.error(way));
        errors.push_back(of);
        if (sigma2 == kSigma2[1])
            times = times_of(all, on);
    }
    fmt::print("| way | | error %, 0.002 | 0.02 | 0.3 | ns (least, most) |\n"
               "| --- | --- | --- | --- | --- | --- |\n");
    for (size_t i = 0; i < all.size(); ++i)
        fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.0f} ({:.0f}, {:.0f}) |\n",
                   all[i].family, all[i].name, 100 * errors[0][i], 100 * errors[1][i],
                   100 * errors[2][i], times[i][1], times[i][0], times[i][2]);
    if (argc > 1)
        draw(all, errors[1], times, argv[1]);
    return 0;
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run(argc, argv); }
