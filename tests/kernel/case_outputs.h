// Every function of the kernel once, for one row of the table of cases. In the kernel's own common
// subset of C++, GLSL and OSL, so that all three run the same calls: include after scree_filter.h.
// kernel/cases.h names the numbers.

SCREE_FUNCTION void case_outputs(
    Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz, Real s, Real t, Real ss, Real st,
    Real tt, Real tau, Real base_alpha, Real h, Real hh, Real c, Real ch, Real cs, Real ct, Real a1,
    Real a2, Real a3, Real a4, Real a5, Real a6, Real a7, Real a8, Real raw_s, Real raw_t,
    Real raw_ss, Real raw_st, Real raw_tt, Real node_near, Real node_far, Real table_c, Real beta,
    Real a, Real lit_c, Real second_ss, Real second_st, Real second_tt, Real gain, Real power,
    Real threshold, OUT(Real, css), OUT(Real, cst), OUT(Real, ctt), OUT(Real, area), OUT(Real, vs),
    OUT(Real, vt), OUT(Real, vss), OUT(Real, vst), OUT(Real, vtt), OUT(Real, lambda), OUT(Real, g1),
    OUT(Real, height_mean), OUT(Real, height_variance), OUT(Real, by_height), OUT(Real, by_rank),
    OUT(Real, by_slope), OUT(Real, map_u), OUT(Real, map_v), OUT(Real, alpha_x), OUT(Real, alpha_y),
    OUT(Real, angle_rad), OUT(Real, specular), OUT(Real, diffuse), OUT(Real, projected),
    OUT(Real, along), OUT(Real, steepness), OUT(Real, steepness_spread), OUT(Real, coordinate),
    OUT(Real, share), OUT(Real, cos1), OUT(Real, cos2), OUT(Real, sin1), OUT(Real, sin2),
    OUT(Real, visible_area), OUT(Real, by_visibility), OUT(Real, overlap), OUT(Real, seen_and_lit),
    OUT(Real, raw_lambda), OUT(Real, measured), OUT(Real, axis_cosine))
{
    scree_covariance(raw_s, raw_t, raw_ss, raw_st, raw_tt, css, cst, ctt);
    scree_visible_slopes(wox, woy, woz, s, t, ss, st, tt, tau, area, vs, vt, vss, vst, vtt);
    projected = scree_projected_area(wox, woy, woz, s, t, ss, st, tt, tau);
    scree_masking(wox, woy, woz, s, t, ss, st, tt, tau, lambda, g1);

    scree_visible_height(lambda, height_mean, height_variance);
    by_height = scree_color_by_height(c, ch, h, hh, height_mean);
    by_rank = scree_color_by_rank(c, a1, a2, a3, a4, a5, a6, a7, a8, lambda);
    Real pull = scree_slope_pull(wox, woy, woz, s, t, ss, st, tt, tau);
    by_slope = scree_color_by_slope(c, cs, ct, s, t, wox, woy, pull);
    Real sigma = scree_height_sigma(h, hh);
    scree_color_map_coordinates(h + sigma * height_mean, sigma * sqrt(height_variance), LIT(-4.0),
                                LIT(4.0), LIT(2.0), LIT(256.0), LIT(32.0), map_u, map_v);
    Real mean = LIT(0.0);
    scree_slope_along(LIT(0.6), LIT(0.8), s, t, ss, st, tt, mean, along);
    scree_slope_magnitude(s, t, ss, tt, steepness, steepness_spread);

    coordinate = scree_node_coordinate(woz);
    share = scree_node_share(woz, node_near, node_far);
    axis_cosine = scree_axis_cosine(wox, woz);
    scree_azimuth_harmonics(wox, woy, cos1, cos2, sin1, sin2);
    visible_area = scree_visible_area(woz, a);
    by_visibility = scree_color_by_visibility(table_c, beta, a);
    overlap = scree_view_light_overlap(wox, woy, wix, wiy);
    seen_and_lit = scree_color_seen_and_lit(table_c, by_visibility, lit_c, overlap);
    raw_lambda = scree_raw_lambda(wox, woy, woz, second_ss, second_st, second_tt, tau);
    measured = scree_measured_exponent(raw_lambda, gain, power, threshold);

    scree_beckmann_roughness(ss, st, tt, base_alpha, alpha_x, alpha_y, angle_rad);
    specular = scree_specular(wox, woy, woz, wix, wiy, wiz, s, t, ss, st, tt, base_alpha);
    diffuse = scree_diffuse(wox, woy, woz, wix, wiy, wiz, s, t, ss, st, tt, tau);
}
