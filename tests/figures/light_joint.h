#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "figures/light_truth.h"
#include "figures/light_ways.h"

namespace scree::test {

/// What has numbers of its own in a joint table.
enum class NumbersOf {
    channel, ///< every channel of every texel
    texel,   ///< every texel
    level,   ///< all texels of a level share them
};

/// A small table of view and light together, an experiment: numbers that multiply functions of the
/// two directions, added to the color of another way.
struct JointForm {
    std::string name;
    LightWay base;
    NumbersOf of = NumbersOf::channel;
    /// Values of the functions for R, G and B.
    std::function<std::array<std::vector<double>, 3>(const PairColors& pair)> functions;
    size_t count = 0;            ///< of functions
    bool of_light_alone = false; ///< as of LightWay

    [[nodiscard]] size_t numbers() const; ///< a texel, with those of the other way
};

/// With x = sqrt(tan theta), hat functions of x, 0 at theta = 0, that stay from the last node on,
/// and d the difference of the azimuths:
///
///   on tables, of all harmonics and of none, as the kernel has them: 1 node, 1 and cos d:
///     x_o x_i (p + q cos d); 2 x 2 nodes, symmetric in view and light, 1 and cos d;
///   on tables of all harmonics: how much the overlap of the shifts counts, p + q wo_h . wi_h more
///     than the kernel has it, by texel and by level;
///   on the mean color alone: 2 x 2 nodes as above, and the 2 of one direction straight above.
///
/// Nodes lie at 68 and 85 degrees, the only one at 85.
std::vector<JointForm> joint_forms(const std::vector<LightSource>& sources);

/// Of R, G and B, the numbers of the functions.
using JointNumbers = std::array<std::vector<double>, 3>;

/// What the texels of a level have to hold to come, of all their kind, closest to the truth: least
/// squares, by the light that is sent, all texels and all angles of views and lights alike.
///
/// colors   of each texel, by the source of form.base
/// returns  one a texel
std::vector<JointNumbers> fitted_numbers(const JointForm& form, const std::vector<SetTexel>& texels,
                                         const std::vector<DirectionColors>& colors,
                                         const std::vector<LitFootprint>& truth,
                                         const LightPairs& pairs);

/// The color by a joint table, not below 0.
Rgbf joint_color(const JointForm& form, const JointNumbers& numbers, const PairColors& pair);

} // namespace scree::test
