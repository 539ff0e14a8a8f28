// Measures what each way to tell the color of what is seen and lit leaves: baked, read back and
// evaluated by the kernel, against the reference renderer.
//
//   scree_light_figures [DATA_FOLDER] > figures.md
//
// Without a folder, on the built-in samples alone.

#include <string>
#include <vector>

#include "figures/data_program.h"
#include "figures/light_measure.h"
#include "figures/light_report.h"
#include "figures/visibility_surfaces.h"

namespace scree::test {
namespace {

void run(const std::string& data)
{
    std::vector<LightFigures> all;
    for (const Asset& asset : visibility_surfaces(data)) {
        const double as_it_is = rms_slope(asset);
        for (const double slope : {0.1, 0.3, 0.6})
            all.push_back(measure_light(with_heights_scaled(asset, slope / as_it_is), slope));
    }
    print_light_figures(all);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run_with_data(argc, argv, scree::test::run); }
