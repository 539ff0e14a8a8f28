// Measures the closed forms of visible slopes, what their error does to shading, and what tables of
// visible slopes would take off it, against the reference renderer.
//
//   scree_slope_figures [DATA_FOLDER] > figures.md
//
// Without a folder, on the built-in samples alone.

#include <string>
#include <vector>

#include "figures/data_program.h"
#include "figures/slope_report.h"
#include "figures/visibility_surfaces.h"

namespace scree::test {
namespace {

SurfaceSlopeFigures measure(const Asset& asset, double slope, const SlopeViews& views)
{
    const reference::DisplacedSurface surface = white_and_gray(asset);
    SurfaceSlopeFigures figures{asset.name, slope, {}};
    for (const SlopesOfSize& size : see_slopes(asset, surface, views))
        figures.sizes.push_back(measure_slopes(size, views, slope));
    return figures;
}

void run(const std::string& data)
{
    const SlopeViews views;
    SurfacesSlopeFigures all;
    for (const Asset& asset : visibility_surfaces(data)) {
        const double as_it_is = rms_slope(asset);
        for (const double slope : {0.1, 0.3, 0.6})
            all.push_back(measure(with_heights_scaled(asset, slope / as_it_is), slope, views));
    }
    print_slope_figures(all, views);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run_with_data(argc, argv, scree::test::run); }
