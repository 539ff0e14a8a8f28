#include <cmath>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/surfaces.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

double slope_at(BakedSet& set, int x, int y) { return mean_s(set.texel(0, x, y)); }

// --- 15 ------------------------------------------------------------------------------------------

/// Slope of the first column.
Figure first_column(const std::string& what, const MemorySource& surface, Wrap wrap, double truth)
{
    constexpr int kRow = 8;
    BakedSet set = baked(surface, plain_options(wrap));
    const auto levels = maketx_levels(height_image(surface), "-d float --wrap " + wrap_name(wrap));
    return Figure(what + ": slope of the first column", truth)
        .peer("maketx", of_levels(levels,
                                  [](const std::vector<Image>& found) {
                                      return found[0].at(0, kRow, kMeanS);
                                  }))
        .ours(slope_at(set, 0, kRow))
        .bound(1e-6);
}

Measured edges()
{
    const auto wave = heights_of(128, 16, [](int x, int) { return std::sin(2 * kPi * x / 128); });
    const auto plane = heights_of(64, 64, [](int x, int) { return 2.0 * x; });
    const auto levels = maketx_levels(height_image(plane), "-d float --wrap clamp");
    return {{Figure("plane, clamped: variance at the 1x1 level", 0)
                 .peer("maketx", of_levels(levels, variance_of_top))
                 .ours(raw_variance_s(baked(plane, plain_options(Wrap::clamp)).top()))
                 .relative_to(4, "the squared slope")
                 .bound(1e-6),
             first_column("plane, clamped", plane, Wrap::clamp, 2),
             first_column("wave, periodic", wave, Wrap::periodic, std::sin(2 * kPi / 128)),
             // Half of that texel lies in the crease between the plane and its mirror image.
             first_column("plane, mirrored", plane, Wrap::mirror, 1)},
            {}};
}

// --- 16 ------------------------------------------------------------------------------------------

/// E[ss] of the 1x1 level over the mean of level 0.
Figure conserved(int width, int height)
{
    const auto noise = white_noise(width, height, 1);
    BakedSet set = baked(noise, plain_options(Wrap::clamp));
    return Figure(std::to_string(width) + "x" + std::to_string(height) +
                      ": E[ss] of the 1x1 level over that of level 0",
                  1)
        .peer("maketx", of_levels(maketx_levels(height_image(noise), "-d float --wrap clamp"),
                                  [](const std::vector<Image>& levels) {
                                      return mean_over(levels.back(), kMeanSs) /
                                             mean_over(levels.front(), kMeanSs);
                                  }))
        .ours(mean_ss(set.top()) / mean_over(set, 0, mean_ss))
        .bound(1e-6);
}

Measured odd_sizes()
{
    return {{conserved(99, 99), conserved(3, 3), conserved(96, 96), conserved(127, 5),
             conserved(97, 1)},
            {}};
}

// --- 19 ------------------------------------------------------------------------------------------

MemorySource left_half(const MemorySource& surface)
{
    const int width = surface.map_width / 2;
    return heights_of(width, surface.map_height,
                      [&](int x, int y) { return surface.heights[index_of(surface, x, y)]; });
}

/// RMS error of the slopes along the seam, over their RMS.
template <class SlopeAt>
double seam_error(const MemorySource& whole, SlopeAt slope_at_texel)
{
    const int seam = whole.map_width / 2 - 1;
    double errors = 0, squares = 0;
    for (int y = 1; y + 1 < whole.map_height; ++y) { // the corners lack other neighbours too
        const double truth = slope_of_texel(whole, seam, y);
        const double error = slope_at_texel(seam, y) - truth;
        errors += error * error;
        squares += truth * truth;
    }
    return std::sqrt(errors / squares);
}

Figure seam(const std::string& what, const MemorySource& whole, Wrap wrap, double bound)
{
    const MemorySource tile = left_half(whole);
    BakedSet set = baked(tile, plain_options(wrap));
    const auto levels = maketx_levels(height_image(tile), "-d float --wrap " + wrap_name(wrap));
    return Figure(what + ": RMS error of the slope along the seam", 0)
        .peer("maketx", of_levels(levels,
                                  [&](const std::vector<Image>& found) {
                                      return seam_error(whole, [&](int x, int y) {
                                          return static_cast<double>(found[0].at(x, y, kMeanS));
                                      });
                                  }))
        .ours(seam_error(whole, [&](int x, int y) { return slope_at(set, x, y); }))
        .relative_to(1, "the RMS slope")
        .bound(bound);
}

Measured tiles()
{
    const auto plane = heights_of(128, 64, [](int x, int) { return 0.5 * x; });
    const auto waves = gaussian_waves(128, 8, 32, 1), fine = gaussian_waves(128, 3, 32, 1);
    return {{seam("waves of 8 texels and more", waves, Wrap::clamp, 0.22),
             seam("waves of 3 texels and more", fine, Wrap::clamp, 0.55),
             seam("plane", plane, Wrap::clamp, 1e-6),
             seam("waves of 8 texels and more, wrapped", waves, Wrap::periodic, 2.6).aside()},
            {}};
}

} // namespace

std::vector<FailureCase> border_cases()
{
    return {
        {15, "Edges",
         R"(A plane of slope 2, 64x64, clamped or mirrored; a wave, one period over 128x16, periodic.)",
         R"(The slope of a border texel needs a neighbour that is not there. maketx repeats the border texel
whatever the wrap: half the slope at the edge of a plane, a variance where there is none, a seam
in a tiling map. Scree continues the surface as the wrap says; clamp continues the last cell, so
that a plane stays a plane.)",
         R"(Say how the map tiles (`--wrap`). The default is periodic: a map that does not tile gets a cliff
at its edges.)",
         edges},
        {16, "Sizes that are no powers of two",
         "White noise of 99x99, 3x3, 96x96, 127x5 and 97x1 texels, clamped.",
         R"(A texel of a level that is half of an odd size covers two texels and a part of a third. maketx's
box filter takes whole texels only: from level to level the surface gets rougher or smoother.
Scree takes fractions.)",
         "Nothing to do.", odd_sizes},
        {19, "UDIM tiles",
         R"(The left one of two tiles of a surface that goes on over the seam: waves of 8 texels and more,
of 3 texels and more, a plane; 64 texels a tile.)",
         R"(Baked alone, a tile does not know its neighbour's heights. Scree does not bake UDIM sets yet.
Tiles baked one by one with clamp have no seam in planes; elsewhere the slope of the border texels
is a guess, a different one in either tile, and the finer the detail the worse. Wrapped, which is
the default, a tile meets its own other side: a cliff.)",
         R"(Bake tiles with `--wrap clamp`, never with the default, or give each tile a margin of its
neighbours.)",
         tiles},
    };
}

} // namespace scree::test
