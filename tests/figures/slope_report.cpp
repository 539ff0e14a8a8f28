#include "figures/slope_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "figures/slope_plane_albedo.h"
#include "figures/slope_two_scales.h"

namespace scree::test {
namespace {

using Surfaces = SurfacesSlopeFigures;
using Ways = std::vector<std::string>;
using Cells = std::vector<std::string>;

const Ways kUnchanged = {"unchanged"};
const Ways kClosed = {"Gaussian", "K0", "mixture", "gain of mean", "gain of both"};
const Ways kTables = {"table 0",      "table 1",      "table 2",
                      "table 0, map", "table 1, map", "table 2, map"};

void print_row(const Cells& cells)
{
    for (const std::string& cell : cells)
        fmt::print("| {} ", cell);
    fmt::print("|\n");
}

void print_head(const Cells& cells)
{
    print_row(cells);
    for (size_t i = 0; i < cells.size(); ++i)
        fmt::print("|---");
    fmt::print("|\n");
}

Ways with(Ways first, const Ways& rest)
{
    first.insert(first.end(), rest.begin(), rest.end());
    return first;
}

std::string percent(double error) { return fmt::format("{:.1f}", 100 * error); }

void print_pooled(const Surfaces& all, const std::string& title, const Ways& ways,
                  const std::vector<Column>& columns)
{
    fmt::print("\n{}\n\n", title);
    Cells head = {""};
    for (const Column& column : columns)
        head.push_back(column.name);
    print_head(head);
    for (const std::string& way : ways) {
        Cells cells = {way};
        for (const Column& column : columns)
            cells.push_back(pooled(all, way, column).text());
        print_row(cells);
    }
}

std::vector<Column> by_angle_and_size(Figure figure, const SlopeViews& views)
{
    std::vector<Column> columns;
    for (const size_t angle : kNodeAngles)
        columns.push_back(
            {fmt::format("map, {:g}", views.angles_deg[angle]), kSizeMap, figure, {angle}});
    columns.push_back({"map", kSizeMap, figure, kNodeAngles});
    columns.push_back({"64", kSize64, figure, kNodeAngles});
    columns.push_back({"16", kSize16, figure, kNodeAngles});
    return columns;
}

std::vector<Column> by_moments_and_in_all(Figure by_moments, Figure in_all)
{
    return {{"map, by moments", kSizeMap, by_moments, kNodeAngles},
            {"map", kSizeMap, in_all, kNodeAngles},
            {"64, by moments", kSize64, by_moments, kNodeAngles},
            {"64", kSize64, in_all, kNodeAngles},
            {"16, by moments", kSize16, by_moments, kNodeAngles},
            {"16", kSize16, in_all, kNodeAngles}};
}

void print_slopes_and_shading(const Surfaces& all, const SlopeViews& views)
{
    const Ways told = with(kClosed, kTables);
    const Ways all_told = with(kUnchanged, told);
    print_pooled(all, "Mean of the visible slopes, error in % of the rms slope.",
                 with(all_told, {"noise"}), by_angle_and_size(Figure::mean, views));
    print_pooled(all,
                 "Covariance of the visible slopes, error in % of the trace of what was baked.",
                 with(all_told, {"noise"}), by_angle_and_size(Figure::covariance, views));
    print_pooled(all, "Diffuse radiance, error in % of its rms.",
                 with(all_told, {"true moments", "noise"}),
                 by_moments_and_in_all(Figure::diffuse_by_moments, Figure::diffuse));
    const Ways specular =
        with(told, {"true moments", "kernel", "kernel, base not masking", "noise"});
    print_pooled(all, "Specular radiance, base roughness 0.3.", specular,
                 by_moments_and_in_all(Figure::specular_by_moments, Figure::specular));
    print_pooled(all, "Specular radiance, base roughness 0.1.", specular,
                 by_moments_and_in_all(Figure::smooth_by_moments, Figure::smooth));
}

/// What a way takes off the error of another one, per size, and of it per 100 bytes a texel.
Cells taken_off(const Surfaces& all, const std::string& without, const std::string& way,
                double bytes, Figure figure, const Angles& angles)
{
    Cells cells = {fmt::format("{:g}", bytes)};
    for (const size_t size : {kSizeMap, kSize64, kSize16}) {
        const Column column{"", size, figure, angles};
        const double off = pooled(all, without, column).rms() - pooled(all, way, column).rms();
        std::string cell = percent(off);
        if (bytes > 0)
            cell += " (" + percent(100 * off / bytes) + ")";
        cells.push_back(cell);
    }
    return cells;
}

/// Bytes a texel of a table of four nodes in half floats.
double table_bytes(int numbers, int harmonics) { return 2.0 * numbers * 4 * (1 + 2 * harmonics); }

void print_payment(const Surfaces& all, const std::string& where, const Angles& angles)
{
    fmt::print("\nWhat tables of four nodes as half floats take off, {}, in % (and per 100 bytes a "
               "texel): of slopes off the diffuse radiance of the mixture, of color off the mean "
               "color. True moments are what a table would hold that is free of errors.\n\n",
               where);
    print_head({"", "bytes", "slopes: map", "64", "16", "bytes", "color: map", "64", "16"});
    auto print_slopes = [&](const std::string& way, double bytes, const Cells& of_color) {
        Cells cells = with(
            with({way}, taken_off(all, "mixture", way, bytes, Figure::diffuse, angles)), of_color);
        cells.resize(9);
        print_row(cells);
    };
    print_slopes("gain of mean", 0, {});
    print_slopes("gain of both", 0, {});
    for (int harmonics = 0; harmonics <= 2; ++harmonics) {
        const std::string table = fmt::format("table {}", harmonics);
        print_slopes(
            table, table_bytes(5, harmonics),
            taken_off(all, "unchanged", table, table_bytes(4, harmonics), Figure::color, angles));
        print_slopes(table + ", map", table_bytes(5, harmonics), {});
    }
    print_slopes("true moments", table_bytes(5, 2), {});
}

/// Counts where a way shades worse than the mixture.
void print_worse(const Surfaces& all, const SlopeViews& views)
{
    constexpr double kWorse = 0.005;
    fmt::print("\nCells (surface, slope, footprint, node) where diffuse radiance is worse than the "
               "mixture's by more than {} % of its rms, and better by as much.\n\n",
               100 * kWorse);
    print_head({"", "worse", "better", "worse by at most", "than", "where"});
    for (const std::string& way : with(kClosed, {"table 2", "table 2, map", "true moments"})) {
        int worse = 0, better = 0, cells = 0;
        double most = 0, than = 0;
        std::string where;
        for (const SurfaceSlopeFigures& surface : all)
            for (const SlopeSizeFigures& size : surface.sizes)
                for (const size_t angle : kNodeAngles) {
                    const double start =
                        error_of(size, "mixture", Figure::diffuse, {angle}).value();
                    const double more =
                        error_of(size, way, Figure::diffuse, {angle}).value() - start;
                    ++cells;
                    worse += more > kWorse ? 1 : 0;
                    better += more < -kWorse ? 1 : 0;
                    if (more > std::max(most, kWorse)) {
                        most = more;
                        than = start;
                        where = fmt::format("{} {}, {}, {:g} degrees", surface.surface,
                                            surface.slope, size.footprint, views.angles_deg[angle]);
                    }
                }
        if (way != "mixture")
            print_row({way, fmt::format("{} of {}", worse, cells), fmt::format("{}", better),
                       percent(most), percent(than), where});
    }
}

/// A column of a table that has a line a surface and slope.
struct LineColumn {
    std::string name, way;
    Figure figure = Figure::mean;
};

void print_lines(const Surfaces& all, const std::string& title,
                 const std::vector<LineColumn>& columns)
{
    fmt::print("\n{}\n\n", title);
    Cells head = {"surface", "slope", "tau", "gains"};
    for (const LineColumn& column : columns)
        head.push_back(column.name);
    print_head(head);
    for (const SurfaceSlopeFigures& surface : all) {
        const SlopeSizeFigures& map = surface.sizes[kSizeMap];
        Cells cells = {surface.surface, fmt::format("{}", surface.slope),
                       fmt::format("{:.2f}", map.tau),
                       fmt::format("{:.2f}, {:.2f}", map.gain.mean, map.gain.covariance)};
        for (const LineColumn& column : columns)
            cells.push_back(percent(error_of(map, column.way, column.figure, kNodeAngles).value()));
        print_row(cells);
    }
}

void print_surfaces(const Surfaces& all)
{
    print_lines(all,
                "Whole maps, visible slopes: mean, % of the rms slope; covariance, % of the trace "
                "of what was baked.",
                {{"mean: unchanged", "unchanged", Figure::mean},
                 {"Gaussian", "Gaussian", Figure::mean},
                 {"K0", "K0", Figure::mean},
                 {"mixture", "mixture", Figure::mean},
                 {"gain of mean", "gain of mean", Figure::mean},
                 {"table 2, map", "table 2, map", Figure::mean},
                 {"noise", "noise", Figure::mean},
                 {"covariance: unchanged", "unchanged", Figure::covariance},
                 {"Gaussian", "Gaussian", Figure::covariance},
                 {"K0", "K0", Figure::covariance},
                 {"mixture", "mixture", Figure::covariance},
                 {"gain of both", "gain of both", Figure::covariance},
                 {"table 2, map", "table 2, map", Figure::covariance},
                 {"noise", "noise", Figure::covariance}});
    print_lines(all,
                "Whole maps, radiance, % of its rms: diffuse, and specular of base roughness 0.3.",
                {{"by moments: Gaussian", "Gaussian", Figure::diffuse_by_moments},
                 {"mixture", "mixture", Figure::diffuse_by_moments},
                 {"diffuse: unchanged", "unchanged", Figure::diffuse},
                 {"Gaussian", "Gaussian", Figure::diffuse},
                 {"K0", "K0", Figure::diffuse},
                 {"mixture", "mixture", Figure::diffuse},
                 {"gain of mean", "gain of mean", Figure::diffuse},
                 {"gain of both", "gain of both", Figure::diffuse},
                 {"table 2, map", "table 2, map", Figure::diffuse},
                 {"true moments", "true moments", Figure::diffuse},
                 {"specular: mixture", "mixture", Figure::specular},
                 {"true moments", "true moments", Figure::specular},
                 {"kernel", "kernel", Figure::specular}});
}

void print_base(const Surfaces& all, const SlopeViews& views, size_t base)
{
    const double alpha = kBaseAlphas[base];
    fmt::print("\nSpecular radiance of whole maps, base roughness {:g}, error in % of its rms, "
               "over surfaces: of the kernel, and with the base in the lobe but not in the "
               "masking. Two scales: of both, against facets with Gaussian slopes and Smith's "
               "masking on top of their own.\n\n",
               alpha);
    const Ways ways = {"kernel", "kernel, base not masking", "noise"};
    print_head(
        with(with({"slope", "angle"}, ways), {"two scales: kernel", "kernel, base not masking"}));
    for (const double slope : {0.1, 0.3, 0.6}) {
        Surfaces of_slope;
        std::copy_if(all.begin(), all.end(), std::back_inserter(of_slope),
                     [slope](const auto& surface) { return surface.slope == slope; });
        const ScoresOfAngles kernel = kernel_on_two_scales(slope, alpha, views, true);
        const ScoresOfAngles bare = kernel_on_two_scales(slope, alpha, views, false);
        for (const size_t angle : kNodeAngles) {
            Cells cells = {fmt::format("{:g}", slope),
                           fmt::format("{:g}", views.angles_deg[angle])};
            for (const std::string& way : ways)
                cells.push_back(
                    pooled(of_slope, way, {"", kSizeMap, kSpecular[base], {angle}}).text());
            cells.push_back(percent(rms(kernel, {angle})));
            cells.push_back(percent(rms(bare, {angle})));
            print_row(cells);
        }
    }
}

void print_plane(const SlopeViews& views)
{
    fmt::print("\nWhat a white rough plane reflects of the light, %: with its roughness in the "
               "masking / without.\n\n");
    Cells head = {"base roughness"};
    for (const size_t angle : kNodeAngles)
        head.push_back(fmt::format("{:g}", views.angles_deg[angle]));
    print_head(head);
    for (const double alpha : kBaseAlphas) {
        Cells cells = {fmt::format("{:g}", alpha)};
        for (const size_t angle : kNodeAngles)
            cells.push_back(percent(plane_albedo(views.angles_deg[angle], alpha, true)) + " / " +
                            percent(plane_albedo(views.angles_deg[angle], alpha, false)));
        print_row(cells);
    }
}

} // namespace

void print_slope_figures(const Surfaces& all, const SlopeViews& views)
{
    fmt::print("Rms / largest over {} surfaces and slopes; all nodes where no angle is named.\n",
               all.size());
    print_slopes_and_shading(all, views);
    print_worse(all, views);
    print_payment(all, "at the nodes", kNodeAngles);
    print_payment(all, "between the nodes", kAnglesBetween);
    for (size_t base = 0; base < kBaseAlphas.size(); ++base)
        print_base(all, views, base);
    print_plane(views);
    print_surfaces(all);
}

} // namespace scree::test
