#include "figures/set_level.h"

#include <algorithm>

#include "math/error.h"
#include "texset/mip_reader.h"

namespace scree::test {
namespace {

int texel_of(double place, int count)
{
    return std::clamp(static_cast<int>(place * count), 0, count - 1);
}

} // namespace

SetLevel::SetLevel(const std::filesystem::path& file, int level) : name_(file.string())
{
    MipReader reader(file);
    if (level >= reader.levels())
        throw Error(name_ + ": no level " + std::to_string(level));
    width_ = reader.width(level);
    height_ = reader.height(level);
    channels_ = reader.channels();
    values_ = reader.rows(level, 0, height_);
}

size_t SetLevel::channel(const std::string& name) const
{
    const auto found = std::find(channels_.begin(), channels_.end(), name);
    if (found == channels_.end())
        throw Error(name_ + ": no channel " + name);
    return static_cast<size_t>(found - channels_.begin());
}

double SetLevel::at(int x, int y, size_t channel) const
{
    const size_t texel =
        static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
    return static_cast<double>(values_[texel * channels_.size() + channel]);
}

double SetLevel::at(const Vec2& place, size_t channel) const
{
    return at(texel_of(place.x, width_), texel_of(place.y, height_), channel);
}

double slope_variance(const SetLevel& slope, const Vec2& place)
{
    const auto of = [&](const char* name) { return slope.at(place, slope.channel(name)); };
    const double s = of("s"), t = of("t");
    return of("ss") - s * s + of("tt") - t * t;
}

} // namespace scree::test
