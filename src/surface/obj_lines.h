#pragma once

#include <string>
#include <string_view>

namespace scree {

/// What lines of an OBJ file hold that the library passes over: it reads a number it does not
/// understand (and NaN) as 0, a missing one too, and drops faces of fewer than 3 corners.
///
/// text  of the whole file; v, vt, f and t lines are looked at
/// file  its name for messages
/// returns how many lines set a subdivision tag ("t ...")
/// throws Error with the line: a vertex without three finite numbers, a texture coordinate without
///        two, a face of fewer than 3 or more than 255 corners, a tag with other values than it
///        says, bytes that no text has
int check_obj_lines(std::string_view text, const std::string& file);

} // namespace scree
