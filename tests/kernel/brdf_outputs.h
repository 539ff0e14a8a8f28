// Every function of scree_brdf_coordinates.h once, of two directions and of coordinates that need
// not have any. In the kernel's own common subset of C++, GLSL and OSL, so that all three run the
// same calls: include after scree_brdf_coordinates.h. shaders/brdf_agreement.h names the numbers.

SCREE_FUNCTION void brdf_lengths(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                 OUT(Real, oz), OUT(Real, iz), OUT(Real, oo), OUT(Real, ii))
{
    oz = woz;
    iz = wiz;
    oo = wox * wox + woy * woy + woz * woz;
    ii = wix * wix + wiy * wiy + wiz * wiz;
}

SCREE_FUNCTION void brdf_coordinates(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                     OUT(Real, a0), OUT(Real, a1), OUT(Real, a2), OUT(Real, a3),
                                     OUT(Real, b0), OUT(Real, b1), OUT(Real, b2), OUT(Real, b3),
                                     OUT(Real, c0), OUT(Real, c1), OUT(Real, c2), OUT(Real, c3),
                                     OUT(Real, i0), OUT(Real, i1), OUT(Real, i2), OUT(Real, i3),
                                     OUT(Real, i4), OUT(Real, i5), OUT(Real, i6))
{
    scree_to_half_difference(wox, woy, woz, wix, wiy, wiz, a0, a1, a2, a3);
    scree_to_orthographic(wox, woy, wix, wiy, b0, b1, b2, b3);
    scree_to_hybrid(wox, woy, woz, wix, wiy, wiz, c0, c1, c2, c3);
    scree_isotropic_coordinates(wox, woy, woz, wix, wiy, wiz, i0, i1, i2, i3, i4, i5, i6);
}

SCREE_FUNCTION void brdf_beyond(Real h, Real phi_h, Real k, Real phi_k, OUT(Real, r0),
                                OUT(Real, r1), OUT(Real, r2), OUT(Real, a0), OUT(Real, a1),
                                OUT(Real, a2), OUT(Real, a3), OUT(Real, b0), OUT(Real, b1),
                                OUT(Real, b2), OUT(Real, b3), OUT(Real, c0), OUT(Real, c1),
                                OUT(Real, c2), OUT(Real, c3))
{
    Real quarter = LIT(1.57079632679489662);
    r0 = scree_half_difference_reach(h * quarter, phi_k - phi_h);
    r1 = scree_orthographic_reach(h, phi_k - phi_h);
    r2 = scree_hybrid_reach(h, phi_k - phi_h);
    Real wox, woy, woz, wix, wiy, wiz;
    scree_from_half_difference(h * quarter, phi_h, k * quarter, phi_k, wox, woy, woz, wix, wiy,
                               wiz);
    brdf_lengths(wox, woy, woz, wix, wiy, wiz, a0, a1, a2, a3);
    scree_from_orthographic(h, phi_h, k, phi_k, wox, woy, woz, wix, wiy, wiz);
    brdf_lengths(wox, woy, woz, wix, wiy, wiz, b0, b1, b2, b3);
    scree_from_hybrid(h, phi_h, k, phi_k, wox, woy, woz, wix, wiy, wiz);
    brdf_lengths(wox, woy, woz, wix, wiy, wiz, c0, c1, c2, c3);
}
