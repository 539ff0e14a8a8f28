// Measures what each way to tell the visible color leaves: baked, read back and evaluated by the
// kernel, against the reference renderer.
//
//   scree_visibility_figures [--nodes] [DATA_FOLDER] > figures.md
//
// Without a folder, on the built-in samples alone. With --nodes it compares numbers of nodes, pixel
// types and ways to interpolate between nodes instead.

#include <cstdio>
#include <string>
#include <vector>

#include "figures/visibility_measure.h"
#include "figures/visibility_report.h"
#include "figures/visibility_surfaces.h"
#include "math/error.h"

namespace scree::test {
namespace {

std::vector<SurfaceFigures> measure_all(const std::string& data, Comparison comparison,
                                        const AllViews& views)
{
    const std::vector<double> slopes =
        comparison == Comparison::models ? std::vector{0.1, 0.3, 0.6} : std::vector{0.3};
    std::vector<SurfaceFigures> all;
    for (const Asset& asset : visibility_surfaces(data)) {
        const double as_it_is = rms_slope(asset);
        for (const double slope : slopes)
            all.push_back(
                measure(with_heights_scaled(asset, slope / as_it_is), slope, comparison, views));
    }
    return all;
}

void run(const std::string& data, Comparison comparison)
{
    const AllViews views;
    const auto all = measure_all(data, comparison, views);
    if (comparison == Comparison::models)
        print_figures(all, views);
    else
        print_summary(all);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv)
{
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool nodes = !words.empty() && words.front() == "--nodes";
    if (nodes)
        words.erase(words.begin());
    if (words.size() > 1) {
        std::fprintf(stderr, "usage: %s [--nodes] [DATA_FOLDER]\n", argv[0]);
        return 2;
    }
    try {
        scree::test::run(words.empty() ? "" : words.front(),
                         nodes ? scree::test::Comparison::nodes : scree::test::Comparison::models);
    } catch (const scree::Error& error) {
        std::fprintf(stderr, "%s: error: %s\n", argv[0], error.what());
        return 1;
    }
    return 0;
}
