#pragma once

#include <Imath/ImathVec.h>

namespace scree {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;

} // namespace scree
