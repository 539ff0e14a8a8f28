#include "pipeline/level_report.h"

namespace scree {

LevelReport::LevelReport(const MomentLayout& layout, int width, int height, double h1)
    : statistics_(layout, width, height, h1)
{
    if (layout.color_var >= 0)
        color_fit_.emplace(layout, width, height);
}

std::vector<TexelVisitor*> LevelReport::visitors()
{
    std::vector<TexelVisitor*> visitors = {&statistics_};
    if (color_fit_)
        visitors.push_back(&*color_fit_);
    return visitors;
}

std::vector<LevelSummary> LevelReport::summaries() const
{
    std::vector<LevelSummary> levels = statistics_.summaries();
    if (color_fit_) {
        const auto fits = color_fit_->fits();
        for (size_t l = 0; l < levels.size(); ++l)
            levels[l].color_fit = fits[l];
    }
    return levels;
}

} // namespace scree
