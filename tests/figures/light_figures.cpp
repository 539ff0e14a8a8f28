// Measures what each way to tell the color of what is seen and lit leaves: baked, read back and
// evaluated by the kernel, against the reference renderer.
//
//   scree_light_figures [DATA_FOLDER] > figures.md
//
// Without a folder, on the built-in samples alone.

#include <cstdio>
#include <string>
#include <vector>

#include "figures/light_measure.h"
#include "figures/light_report.h"
#include "figures/visibility_surfaces.h"
#include "math/error.h"

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

int main(int argc, char** argv)
{
    if (argc > 2) {
        std::fprintf(stderr, "usage: %s [DATA_FOLDER]\n", argv[0]);
        return 2;
    }
    try {
        scree::test::run(argc == 2 ? argv[1] : "");
    } catch (const scree::Error& error) {
        std::fprintf(stderr, "%s: error: %s\n", argv[0], error.what());
        return 1;
    }
    return 0;
}
