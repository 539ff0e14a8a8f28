#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "math/vec.h"

namespace scree::test {

/// One level of one texture of a set.
class SetLevel {
public:
    /// Throws Error when it cannot be read.
    SetLevel(const std::filesystem::path& file, int level);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Values of a texel in the order of `channels`; throws Error where the file lacks one.
    [[nodiscard]] size_t channel(const std::string& name) const;
    [[nodiscard]] double at(int x, int y, size_t channel) const;
    /// Of the texel that (s, t) in [0, 1) lies in.
    [[nodiscard]] double at(const Vec2& place, size_t channel) const;

private:
    std::string name_;
    int width_ = 0, height_ = 0;
    std::vector<std::string> channels_;
    std::vector<float> values_;
};

/// E[(s - E s)^2] + E[(t - E t)^2] inside the texel at a place, from a slope texture.
double slope_variance(const SetLevel& slope, const Vec2& place);

} // namespace scree::test
