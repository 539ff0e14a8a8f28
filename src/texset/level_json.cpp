#include "texset/level_json.h"

namespace scree {

namespace {

ExponentFit exponent_from_json(const JsonObject& json)
{
    ExponentFit fit;
    json.get("gain", fit.gain);
    json.get("power", fit.power);
    json.get("threshold", fit.threshold);
    return fit;
}

LevelError level_error_from_json(const JsonObject& json)
{
    LevelError error;
    json.get("model", error.model);
    json.get("error", error.error);
    return error;
}

ColorFit fit_from_json(const JsonObject& json)
{
    ColorFit fit;
    json.get("sigma", fit.sigma);
    json.get_if_there("height_correlation", fit.height_correlation);
    json.get_if_there("slope_correlation", fit.slope_correlation);
    json.get_if_there("r2_height", fit.height);
    json.get_if_there("r2_slope", fit.slope);
    json.get_if_there("r2_rank1", fit.rank1);
    json.get_if_there("r2_rank2", fit.rank2);
    json.get_if_there("r2_rank4", fit.rank4);
    json.get("residual", fit.residual);
    return fit;
}

} // namespace

LevelSummary level_from_json(const JsonObject& json)
{
    LevelSummary level;
    json.get("width", level.width);
    json.get("height", level.height);
    json.get("coverage", level.coverage);
    json.get_if_there("mean_slope", level.mean_slope);
    json.get_if_there("steepest", level.steepest);
    json.get_if_there("rms_slope", level.rms_slope);
    json.get_if_there("slope_sigma", level.slope_sigma);
    json.get_if_there("kurtosis", level.kurtosis);
    json.get_if_there("tau", level.tau);
    json.get_if_there("height_sigma", level.height_sigma);
    json.get_if_there("mean_color", level.mean_color);
    if (json.has("color_fit"))
        level.color_fit = fit_from_json(json.object("color_fit"));
    if (json.has("exponent"))
        level.exponent = exponent_from_json(json.object("exponent"));
    if (json.has("model_errors"))
        for (const JsonObject& error : json.objects("model_errors"))
            level.model_errors.push_back(level_error_from_json(error));
    return level;
}

} // namespace scree
