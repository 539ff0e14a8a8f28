#pragma once

#include <string>

#include "judge/validation.h"

namespace scree {

/// The validation as one self-contained HTML page: verdict, tables, charts, pictures.
std::string to_page(const Validation& validation, const ValidationPlan& plan,
                    const Manifest& manifest);

} // namespace scree
