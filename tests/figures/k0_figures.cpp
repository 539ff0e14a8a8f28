// How slopes of real surfaces are distributed, against the laws a texture set can stand for:
// Gaussian, K0, and their mixture by tau. Affine: heights may have any scale.
//
//   scree_k0_figures [DATA_FOLDER] > figures.md
//
// Without a folder, on the built-in samples alone.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "figures/data_program.h"
#include "figures/markdown.h"
#include "figures/visibility_surfaces.h"
#include "kernel/k0.h"

namespace scree::test {
namespace {

using reference::Relief;

struct Slope {
    double s, t;
};

/// Slopes of the bilinear surface of the wrapped heights at 2x2 points between texel centres, of a
/// square of texels.
std::vector<Slope> slopes_of(const Relief& relief, int x0, int y0, int size)
{
    const auto height = [&](int x, int y) {
        return relief
            .heights[static_cast<size_t>(y % relief.height) * static_cast<size_t>(relief.width) +
                     static_cast<size_t>(x % relief.width)];
    };
    std::vector<Slope> out;
    for (int y = y0; y < y0 + size; ++y)
        for (int x = x0; x < x0 + size; ++x) {
            const double h00 = height(x, y), h10 = height(x + 1, y);
            const double h01 = height(x, y + 1), h11 = height(x + 1, y + 1);
            for (const double f : {0.25, 0.75})
                for (const double g : {0.25, 0.75})
                    out.push_back(
                        {((1 - g) * (h10 - h00) + g * (h11 - h01)) / relief.texel_width,
                         ((1 - f) * (h01 - h00) + f * (h11 - h10)) / relief.texel_height});
        }
    return out;
}

/// Distances from the mean in deviations, rising; empty where the slopes have no second direction.
std::vector<double> distances(const std::vector<Slope>& slopes)
{
    const auto count = static_cast<double>(slopes.size());
    double ms = 0, mt = 0, ss = 0, st = 0, tt = 0;
    for (const Slope& p : slopes)
        ms += p.s / count, mt += p.t / count;
    for (const Slope& p : slopes) {
        ss += (p.s - ms) * (p.s - ms) / count;
        st += (p.s - ms) * (p.t - mt) / count;
        tt += (p.t - mt) * (p.t - mt) / count;
    }
    const double det = ss * tt - st * st;
    std::vector<double> out;
    if (det <= 1e-6 * (ss + tt) * (ss + tt))
        return out;
    for (const Slope& p : slopes) {
        const double s = p.s - ms, t = p.t - mt;
        out.push_back(std::sqrt((tt * s * s - 2 * st * s * t + ss * t * t) / det));
    }
    std::sort(out.begin(), out.end());
    return out;
}

/// Share of slopes within d deviations.
double within(double d, double tau)
{
    const double x = std::sqrt(2.0) * d;
    double growth = 0;
    const double xk1 = kernel::scree_bessel_x_k1(x, growth);
    return 1 - (1 - tau) * std::exp(-d * d / 2) - tau * xk1 * kernel::scree_exp_minus(-growth);
}

/// What is compared: the largest difference of shares within any distance, and shares close to the
/// mean and far from it.
struct Figures {
    double tau = 0, gaussian = 0, k0 = 0, mixture = 0;
    double close = 0, far = 0, close_law = 0, far_law = 0;
    int count = 0;
};

constexpr double kClose = 0.25, kFar = 4;

double largest_difference(const std::vector<double>& d, double tau)
{
    double most = 0;
    for (size_t i = 0; i < d.size(); ++i) {
        const double law = within(d[i], tau), count = static_cast<double>(d.size());
        most = std::max({most, std::abs(law - static_cast<double>(i) / count),
                         std::abs(law - static_cast<double>(i + 1) / count)});
    }
    return most;
}

void add(Figures& figures, const std::vector<double>& d)
{
    double kurtosis = 0;
    for (const double value : d)
        kurtosis += std::pow(value, 4) / static_cast<double>(d.size());
    const double tau = std::clamp((kurtosis - 8) / 8, 0.0, 1.0);
    const auto share = [&](double from, double to) {
        return static_cast<double>(std::lower_bound(d.begin(), d.end(), to) -
                                   std::lower_bound(d.begin(), d.end(), from)) /
               static_cast<double>(d.size());
    };
    figures.tau += tau;
    figures.gaussian += largest_difference(d, 0);
    figures.k0 += largest_difference(d, 1);
    figures.mixture += largest_difference(d, tau);
    figures.close += share(0, kClose);
    figures.far += share(kFar, 1e30);
    figures.close_law += within(kClose, tau);
    figures.far_law += 1 - within(kFar, tau);
    figures.count += 1;
}

void print(const std::string& name, const std::string& size, const Figures& f)
{
    if (f.count == 0)
        return;
    std::vector<std::string> row = {name, size, fmt::format("{:.2f}", f.tau / f.count)};
    for (const double value : {f.gaussian, f.k0, f.mixture, f.close, f.close_law, f.far, f.far_law})
        row.push_back(percent(value / f.count));
    print_row(row);
}

void run(const std::string& data)
{
    print_head({"surface", "texels", "tau", "Gaussian", "K0", "mixture", "d < 1/4", "of the law",
                "d > 4", "of the law"});
    for (const Asset& asset : visibility_surfaces(data)) {
        std::mt19937 random(7);
        const Relief& relief = asset.relief;
        for (const int size : {16, 64}) {
            Figures figures;
            for (int i = 0; i < 100; ++i) {
                const int x = static_cast<int>(random() % static_cast<unsigned>(relief.width));
                const int y = static_cast<int>(random() % static_cast<unsigned>(relief.height));
                const auto d = distances(slopes_of(relief, x, y, size));
                if (!d.empty())
                    add(figures, d);
            }
            print(asset.name, std::to_string(size), figures);
        }
        Figures map;
        const auto d = distances(slopes_of(relief, 0, 0, std::min(relief.width, relief.height)));
        if (!d.empty())
            add(map, d);
        print(asset.name, "map", map);
    }
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run_with_data(argc, argv, scree::test::run); }
