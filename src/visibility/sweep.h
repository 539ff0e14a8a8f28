#pragma once

#include <vector>

#include "visibility/height_grid.h"

namespace scree {

/// A rectangle of level-0 texels, inside the map; width, height >= 1.
struct TexelBlock {
    int x0 = 0, y0 = 0, width = 0, height = 0;
};

/// What a sweep costs and how good it is.
struct SweepOptions {
    /// Lines side by side in a texel, whose mean it gets; >= 1. Time goes with their number; with
    /// twice as many, areas of 4x4 texels are off by less than half: between neighbouring lines is
    /// what a texel may show.
    int lines_per_texel = 2;
    /// Texels of a level that a line is followed through, before that it is on a coarser one; >= 1.
    /// Of hills upon hills, 90 texels from low to high, the mean v of 16x16 texels is off by less
    /// than 0.004 at 80 degrees, 0.015 at 85, 0.025 at 87 (root mean square); half as many steps,
    /// about twice the error.
    int near_steps = 256;
};

/// What views from one azimuth, at several elevations, see of a block of texels:
///
///   v = E[V W] / cos theta
///
/// over the texel, W the projected area of the surface towards the view, V whether it is visible;
/// 1 on a plane, and on average over a map that goes on.
///
/// Lines run towards the viewer, one texel apart or less, and are followed away from him. With the
/// height above the line of sight g = h - d cot theta, d the distance towards the viewer, a point
/// is visible where no g nearer to him is higher; so the visible area, projected, is what the
/// running maximum of g rises by. No horizon is kept, no slope is needed, and the areas of a line
/// add up to its length times cos theta whatever the heights are. Derived in docs/visibility.md.
///
/// A line's profile is the bilinear surface where it crosses rows and columns, of texel centres and
/// of texel edges, straight in between; what a piece shows counts for the texel it is in. So detail
/// of a texel or two has its color. Between these nodes the surface is a parabola, of which a chord
/// cuts the top: the colors of walls of one texel that stand aslant, 1.2 texels high, are off by
/// 0.01 of white, other detail by less [tests/visibility/sweep_detail_test.cpp]. A texel gets what
/// some lines see in it: samples, so single texels are noisy and areas of 16x16 are not
/// [tests/visibility/sweep_reference_test.cpp].
///
/// Cells between texels without data, and beyond a map that ends, hide nothing; texels beside them
/// are seen up to their edges (LineWindow::make_whole()).
///
/// Lines begin where nothing beyond can hide the block: up to near_steps texels before it on level
/// 0, then as many texels of each coarser level. Time a texel is constant but for that. Lines and
/// levels lie on the map the same way for all blocks, so a texel's numbers are the same whichever
/// block it is in, as long as level 0 is enough for the lines' beginnings.
///
/// heights      any
/// azimuth_rad  of the viewer, from +s towards +t
/// cotangents   of the angles from the normal, > 0; at least one
/// visible      an elevation: width x height numbers >= 0, row by row; 0 where there is no data
void sweep(const HeightGrid& heights, const TexelBlock& block, double azimuth_rad,
           const std::vector<double>& cotangents, float* const* visible,
           const SweepOptions& options = {});

} // namespace scree
