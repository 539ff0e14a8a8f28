#pragma once

#include "texset/json_object.h"
#include "texset/manifest.h"

namespace scree {

/// Reads what a manifest says of a level. Throws Error as JsonObject does.
LevelSummary level_from_json(const JsonObject& json);

} // namespace scree
