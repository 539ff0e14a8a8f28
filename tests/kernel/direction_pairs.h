#pragma once

#include <string>
#include <vector>

#include "kernel/brdf_coordinates.h"

namespace scree::test {

struct DirectionPair {
    std::string name;
    filter::Directions<double> w; ///< unit to rounding
};

/// Pairs over the whole hemisphere pair: a grid to the horizon, random ones, and those where
/// coordinates have their singularities, exactly and 1e-3 to 1e-15 beside them.
std::vector<DirectionPair> direction_pairs();

} // namespace scree::test
