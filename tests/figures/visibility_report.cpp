#include "figures/visibility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "figures/markdown.h"

namespace scree::test {
namespace {

constexpr double kWorse = 0.001; ///< of the mean color: what counts as worse than the mean color

double pooled(const SquaresOfAngles& squares)
{
    double sum = 0;
    for (const double square : squares)
        sum += square;
    return std::sqrt(sum / static_cast<double>(squares.size()));
}

/// Errors of a model over those of the first, at one size of footprint, all surfaces.
struct Ratios {
    double squares = 0, largest = 0;
    int count = 0;

    void add(double ratio)
    {
        squares += ratio * ratio;
        largest = std::max(largest, ratio);
        ++count;
    }
};

/// Places where a model is worse than the first one.
struct Worse {
    int cells = 0, of = 0;
    double excess = 0, first = 0; ///< the most, and the error of the first model there
    std::string where;

    void add(const SurfaceFigures& surface, const SizeFigures& size, size_t model,
             const AllViews& views)
    {
        for (size_t angle = 0; angle < views.angles_deg.size(); ++angle) {
            const double naive = std::sqrt(size.squares.front()[angle]);
            const double more = std::sqrt(size.squares[model][angle]) - naive;
            ++of;
            if (more <= kWorse)
                continue;
            ++cells;
            if (more <= excess)
                continue;
            excess = more;
            first = naive;
            where = fmt::format("{} {}, {}, {:g} degrees", surface.surface, surface.slope,
                                size.footprint, views.angles_deg[angle]);
        }
    }
};

void print_worse(const std::vector<SurfaceFigures>& all, const AllViews& views)
{
    const std::vector<std::string>& models = all.front().models;
    fmt::print("\nCells (surface, slope, footprint, angle) where a model is worse than {} by more "
               "than {} % of the mean color, and the worst of them: how much worse, than what, "
               "in % of the mean color.\n\n",
               models.front(), 100 * kWorse);
    print_head({"model", "cells", "worse by", "than", "where"});
    for (size_t m = 1; m < models.size(); ++m) {
        Worse worse;
        for (const SurfaceFigures& surface : all)
            for (const SizeFigures& size : surface.sizes)
                worse.add(surface, size, m, views);
        print_row({models[m], fmt::format("{} of {}", worse.cells, worse.of), percent(worse.excess),
                   percent(worse.first), worse.where});
    }
}

/// The first table that leaves a tenth of what the mean color does.
std::string table_enough(const std::vector<std::string>& models, const SizeFigures& size)
{
    const std::string table = "table ";
    for (size_t m = 0; m < models.size(); ++m)
        if (models[m].rfind(table, 0) == 0 &&
            pooled(size.squares[m]) <= 0.1 * pooled(size.squares.front()))
            return models[m].substr(table.size());
    return "none";
}

/// Figures of one surface, at all slopes.
using OneSurface = std::vector<const SurfaceFigures*>;

void print_pooled(const OneSurface& slopes)
{
    const std::vector<std::string>& models = slopes.front()->models;
    print_head(joined(joined({"slope", "footprint"}, models), {"noise", "table for 1/10"}));
    for (const SurfaceFigures* figures : slopes)
        for (const SizeFigures& size : figures->sizes) {
            std::vector<std::string> cells = {fmt::format("{}", figures->slope), size.footprint};
            for (const SquaresOfAngles& squares : size.squares)
                cells.push_back(percent(pooled(squares)));
            print_row(joined(cells, {percent(pooled(size.noise)), table_enough(models, size)}));
        }
}

void print_angles(const OneSurface& slopes, const AllViews& views)
{
    fmt::print("\nThe whole map, by angle from the normal:\n\n");
    std::vector<std::string> head = {"slope", "model"};
    for (const double angle : views.angles_deg)
        head.push_back(fmt::format("{:g}", angle));
    print_head(head);
    for (const SurfaceFigures* figures : slopes) {
        const SizeFigures& map = figures->sizes.back();
        auto add = [&](const std::string& name, const SquaresOfAngles& squares) {
            std::vector<std::string> cells = {fmt::format("{}", figures->slope), name};
            for (const double square : squares)
                cells.push_back(percent(std::sqrt(square)));
            print_row(cells);
        };
        for (size_t m = 0; m < figures->models.size(); ++m)
            add(figures->models[m], map.squares[m]);
        add("noise", map.noise);
    }
}

void print_worse_line(const OneSurface& slopes, const AllViews& views)
{
    const std::vector<std::string>& models = slopes.front()->models;
    std::string line;
    for (size_t m = 1; m < models.size(); ++m) {
        Worse worse;
        for (const SurfaceFigures* figures : slopes)
            for (const SizeFigures& size : figures->sizes)
                worse.add(*figures, size, m, views);
        line += fmt::format("{}{} {}", m == 1 ? "" : ", ", models[m], worse.cells);
        if (worse.cells > 0)
            line += fmt::format(" (by up to {} %)", percent(worse.excess));
        if (m + 1 == models.size())
            line += fmt::format("; of {} cells", worse.of);
    }
    fmt::print("\nWorse than {}: {}.\n", models.front(), line);
}

} // namespace

void print_summary(const std::vector<SurfaceFigures>& all)
{
    const std::vector<std::string>& models = all.front().models;
    std::vector<std::string> sizes;
    for (const SurfaceFigures& surface : all)
        for (const SizeFigures& size : surface.sizes)
            if (std::find(sizes.begin(), sizes.end(), size.footprint) == sizes.end())
                sizes.push_back(size.footprint);

    fmt::print("Error over that of {}: rms over {} surfaces and slopes / largest.\n\n",
               models.front(), all.size());
    print_head(joined({"footprint"}, sizes));
    for (size_t m = 1; m < models.size(); ++m) {
        std::map<std::string, Ratios> ratios;
        for (const SurfaceFigures& surface : all)
            for (const SizeFigures& size : surface.sizes)
                ratios[size.footprint].add(pooled(size.squares[m]) / pooled(size.squares.front()));
        std::vector<std::string> cells = {models[m]};
        for (const std::string& size : sizes) {
            const Ratios& of_size = ratios[size];
            cells.push_back(fmt::format(
                "{:.3f} / {:.3f}", std::sqrt(of_size.squares / of_size.count), of_size.largest));
        }
        print_row(cells);
    }
}

void print_figures(const std::vector<SurfaceFigures>& all, const AllViews& views)
{
    print_summary(all);
    print_worse(all, views);
    for (size_t first = 0; first < all.size();) {
        OneSurface slopes;
        while (first < all.size() && (slopes.empty() || all[first].surface == slopes[0]->surface))
            slopes.push_back(&all[first++]);
        fmt::print("\n### {}\n\n", slopes.front()->surface);
        print_pooled(slopes);
        print_worse_line(slopes, views);
        print_angles(slopes, views);
    }
}

} // namespace scree::test
