// Draws docs/stability.svg: where four ways to the visible slopes hold.
//
//   scree_stability_map docs/stability.svg
//
// Over z (how far the mean plane is from facing away, in deviations) and the ratio of the slope's
// two standard deviations, the worst error of three correlations and four azimuths: the larger of
// the visible mean's, relative to the standard deviation of the slope, and the visible
// covariance's, relative to its trace. Truth is the oracle of the tests.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "figures/drawing.h"
#include "kernel/cases.h"
#include "kernel/oracle.h"
#include "kernel/published.h"

namespace scree::test {
namespace {

constexpr int kColumns = 81;     // z = -40 .. 40
constexpr int kRows = 17;        // ratio = 10^0 .. 10^4
constexpr double kBroken = 1e30; // NaN, infinity
enum Way { kPrinted, kMended, kDouble, kFloat, kWays };

using Moments = std::array<double, 5>; // s t ss st tt
using Errors = std::array<double, kWays>;

KernelCase cell_case(double z, double ratio, double correlation, double azimuth)
{
    constexpr double kSigma = 0.4, kTheta = 1.2;
    const double ss = kSigma * kSigma, st = correlation * ss / ratio, tt = ss / (ratio * ratio);
    const double x = std::sin(kTheta) * std::cos(azimuth), y = std::sin(kTheta) * std::sin(azimuth);
    const double b = std::sqrt(ss * x * x + 2 * st * x * y + tt * y * y);
    const double along = (std::cos(kTheta) - z * b) / (x * x + y * y);
    KernelCase row;
    const auto set = [&](int i, double value) {
        row.in[static_cast<size_t>(i)] = static_cast<float>(value);
    };
    set(kWox, x), set(kWoy, y), set(kWoz, std::cos(kTheta)), set(kWiz, 1);
    set(kMeanS, along * x), set(kMeanT, along * y);
    set(kCss, ss), set(kCst, st), set(kCtt, tt);
    return row;
}

double error(const Moments& got, const Moments& want, double sigma)
{
    const double trace = want[2] + want[4];
    double worst = 0;
    for (size_t i = 0; i < got.size(); ++i) {
        if (!std::isfinite(got[i]))
            return kBroken;
        worst = std::max(worst, std::abs(got[i] - want[i]) / (i < 2 ? sigma : trace));
    }
    return worst;
}

template <typename Real>
Moments moments(const Outputs<Real>& out)
{
    Moments all{};
    for (size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<double>(out[kVisibleS + i]);
    return all;
}

Moments published(const KernelCase& row, Form form)
{
    const auto in = [&](Input i) { return static_cast<double>(row.in[static_cast<size_t>(i)]); };
    const double theta = std::atan2(std::hypot(in(kWox), in(kWoy)), in(kWoz));
    const PublishedResult r =
        published_visible_slopes(in(kMeanS), in(kMeanT), in(kCss), in(kCst), in(kCtt), theta,
                                 std::atan2(in(kWoy), in(kWox)), form);
    return {r.s, r.t, r.ss, r.st, r.tt};
}

Errors cell(double z, double ratio)
{
    Errors worst{};
    for (const double correlation : {0.0, 0.9, -0.99})
        for (const double azimuth : {0.0, 0.4, 1.1, 1.5}) {
            const KernelCase row = cell_case(z, ratio, correlation, azimuth);
            const Moments want = moments(oracle(row, Digits::k60));
            const double sigma = std::sqrt(static_cast<double>(row.in[kCss] + row.in[kCtt]));
            const Errors here = {error(published(row, Form::as_printed), want, sigma),
                                 error(published(row, Form::mended), want, sigma),
                                 error(moments(evaluate<double>(row)), want, sigma),
                                 error(moments(evaluate<float>(row)), want, sigma)};
            for (size_t w = 0; w < kWays; ++w)
                worst[w] = std::max(worst[w], here[w]);
        }
    return worst;
}

const std::vector<ColorStep>& colors()
{
    static const std::vector<ColorStep> all = {
        {"#0b5d3b", 1e-7, "< 1e-7"}, {"#2f9e5b", 1e-6, "< 1e-6"},
        {"#a5d96a", 1e-4, "< 1e-4"}, {"#ffe08a", 1e-2, "< 1e-2"},
        {"#f68d4b", 1, "< 1"},       {"#c4262e", kBroken, "1 and more"},
        {"#000000", 0, "inf or NaN"}};
    return all;
}

std::string panel(double left, double top, const std::string& title,
                  const std::vector<Errors>& cells, size_t way)
{
    constexpr double kWide = 4, kHigh = 10;
    std::string svg =
        centred_text({left + kWide * kColumns / 2, top - 8}, title, "font-weight=\"bold\"");
    svg += cell_map({left, top}, kWide, kHigh, kColumns, kRows, [&](int column, int row) {
        const auto& of =
            cells[static_cast<size_t>(kRows - 1 - row) * kColumns + static_cast<size_t>(column)];
        return std::string(colors()[step_of(colors(), of[way])].fill);
    });
    for (const int z : {-40, -20, 0, 20, 40})
        svg +=
            centred_text({left + (z + 40.5) * kWide, top + kRows * kHigh + 15}, std::to_string(z));
    for (const int power : {0, 2, 4})
        svg += report::svg_text({left - 6, top + (kRows - 0.5 - 4 * power) * kHigh + 4},
                                "1e" + std::to_string(power), "text-anchor=\"end\"");
    return svg;
}

constexpr std::array<const char*, kWays> kTitles = {"published, as printed (double)",
                                                    "published, mended (double)", "Scree, double",
                                                    "Scree, float"};

void print_worst(const std::vector<Errors>& cells)
{
    for (size_t way = 0; way < kWays; ++way) {
        const auto worst =
            std::max_element(cells.begin(), cells.end(),
                             [&](const Errors& a, const Errors& b) { return a[way] < b[way]; });
        const auto bad = std::count_if(cells.begin(), cells.end(),
                                       [&](const Errors& e) { return !(e[way] <= 1e-4); });
        std::printf("%-32s worst error %8.2g   above 1e-4 in %4.1f %% of the map\n", kTitles[way],
                    (*worst)[way], 100.0 * static_cast<double>(bad) / (kRows * kColumns));
    }
}

std::string draw()
{
    std::vector<Errors> cells;
    for (int r = 0; r < kRows; ++r)
        for (int c = 0; c < kColumns; ++c)
            cells.push_back(cell(c - 40, std::pow(10.0, r / 4.0)));
    print_worst(cells);

    std::string svg;
    for (size_t way = 0; way < kWays; ++way)
        svg += panel(way % 2 == 0 ? 60 : 460, way < 2 ? 40 : 270, kTitles[way], cells, way);
    svg += centred_text({410, 478},
                        "z = a / b across, ratio of the slope's standard deviations upwards");
    return drawing(820, 520, svg + color_key({90, 492}, 96, colors()));
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::draw_to_file(argc, argv, scree::test::draw); }
