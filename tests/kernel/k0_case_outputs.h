// Every function of scree_k0.h that renderers call, once, for one row of a table of cases; in the
// common subset of C++, GLSL and OSL: include after scree_k0.h. kernel/k0_cases.h names the
// numbers.

SCREE_FUNCTION void k0_case_outputs(Real wx, Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                                    Real ctt, Real tau, Real s, Real t, Real rho, Real u1, Real u2,
                                    Real u3, Real u4, Real u5, OUT(Real, pdf), OUT(Real, mixture),
                                    OUT(Real, ndf), OUT(Real, visible_pdf), OUT(Real, projected),
                                    OUT(Real, lambda), OUT(Real, g1), OUT(Real, profile),
                                    OUT(Real, any_s), OUT(Real, any_t), OUT(Real, facing_s),
                                    OUT(Real, facing_t))
{
    pdf = scree_k0_slope_pdf(s, t, ms, mt, css, cst, ctt, rho);
    mixture = scree_mixture_slope_pdf(s, t, ms, mt, css, cst, ctt, tau, rho);
    ndf = scree_k0_ndf(wx, wy, wz, ms, mt, css, cst, ctt, rho);
    visible_pdf = scree_k0_visible_pdf(s, t, wx, wy, wz, ms, mt, css, cst, ctt, rho);
    projected = scree_k0_area(wx, wy, wz, ms, mt, css, cst, ctt);
    scree_k0_masking(wx, wy, wz, ms, mt, css, cst, ctt, lambda, g1);
    profile = scree_k0_profile(u1, rho);
    scree_k0_sample(u1, u2, u3, ms, mt, css, cst, ctt, any_s, any_t);
    scree_k0_sample_visible(u1, u2, u3, u4, u5, wx, wy, wz, ms, mt, css, cst, ctt, facing_s,
                            facing_t);
}
