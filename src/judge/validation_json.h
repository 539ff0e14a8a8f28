#pragma once

#include <string>

#include "judge/validation.h"

namespace scree {

/// Everything a validation found, as JSON text; errors and noises as in ViewErrors.
std::string to_json(const Validation& validation, const ValidationPlan& plan,
                    const Manifest& manifest);

} // namespace scree
