#include "tables/brdf_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace scree {

std::vector<float> brdf_table(const BrdfGrid& grid, const BrdfFunction& brdf,
                              const std::function<void(double)>& progress)
{
    std::vector<float> values(3 * grid.nodes());
    const auto width = static_cast<size_t>(grid.size[0]);
    const int rows = grid.size[1] * grid.size[2];
    for (int row = 0; row < rows; ++row) {
        float* first = values.data() + 3 * width * static_cast<size_t>(row);
        tbb::parallel_for(0, grid.size[0], [&](int i) {
            const Rgbf value = brdf(grid.directions(i, row % grid.size[1], row / grid.size[1]));
            std::copy(value.begin(), value.end(), first + 3 * static_cast<size_t>(i));
        });
        progress(static_cast<double>(row + 1) / rows);
    }
    return values;
}

TableManifest brdf_manifest(const BrdfGrid& grid)
{
    TableManifest manifest;
    manifest.kind = "brdf-" + name_of(grid.parametrization);
    manifest.description =
        "The BRDF of a level of a texture set, isotropic and reciprocal: the mean over its texels, "
        "over turns and mirror images of the surface, and over both ways of light.";
    manifest.axes = grid.axes();
    const std::string meaning = "reflected radiance per irradiance";
    manifest.channels = {{"R", "BRDF, red", "1 / sr", meaning},
                         {"G", "BRDF, green", "1 / sr", meaning},
                         {"B", "BRDF, blue", "1 / sr", meaning}};
    return manifest;
}

} // namespace scree
