#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "figures/light_colors.h"

namespace scree::test {

/// A way to tell the color of what is both seen and lit.
struct LightWay {
    std::string name;
    /// A texel, that it reads beside mean color, slope and tail; absent: nothing a set could hold.
    std::optional<size_t> numbers;
    size_t source = 0; ///< of light_sources(): where PairColors::seen and lit are from
    std::function<Rgbf(const PairColors& pair)> color;
    bool of_light_alone = true; ///< seen from straight above not the same as a way before it
};

/// The mean color; color linear in height by the sum of the view's and the light's exponent,
/// Smith's and as it was fitted; the color seen and lit as the kernel makes it of the colors of
/// view and light from every source; and what else can be made of them, from tables of most
/// harmonics and from the reference's own colors.
std::vector<LightWay> light_ways(const std::vector<LightSource>& sources);

/// The kernel's way to put the colors of a source together.
LightWay shifts_less_overlap(const std::vector<LightSource>& sources, size_t source);

/// What both shifts from the mean color have in common: the smaller one where they agree in sign.
Rgbf overlap(const PairColors& pair);

} // namespace scree::test
