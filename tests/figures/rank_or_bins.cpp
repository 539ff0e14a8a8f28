// Decides by measurement how color by height is best stored: as a table over height ranks or as
// bins of height, at equal numbers of channels and after trilinear filtering.
//
//   scree_rank_or_bins DATA_FOLDER > tables.md
//
// Truth is the visible color of what the filter sees: the level-0 texels under its eight taps, with
// the taps' weights, sorted by height. Files are read as a bake reads them and footprints halve as
// its MIP levels do; of what a bake computes from them, no line is used.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "figures/height_color_errors.h"
#include "math/error.h"

namespace scree::test {
namespace {

/// All that was measured of one surface.
struct Result {
    std::string surface;
    SurfaceErrors errors;

    Errors pooled(Filter filter) const
    {
        Errors all;
        for (const Errors& level : errors[filter])
            all.add(level);
        return all;
    }
};

/// A number of one model on one surface.
using Figure = std::function<double(const Errors&, size_t model)>;

/// The part of the effect that a model leaves unexplained.
double luminance_share(const Errors& errors, size_t model)
{
    return errors.models[model].luminance_rms() / errors.effect.luminance_rms();
}
double worst_share(const Errors& errors, size_t model)
{
    return errors.models[model].worst_rms() / errors.effect.worst_rms();
}
double luminance_rms(const Errors& errors, size_t model)
{
    return errors.models[model].luminance_rms();
}
double worst_rms(const Errors& errors, size_t model) { return errors.models[model].worst_rms(); }

struct Spread {
    double median, worst;
};

/// Of one figure over the surfaces.
Spread spread(const std::vector<Result>& results,
              const std::function<double(const Result&)>& figure)
{
    std::vector<double> all(results.size());
    std::transform(results.begin(), results.end(), all.begin(), figure);
    std::sort(all.begin(), all.end());
    return {0.5 * (all[(all.size() - 1) / 2] + all[all.size() / 2]), all.back()};
}

void print_pooled(const std::vector<Result>& results, const std::vector<Model>& models)
{
    struct Column {
        const char* title;
        Filter filter;
        Figure figure;
        int digits;
    };
    const std::vector<Column> columns = {
        {"luminance, trilinear", kTrilinear, luminance_share, 3},
        {"trilinear of halves", kHalf, luminance_share, 3},
        {"unfiltered", kUnfiltered, luminance_share, 3},
        {"worst channel, trilinear", kTrilinear, worst_share, 3},
        {"unfiltered", kUnfiltered, worst_share, 3},
        {"absolute luminance", kTrilinear, luminance_rms, 4},
        {"worst channel", kTrilinear, worst_rms, 4},
    };
    std::printf("Share of the effect left unexplained: RMS error over RMS of truth - mean color, "
                "all levels and L; median / worst of %zu surfaces. Absolute: RMS, likewise.\n\n"
                "| method | channels |",
                results.size());
    for (const Column& column : columns)
        std::printf(" %s |", column.title);
    std::printf("\n|---|---|");
    for (size_t i = 0; i < columns.size(); ++i)
        std::printf("---|");
    for (size_t m = 0; m < models.size(); ++m) {
        std::printf("\n| %s | %zu |", models[m].name.c_str(), models[m].channels);
        for (const Column& column : columns) {
            const Spread s = spread(results, [&](const Result& result) {
                return column.figure(result.pooled(column.filter), m);
            });
            std::printf(" %.*f / %.*f |", column.digits, s.median, column.digits, s.worst);
        }
    }
    std::printf("\n");
}

void print_levels(const std::vector<Result>& results, const std::vector<Model>& models)
{
    const std::vector<std::string> shown = {"linear",
                                            "rank, 1",
                                            "rank, 2",
                                            "rank, 4",
                                            "rank, 8",
                                            "bins of equal mass, 4",
                                            "bins of equal mass, 7"};
    std::printf("\nMedian share of luminance, trilinear.\n\n| method | channels |");
    for (size_t l = 0; l < kLevels; ++l)
        std::printf(" level %zu |", l + 1);
    std::printf("\n|---|---|");
    for (size_t l = 0; l < kLevels; ++l)
        std::printf("---|");
    for (size_t m = 0; m < models.size(); ++m) {
        if (std::find(shown.begin(), shown.end(), models[m].name) == shown.end())
            continue;
        std::printf("\n| %s | %zu |", models[m].name.c_str(), models[m].channels);
        for (size_t l = 0; l < kLevels; ++l) {
            const Spread s = spread(results, [&](const Result& result) {
                return luminance_share(result.errors[kTrilinear][l], m);
            });
            std::printf(" %.3f |", s.median);
        }
    }
    std::printf("\n");
}

/// One row a surface, one column a model of so many channels.
void print_surfaces(const std::vector<Result>& results, const std::vector<Model>& models,
                    size_t channels)
{
    std::printf("\nShare of luminance: trilinear / of halves / unfiltered.\n\n"
                "| surface | RMS of the effect |");
    std::string rule = "\n|---|---|";
    for (const Model& model : models)
        if (model.channels == channels) {
            std::printf(" %s (%zu) |", model.name.c_str(), model.channels);
            rule += "---|";
        }
    std::printf("%s\n", rule.c_str());
    for (const Result& result : results) {
        const Errors trilinear = result.pooled(kTrilinear), half = result.pooled(kHalf),
                     unfiltered = result.pooled(kUnfiltered);
        std::printf("| %s | %.4f |", result.surface.c_str(), trilinear.effect.luminance_rms());
        for (size_t m = 0; m < models.size(); ++m)
            if (models[m].channels == channels)
                std::printf(" %.3f / %.3f / %.3f |", luminance_share(trilinear, m),
                            luminance_share(half, m), luminance_share(unfiltered, m));
        std::printf("\n");
    }
}

void run(const std::string& data)
{
    std::vector<Result> results;
    std::vector<Model> models; // the last surface's: the same names and channels for all
    for (const Surface& surface : height_color_surfaces(data)) {
        models = height_color_models(surface.heights);
        results.push_back({surface.name, measure(surface, models)});
    }
    print_pooled(results, models);
    print_levels(results, models);
    print_surfaces(results, models, 12);
    print_surfaces(results, models, 24);
}

} // namespace
} // namespace scree::test

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s DATA_FOLDER\n", argv[0]);
        return 2;
    }
    try {
        scree::test::run(argv[1]);
    } catch (const scree::Error& error) {
        std::fprintf(stderr, "%s: error: %s\n", argv[0], error.what());
        return 1;
    }
    return 0;
}
