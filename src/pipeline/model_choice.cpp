#include "pipeline/model_choice.h"

#include <algorithm>
#include <string>

namespace scree {

namespace {

constexpr const char* kWithout = "without ";
constexpr const char* kTable = "visible ";

bool has(const std::vector<Map>& maps, Map map)
{
    return std::find(maps.begin(), maps.end(), map) != maps.end();
}

bool is_chosen(const ModelChoice& choice, const std::string& model)
{
    return std::any_of(choice.models.begin(), choice.models.end(), [&model](const auto& record) {
        return record.chosen && record.model == model;
    });
}

/// A table of visibility sees slopes, too: color-slope has nothing to add to it.
bool has_table(const ModelChoice& choice)
{
    return std::any_of(choice.models.begin(), choice.models.end(), [](const auto& record) {
        return record.chosen && record.model.rfind(kTable, 0) == 0;
    });
}

bool mapped_by_slope(const BakeOptions& options)
{
    return !options.colormap_file.empty() && options.map_by != MapBy::height;
}

} // namespace

ModelChoice choose_models(const MeasuredModels& measured, const std::vector<Map>& maps,
                          const BakeOptions& options)
{
    ModelChoice choice{options.max_view_angle_deg, options.model_tolerance, {}};
    if (has(maps, Map::height) && has(maps, Map::color) && !mapped_by_slope(options)) {
        choice.models = measured.models;
        const double tolerance = options.model_tolerance;
        const double best =
            std::min_element(choice.models.begin(), choice.models.end(),
                             [](const auto& a, const auto& b) { return a.error < b.error; })
                ->error;
        const double limit = best <= tolerance ? tolerance : best + tolerance;
        std::find_if(choice.models.begin(), choice.models.end(), [limit](const auto& model) {
            return model.error <= limit;
        })->chosen = true;
    }
    auto judge = [&](Map map, int channels, double error) {
        if (has(maps, map))
            choice.models.push_back({kWithout + map_info(map).name, -channels, error, 0,
                                     error <= options.model_tolerance});
    };
    if (!mapped_by_slope(options) && !has_table(choice))
        judge(Map::colorslope, 6, measured.without_colorslope);
    judge(Map::tail, 1, measured.without_tail);
    return choice;
}

int rank_terms_of(const ModelChoice& choice)
{
    for (const ModelRecord& model : choice.models)
        if (model.chosen && model.rank_terms > 0)
            return model.rank_terms;
    return 0;
}

VisibilityPlan table_of(const ModelChoice& choice, const MeasuredModels& measured)
{
    for (size_t i = 0; i < measured.models.size(); ++i)
        if (is_chosen(choice, measured.models[i].model))
            return measured.tables[i];
    return {};
}

std::vector<Map> maps_of(const ModelChoice& choice, const std::vector<Map>& maps,
                         const BakeOptions& options)
{
    auto is_read = [&](Map map) {
        switch (map) {
        case Map::height:
            return is_chosen(choice, "colorheight") || is_chosen(choice, "exponent") ||
                   is_chosen(choice, "map");
        case Map::colorheight:
            return is_chosen(choice, "colorheight") || is_chosen(choice, "exponent");
        case Map::exponent:
            return is_chosen(choice, "exponent");
        case Map::visible:
            return has_table(choice);
        case Map::rank:
            return rank_terms_of(choice) > 0;
        case Map::map:
            return mapped_by_slope(options) || is_chosen(choice, "map");
        case Map::colorslope:
            return !mapped_by_slope(options) && !has_table(choice) &&
                   !is_chosen(choice, "without colorslope");
        case Map::tail:
            return !is_chosen(choice, "without tail");
        default:
            return true;
        }
    };
    std::vector<Map> read;
    std::copy_if(maps.begin(), maps.end(), std::back_inserter(read), is_read);
    return read;
}

} // namespace scree
