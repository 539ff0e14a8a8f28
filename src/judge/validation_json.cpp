#include "judge/validation_json.h"

#include <nlohmann/json.hpp>

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const ViewError& error)
{
    return {{"set", error.set}, {"plain", error.plain}, {"noise", error.noise}};
}

Json json_of(const ViewErrors& errors, const std::vector<std::string>& models)
{
    Json json;
    json["level"] = errors.level < 0 ? Json("all") : Json(errors.level);
    json["angle_deg"] = errors.angle_deg < 0 ? Json("all") : Json(errors.angle_deg);
    json["footprints"] = errors.footprints;
    json["color"] = json_of(errors.color);
    json["radiance"] = json_of(errors.radiance);
    json["masking"] = json_of(errors.masking);
    json["slope"] = json_of(errors.slope);
    json["covariance"] = json_of(errors.covariance);
    for (size_t i = 0; i < errors.models.size(); ++i)
        json["color_by_model"][models[i]] = errors.models[i];
    return json;
}

Json json_of(const ViewCheck& check, const ViewPlan& plan)
{
    Json json;
    json["angles_deg"] = plan.angles_deg;
    json["azimuths"] = plan.azimuths;
    json["lights_deg"] = plan.lights_deg;
    json["footprints_a_level"] = plan.footprints;
    json["samples_a_footprint"] = plan.grid * plan.grid;
    json["seed"] = plan.seed;
    json["base_alpha"] = plan.material.base_alpha;
    json["f0"] = plan.material.f0;
    json["rms_slope"] = check.rms_slope;
    json["samples"] = check.samples;
    json["rays"] = check.rays;
    json["seconds"] = check.seconds;
    for (const ViewErrors& errors : check.all)
        json["all_levels"].push_back(json_of(errors, check.models));
    for (const ViewErrors& errors : check.levels)
        json["levels"].push_back(json_of(errors, check.models));
    return json;
}

Json json_of(const NodeErrors& errors)
{
    const auto part = [](const NodeError& error) {
        return Json{{"set", error.set}, {"noise", error.noise}};
    };
    return {{"level", errors.level < 0 ? Json("all") : Json(errors.level)},
            {"angle_deg", errors.angle_deg},
            {"footprints", errors.footprints},
            {"area", part(errors.area)},
            {"color", part(errors.color)}};
}

Json json_of(const NodeCheck& check)
{
    Json json;
    json["samples"] = check.samples;
    json["rays"] = check.rays;
    json["seconds"] = check.seconds;
    for (const NodeErrors& errors : check.all)
        json["all_levels"].push_back(json_of(errors));
    for (const NodeErrors& errors : check.levels)
        json["levels"].push_back(json_of(errors));
    return json;
}

Json json_of(const StatisticsFigure& figure)
{
    return {{"texture", map_info(figure.map).name},
            {"level", figure.level},
            {"figure", figure.name},
            {"largest_error", figure.largest},
            {"rms_error", figure.rms},
            {"texel", {figure.x, figure.y}},
            {"yardstick", figure.yardstick},
            {"tolerance", figure.tolerance}};
}

} // namespace

std::string to_json(const Validation& validation, const ValidationPlan& plan,
                    const Manifest& manifest)
{
    Json json;
    json["set"] = manifest.name;
    json["valid"] = validation.exceeded.empty();
    json["exceeded"] = validation.exceeded;
    json["flags"] = validation.flags;
    json["statistics"] = Json::array();
    for (const StatisticsFigure& figure : validation.statistics)
        json["statistics"].push_back(json_of(figure));
    if (validation.views)
        json["views"] = json_of(*validation.views, plan.view);
    if (validation.tables)
        json["tables"] = json_of(*validation.tables);
    if (!validation.without_views.empty())
        json["views_not_compared"] = validation.without_views;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n"; // names of files need not be UTF-8
}

} // namespace scree
