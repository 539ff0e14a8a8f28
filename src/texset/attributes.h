#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scree {

/// Header attributes of a texture file, in the order they are written.
using AttributeValue = std::variant<std::string, int, float, double>;
using Attributes = std::vector<std::pair<std::string, AttributeValue>>;

} // namespace scree
