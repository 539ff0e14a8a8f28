#pragma once

#include <string>

#include "surface/subdivision.h"

namespace scree {

/// Options of a mesh by the words of the command line. Throws Error naming the choices.
Scheme scheme_named(const std::string& name);
std::string scheme_name(Scheme scheme);
BoundaryRule boundary_named(const std::string& name);
std::string boundary_name(BoundaryRule rule);
UvRule uv_interpolation_named(const std::string& name);
std::string uv_interpolation_name(UvRule rule);

} // namespace scree
