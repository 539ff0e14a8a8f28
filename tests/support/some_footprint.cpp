#include "support/some_footprint.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace scree::test {

const Method& method_named(const std::string& name)
{
    const auto found = std::find_if(methods().begin(), methods().end(),
                                    [&name](const Method& method) { return method.name == name; });
    if (found == methods().end())
        throw std::runtime_error("no method " + name);
    return *found;
}

Vec3 toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

MapTable straight_table(const Rgb& low, const Rgb& high)
{
    MapTable table;
    table.columns = 2;
    table.rows = 1;
    table.low = -10;
    table.high = 10;
    table.colors = {low, high};
    return table;
}

FootprintData some_footprint(unsigned seed)
{
    std::mt19937 random(seed);
    const auto uniform = [&random](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24F;
    };
    const auto slopes = [&uniform] {
        const float s = uniform(-0.3F, 0.3F), t = uniform(-0.3F, 0.3F);
        const float css = uniform(0.05F, 0.3F), ctt = uniform(0.05F, 0.3F);
        const float cst = uniform(-0.5F, 0.5F) * std::sqrt(css * ctt);
        return filter::SlopeMoments<float>{s, css + s * s, cst + s * t, t, ctt + t * t};
    };
    FootprintData data;
    data.set.slope = slopes();
    data.sobel = slopes();
    data.set.tau = uniform(0.2F, 0.8F);
    data.set.h = uniform(-1, 1);
    data.set.hh = data.set.h * data.set.h + uniform(0.1F, 0.5F);
    for (size_t c = 0; c < 3; ++c) {
        data.set.color[c] = uniform(0.4F, 0.8F);
        data.set.color_height[c] = data.set.color[c] * data.set.h + uniform(0.01F, 0.05F);
        data.set.color_s[c] = data.set.color[c] * data.set.slope.s + uniform(0.01F, 0.02F);
        data.set.color_t[c] = data.set.color[c] * data.set.slope.t + uniform(0.01F, 0.02F);
        for (auto& a : data.set.rank)
            a[c] = uniform(0.01F, 0.03F);
    }
    data.set.exponent = {uniform(0.5F, 2), uniform(0.5F, 2), uniform(0.01F, 0.02F)};
    const auto fill = [&uniform](auto begin, auto end) {
        for (auto value = begin; value != end; ++value)
            *value = uniform(-0.05F, 0.05F);
    };
    fill(data.set.visible.begin(), data.set.visible.begin() + 80);
    fill(data.visible_2x1.begin(), data.visible_2x1.end());
    fill(data.visible_4x1.begin(), data.visible_4x1.end());
    fill(data.visible_4x3.begin(), data.visible_4x3.end());
    fill(data.visible_axes.begin(), data.visible_axes.end());
    data.normal = {uniform(-0.2F, 0.2F), uniform(-0.2F, 0.2F), uniform(0.7F, 0.9F)};
    return data;
}

VisibilityNodes some_nodes()
{
    const auto cosine = [](double angle_rad) { return static_cast<float>(std::cos(angle_rad)); };
    return {{cosine(0.7), cosine(1.2), cosine(1.4), cosine(1.5)},
            {cosine(1), cosine(1.45)},
            {cosine(0.8), cosine(1.1), cosine(1.35), cosine(1.48)},
            cosine(0.3),
            static_cast<float>(std::sin(0.3))};
}

} // namespace scree::test
