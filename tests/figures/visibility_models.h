#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/set_texel.h"
#include "judge/shading.h"
#include "texset/manifest.h"

namespace scree::test {

/// Smith's Lambda of a direction, and the exponent that was fitted in its place.
float smith_exponent(const SetTexel& texel, const Vec3f& w);
float measured_exponent(const SetTexel& texel, const Vec3f& w);

/// Linear in height.
///
/// exponent  of a direction, or the sum of the view's and the light's
Rgbf color_by_height(const SetTexel& texel, float exponent);

/// A way to tell the color that a view sees of a texel, by the kernel.
struct ColorOfView {
    std::string name;
    std::function<Rgbf(const SetTexel& texel, const Vec3f& w)> color;
};

/// The mean color, Smith's exponent (linear in height; rank table of 4 terms), the exponent that
/// was fitted, and the tables of visibility with as many harmonics as there are, and fewer.
///
/// record  how the texels' tables are laid out, by harmonics
std::vector<ColorOfView> colors_of_views(const VisibilityRecord& record);

/// The table of visibility read with `harmonics` of those it has.
ColorOfView table_color(const VisibilityRecord& record, int harmonics);

/// A table along axes.
ColorOfView axes_color(const VisibilityRecord& record);

/// As table_color(), all harmonics, between its nodes linear in another coordinate than the
/// kernel's.
///
/// coordinate  of the cosine of the angle from the normal, in (0, 1]; strictly falling
ColorOfView table_color_along(const VisibilityRecord& record, const std::string& name,
                              const std::function<double(double cosine)>& coordinate);

} // namespace scree::test
