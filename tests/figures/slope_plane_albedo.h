#pragma once

namespace scree::test {

/// Share of the light from an angle that a white rough plane reflects: the integral of its specular
/// term over the upper directions, view and light exchanged (the BRDF is the same).
///
/// masked  with the roughness in the masking, as the kernel has it, or without
double plane_albedo(double angle_deg, double base_alpha, bool masked);

} // namespace scree::test
