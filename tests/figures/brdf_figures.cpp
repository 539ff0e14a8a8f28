// Prints the tables of docs/brdf-parametrizations.md: what interpolation leaves of a BRDF in three
// parametrizations, at equal bytes.
//
//   scree_brdf_figures [DATA_FOLDER]

#include <fmt/format.h>

#include <cmath>

#include "figures/brdf_materials.h"
#include "figures/data_program.h"
#include "figures/flat_places.h"
#include "figures/markdown.h"
#include "tables/brdf_error.h"

namespace scree::test {
namespace {

struct Axes {
    const char* words;
    BrdfSpacing spacing;
    bool fitted;
};
constexpr std::array<Axes, 4> kAxes = {{{"even", BrdfSpacing::even, false},
                                        {"root", BrdfSpacing::root, false},
                                        {"angle", BrdfSpacing::angle, false},
                                        {"angle, fitted", BrdfSpacing::angle, true}}};
constexpr std::array<BrdfParametrization, 3> kParametrizations = {
    BrdfParametrization::half_difference, BrdfParametrization::orthographic,
    BrdfParametrization::hybrid};

const char* short_name(BrdfParametrization parametrization)
{
    if (parametrization == BrdfParametrization::half_difference)
        return "H/D";
    return parametrization == BrdfParametrization::orthographic ? "orth" : "hyb";
}

constexpr size_t kPairs = 6000; ///< of a region

void no_progress(double /*share*/) {}

std::vector<double> interpolation_errors(const BrdfMaterial& material, const BrdfGrid& grid,
                                         const std::vector<BrdfRegion>& regions,
                                         const RegionValues& truth)
{
    const auto table = brdf_table(grid, material.brdf, no_progress);
    return relative_errors(region_values(grid, table, regions), truth);
}

void print_size(const std::array<int, 3>& size, const std::vector<BrdfMaterial>& materials,
                const std::vector<BrdfRegion>& regions, const std::vector<RegionValues>& truth)
{
    fmt::print("\n{}x{}x{} nodes, rms error in percent of the rms value\n\n", size[0], size[1],
               size[2]);
    std::vector<std::string> head = {"material", "axes"};
    for (const BrdfRegion& region : regions)
        for (const auto parametrization : kParametrizations)
            head.push_back(region.name + " " + short_name(parametrization));
    print_head(head);
    for (size_t m = 0; m < materials.size(); ++m)
        for (const Axes& axes : kAxes) {
            std::array<std::vector<double>, 3> errors;
            for (size_t p = 0; p < errors.size(); ++p)
                errors[p] = interpolation_errors(
                    materials[m], {kParametrizations[p], size, axes.spacing, axes.fitted}, regions,
                    truth[m]);
            std::vector<std::string> row = {materials[m].name, axes.words};
            row.reserve(row.size() + errors.size() * regions.size());
            for (size_t r = 0; r < regions.size(); ++r)
                for (const auto& of : errors)
                    row.push_back(fmt::format("{:.1f}", 100 * of[r]));
            print_row(row);
        }
}

/// What the kernel says of whole surfaces against rays.
void print_kernel(const std::vector<BrdfSurface>& surfaces, const std::vector<BrdfRegion>& regions)
{
    constexpr int kGrid = 96;
    fmt::print("\nThe kernel's BRDF against rays, rms in percent of the rms value\n\n");
    std::vector<std::string> head = {"surface", ""};
    for (const BrdfRegion& region : regions)
        head.push_back(region.name);
    print_head(head);
    const auto print = [](const std::string& name, const std::string& what,
                          const std::vector<double>& values) {
        std::vector<std::string> row = {name, what};
        for (const double value : values)
            row.push_back(fmt::format("{:.1f}", 100 * value));
        print_row(row);
    };
    for (const BrdfSurface& surface : surfaces) {
        const auto truth = region_values(surface.traced(kGrid, 1), regions, no_progress);
        const auto again = region_values(surface.traced(kGrid, 2), regions, no_progress);
        for (const int side : {1, 4, 16, 64})
            print(surface.name, fmt::format("kernel, {0}x{0} texels", side),
                  relative_errors(region_values(surface.baked(side), regions, no_progress), truth));
        auto noise = relative_errors(again, truth);
        for (double& each : noise)
            each /= std::sqrt(2);
        print(surface.name, "noise of the rays", noise);
    }
}

/// Mirrored views, and why the kernel's are too bright.
void print_mirrored(const std::vector<BrdfSurface>& surfaces)
{
    constexpr int kGrid = 160;
    fmt::print("\nView and light mirrored in the surface: BRDF, and what flat places see\n\n");
    print_head({"surface", "degrees", "kernel", "rays", "open to one", "to both",
                "to both by Smith", "height rank"});
    for (const BrdfSurface& surface : surfaces) {
        const BrdfFunction kernel = surface.baked(1), rays = surface.traced(kGrid, 1);
        for (const int degrees : {60, 75, 80, 84}) {
            const double angle = degrees * std::acos(-1.0) / 180;
            const Vec3 wo(std::sin(angle), 0, std::cos(angle)), wi(-wo.x, 0, wo.z);
            const FlatPlaces flat = flat_places(*surface.surface, degrees);
            const auto number = [](auto value) { return fmt::format("{:.2f}", value); };
            print_row({surface.name, std::to_string(degrees), number(kernel({wo, wi})[1]),
                       number(rays({wo, wi})[1]), number(flat.open), number(flat.open_both),
                       number(flat.smith_both), number(flat.height_rank)});
        }
    }
}

void run(const std::string& data)
{
    constexpr int kGrid = 32;
    auto materials = brdf_formulas();
    const auto surfaces = brdf_surfaces(data);
    for (const BrdfSurface& surface : surfaces) {
        materials.push_back({surface.name, surface.baked(4)});
        materials.push_back({surface.name + ", rays", surface.traced(kGrid, 1)});
    }
    const auto regions = brdf_regions(kPairs);
    std::vector<RegionValues> truth;
    truth.reserve(materials.size());
    for (const BrdfMaterial& material : materials)
        truth.push_back(region_values(material.brdf, regions, no_progress));
    print_size({16, 16, 8}, materials, regions, truth);
    print_size({32, 32, 16}, materials, regions, truth);
    print_kernel(surfaces, brdf_regions(500));
    print_mirrored(surfaces);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run_with_data(argc, argv, scree::test::run); }
