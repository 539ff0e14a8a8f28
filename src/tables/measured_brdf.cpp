#include "tables/measured_brdf.h"

#include <cmath>
#include <utility>

#include "tables/brdf_error.h"

namespace scree {

namespace {

constexpr size_t kPairs = 1000; ///< of a region

/// Progress of work in parts, by the BRDF's values that each takes.
class Parts {
public:
    Parts(size_t values, const std::function<void(double)>& progress)
        : all_(static_cast<double>(values)), progress_(progress)
    {}

    /// For the next part; valid until the one after it is asked for.
    std::function<void(double)> next(size_t values)
    {
        begin_ += part_;
        part_ = static_cast<double>(values);
        return [this](double done) { progress_((begin_ + done * part_) / all_); };
    }

private:
    double all_, begin_ = 0, part_ = 0;
    const std::function<void(double)>& progress_;
};

std::vector<BrdfGrid> grids_of(const BrdfGrid& grid, bool compare)
{
    std::vector<BrdfGrid> grids = {grid};
    for (const auto other : {BrdfParametrization::hybrid, BrdfParametrization::orthographic,
                             BrdfParametrization::half_difference})
        if (compare && other != grid.parametrization) {
            grids.push_back(grid);
            grids.back().parametrization = other;
        }
    return grids;
}

void note(const std::string& what, const std::vector<BrdfRegion>& regions,
          const std::vector<double>& errors, std::vector<TableFigure>& figures)
{
    for (size_t r = 0; r < regions.size(); ++r)
        figures.push_back({what + regions[r].name, 100 * errors[r]});
}

} // namespace

MeasuredBrdf measured_brdf(const BrdfGrid& grid, const BrdfSource& source, bool compare,
                           const std::function<void(double)>& progress)
{
    const auto regions = brdf_regions(kPairs);
    const auto grids = grids_of(grid, compare);
    const size_t checked = kPairs * regions.size();
    Parts parts(grids.size() * grid.nodes() + (source.again ? 2 : 1) * checked, progress);

    MeasuredBrdf made;
    std::vector<RegionValues> found;
    for (const BrdfGrid& each : grids) {
        auto values = brdf_table(each, source.brdf, parts.next(grid.nodes()));
        found.push_back(region_values(each, values, regions));
        if (made.values.empty())
            made.values = std::move(values);
    }
    const RegionValues truth = region_values(source.brdf, regions, parts.next(checked));
    for (size_t g = 0; g < grids.size(); ++g)
        note("rms error in %, " + name_of(grids[g].parametrization) + ", ", regions,
             relative_errors(found[g], truth), made.figures);
    if (source.again) {
        auto noise =
            relative_errors(region_values(source.again, regions, parts.next(checked)), truth);
        for (double& each : noise)
            each /= std::sqrt(2); // of a difference of two
        note("rms noise in %, ", regions, noise, made.figures);
    }
    return made;
}

} // namespace scree
