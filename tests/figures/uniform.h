#pragma once

#include <random>

namespace scree::test {

/// In [0, 1); the same on every machine, which the library's distributions are not.
inline double uniform(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

} // namespace scree::test
