// The functions of linear lights once, for one case, in the kernel's own common subset of C++, GLSL
// and OSL: include after scree_linear_light.h. kernel/linear_cases.h names the numbers.

SCREE_FUNCTION void linear_outputs(Real fx, Real fy, Real fz, Real tx, Real ty, Real tz, Real sx,
                                   Real sy, Real sz, Real nx, Real ny, Real nz, Real vx, Real vy,
                                   Real vz, Real css, Real ctt, Real base_alpha, OUT(Real, width),
                                   OUT(Real, distance), OUT(Real, cos_v), OUT(Real, normal_u),
                                   OUT(Real, normal_e), OUT(Real, normal_w),
                                   OUT(Real, first_cosine), OUT(Real, first_sine),
                                   OUT(Real, phi_cosine), OUT(Real, phi_sine), OUT(Real, k),
                                   OUT(Real, cos2), OUT(Real, sigma2), OUT(Real, gaussian),
                                   OUT(Real, eight), OUT(Real, twelve), OUT(Real, at_view),
                                   OUT(Real, at_normal), OUT(Real, at_ratio), OUT(Real, at_side))
{
    Real ux, uy, uz, ex, ey, ez, wx, wy, wz, first, last;
    scree_linear_frame(fx, fy, fz, tx, ty, tz, nx, ny, nz, vx, vy, vz, ux, uy, uz, ex, ey, ez, wx,
                       wy, wz, first, last, distance);
    width = last - first;
    scree_sine_cosine(first, first_sine, first_cosine);
    Real sin_v = vx * ux + vy * uy + vz * uz;
    cos_v = max(vx * wx + vy * wy + vz * wz, LIT(0.0));
    normal_u = nx * ux + ny * uy + nz * uz;
    normal_e = nx * ex + ny * ey + nz * ez;
    normal_w = nx * wx + ny * wy + nz * wz;
    Real su = sx * ux + sy * uy + sz * uz;
    Real se = sx * ex + sy * ey + sz * ez;

    Real phi = LIT(0.0);
    Real tan2 = LIT(0.0);
    scree_linear_peak(sin_v, cos_v, normal_u, normal_e, normal_w, 4, phi, k, tan2);
    scree_sine_cosine(phi, phi_sine, phi_cosine);
    cos2 = LIT(1.0) / (LIT(1.0) + tan2);
    k = k * sqrt(cos2); // without bound where the half vector is across the normal

    sigma2 = scree_ward_sigma2(css, ctt, base_alpha);
    Real speed = k / sqrt(cos2);
    gaussian = scree_linear_reflection(sin_v, cos_v, normal_u, normal_e, normal_w, su, se, first,
                                       last, distance, phi, speed, tan2, sigma2);
    eight = scree_linear_quadrature(sin_v, cos_v, normal_u, normal_e, normal_w, su, se, first, last,
                                    distance, phi, speed, tan2, sigma2, LIT(2.0));
    twelve = scree_linear_quadrature(sin_v, cos_v, normal_u, normal_e, normal_w, su, se, first,
                                     last, distance, phi, speed, tan2, sigma2, LIT(3.0));

    Real at_azimuth = LIT(0.0);
    scree_linear_angle_coordinates(cos_v, normal_u, normal_e, normal_w, LIT(32.0), LIT(128.0),
                                   LIT(64.0), at_view, at_normal, at_azimuth);
    Real ch, sh, na, nb, radius;
    scree_linear_cone(sin_v, cos_v, normal_u, normal_e, normal_w, ch, sh, na, nb, radius);
    Real again = LIT(0.0);
    scree_linear_cone_coordinates(cos_v, na, nb, radius, LIT(32.0), LIT(64.0), LIT(32.0), again,
                                  at_ratio, at_side);
}
