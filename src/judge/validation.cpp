#include "judge/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "judge/asset_flags.h"
#include "judge/ray_reach.h"

namespace scree {

namespace {

/// Views that are drawn, degrees from the normal, and the longer side of the pictures, texels.
constexpr std::array<double, 2> kDrawnAngles{60, 80};
constexpr int kPictureSide = 64;

bool has(const Manifest& manifest, Map map)
{
    return std::any_of(manifest.textures.begin(), manifest.textures.end(),
                       [map](const TextureRecord& texture) { return texture.map == map; });
}

/// What is left of an error without the reference's own noise; a NaN stays one.
template <class Error>
double own_error(const Error& error)
{
    const double square = error.set * error.set - error.noise * error.noise;
    return square < 0 ? 0 : std::sqrt(square);
}

void judge(const ViewCheck& check, const char* name, ViewError ViewErrors::*figure,
           const std::optional<double>& tolerance, std::vector<std::string>& exceeded)
{
    if (!tolerance)
        return;
    for (const ViewErrors& errors : check.all) {
        const double error = own_error(errors.*figure);
        if (errors.angle_deg >= 0 && !(error <= *tolerance && check.samples > 0)) // or a NaN
            exceeded.push_back(fmt::format("{} at {:g} degrees: rms error {:.4f}, tolerance {:g}",
                                           name, errors.angle_deg, error, *tolerance));
    }
}

void judge(const ViewCheck& check, const Tolerances& tolerances, std::vector<std::string>& exceeded)
{
    judge(check, "visible color", &ViewErrors::color, tolerances.color, exceeded);
    judge(check, "radiance", &ViewErrors::radiance, tolerances.radiance, exceeded);
    judge(check, "masking", &ViewErrors::masking, tolerances.masking, exceeded);
    judge(check, "visible slope", &ViewErrors::slope, tolerances.slope, exceeded);
    judge(check, "covariance of the visible slopes", &ViewErrors::covariance, tolerances.covariance,
          exceeded);
}

void judge(const NodeCheck& check, const std::optional<double>& tolerance,
           std::vector<std::string>& exceeded)
{
    if (!tolerance)
        return;
    for (const NodeErrors& errors : check.all)
        for (const auto& [name, error] : {std::pair("area", own_error(errors.area)),
                                          std::pair("color", own_error(errors.color))})
            if (!(error <= *tolerance && errors.footprints > 0)) // or a NaN
                exceeded.push_back(
                    fmt::format("{} of the tables of visibility at {:g} degrees: rms error {:.4f}, "
                                "tolerance {:g}",
                                name, errors.angle_deg, error, *tolerance));
}

void judge(const std::vector<StatisticsFigure>& figures, double scale,
           std::vector<std::string>& exceeded)
{
    for (const StatisticsFigure& figure : figures)
        if (!(figure.largest <= figure.tolerance * scale))
            exceeded.push_back(fmt::format(
                "{} of level {}: error {:.2e} at texel ({}, {}), tolerance {:.2e}", figure.name,
                figure.level, figure.largest, figure.x, figure.y, figure.tolerance * scale));
}

std::function<void(double)> told(const BakeMonitor& monitor, const char* phase)
{
    return [&monitor, phase](double done) { monitor.report(phase, done); };
}

/// Where a plain MIP chain is nearer to the truth than the set, which nobody would expect: how
/// often, and the worst. Beyond noise, and beyond a hundredth that nobody sees.
///
/// cause  in words
void flag_worse_than_plain(const ViewCheck& check, const char* name, ViewError ViewErrors::*figure,
                           const char* cause, std::vector<std::string>& flags)
{
    constexpr double kSeen = 0.01;
    int compared = 0, worse = 0;
    const ViewErrors* worst = nullptr;
    auto excess = [figure](const ViewErrors& errors) {
        const ViewError& error = errors.*figure;
        return error.set - error.plain - error.noise - kSeen;
    };
    for (const ViewErrors& errors : check.levels) {
        compared += errors.footprints > 0 ? 1 : 0;
        if (!(excess(errors) > 0))
            continue;
        ++worse;
        if (worst == nullptr || excess(errors) > excess(*worst))
            worst = &errors;
    }
    if (worst != nullptr)
        flags.push_back(fmt::format(
            "{}: a plain MIP chain is nearer to the reference than the set at {} of {} levels and "
            "angles, most at level {} from {:g} degrees: error {:.2f}, plain {:.2f}; {}",
            name, worse, compared, worst->level, worst->angle_deg, (worst->*figure).set,
            (worst->*figure).plain, cause));
}

/// What was found until then, if views cannot be compared.
Validation without_views(const std::string& why, const ValidationPlan& plan, Validation found)
{
    found.without_views = why;
    if (has_tolerance_of_views(plan.tolerances))
        found.exceeded.push_back("what views see, which has a tolerance, was not compared: " + why);
    return found;
}

} // namespace

bool has_tolerance_of_views(const Tolerances& tolerances)
{
    return tolerances.color || tolerances.radiance || tolerances.masking || tolerances.slope ||
           tolerances.covariance || tolerances.tables;
}

Validation validate(SetReader& set, Original original, const BakeOptions& options,
                    const ValidationPlan& plan, const BakeMonitor& monitor)
{
    const Manifest& manifest = set.manifest();
    Validation found;
    found.statistics =
        check_statistics(set, original, options, told(monitor, "compare the statistics"));
    judge(found.statistics, plan.tolerances.statistics, found.exceeded);
    found.flags = asset_flags(original, options.reconstruction);
    if (original.relief.heights.empty())
        return without_views("a normal map has no heights to cast rays at", plan, std::move(found));
    if (!has(manifest, Map::slope) && !has(manifest, Map::bumpslopes))
        return without_views("the set has no slopes to tell what a view sees", plan,
                             std::move(found));
    if (!plan.views)
        return without_views("only the statistics were asked for", plan, std::move(found));
    if (!has(manifest, Map::color))
        original.relief.colors.clear(); // the set shows white, so must the reference
    const reference::DisplacedSurface surface(std::move(original.relief));
    const std::string too_high = too_high_for_rays(surface);
    if (!too_high.empty())
        return without_views(too_high, plan, std::move(found));
    found.views = check_views(set, surface, plan.view, told(monitor, "compare what views see"));
    judge(*found.views, plan.tolerances, found.exceeded);
    if (has_tables(set)) {
        found.tables =
            check_nodes(set, surface, plan.view, told(monitor, "compare tables of visibility"));
        judge(*found.tables, plan.tolerances.tables, found.exceeded);
    } else if (plan.tolerances.tables) {
        found.exceeded.push_back("tables of visibility, which have a tolerance, are not in the "
                                 "set");
    }
    const char* smith = "Smith's masking does not fit this asset there";
    flag_worse_than_plain(*found.views, "radiance", &ViewErrors::radiance, smith, found.flags);
    flag_worse_than_plain(*found.views, "visible color", &ViewErrors::color,
                          has_tables(set) ? "its tables of visibility have too few nodes or "
                                            "harmonics for what is seen there"
                                          : smith,
                          found.flags);
    if (plan.images)
        for (const double angle : kDrawnAngles)
            found.images.push_back(draw_texels(set, surface, level_to_draw(manifest, kPictureSide),
                                               direction(angle, 0), lights_of(plan.view).front(),
                                               plan.view.material, plan.view.grid / 2,
                                               told(monitor, "draw")));
    return found;
}

} // namespace scree
