// Prints the tables of docs/brdf-parametrizations.md: what interpolation leaves of a BRDF in three
// parametrizations, at equal bytes.
//
//   scree_brdf_figures [DATA_FOLDER]

#include <fmt/format.h>

#include "figures/brdf_errors.h"
#include "figures/data_program.h"
#include "figures/markdown.h"

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

void run(const std::string& data)
{
    const auto materials = brdf_materials(data);
    const auto regions = brdf_regions();
    std::vector<RegionValues> truth;
    truth.reserve(materials.size());
    for (const BrdfMaterial& material : materials)
        truth.push_back(true_values(material, regions));
    print_size({16, 16, 8}, materials, regions, truth);
    print_size({32, 32, 16}, materials, regions, truth);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv) { return scree::test::run_with_data(argc, argv, scree::test::run); }
