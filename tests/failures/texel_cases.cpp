#include <cmath>
#include <limits>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/surfaces.h"

namespace scree::test {
namespace {

// --- 17 ------------------------------------------------------------------------------------------

constexpr double kSlope = 0.5;

/// A plane of slope 0.5 with `hole` in the texels where `in_hole`.
template <class InHole>
MemorySource plane_with(double hole, InHole in_hole)
{
    return heights_of(64, 64, [=](int x, int y) { return in_hole(x, y) ? hole : kSlope * x; });
}

bool is_one_texel(int x, int y) { return x == 20 && y == 30; }
bool is_lake(int x, int y) { return x >= 16 && x < 24 && y >= 40 && y < 48; }
bool is_cut_out(int x, int y) { return (x - 32) * (x - 32) + (y - 32) * (y - 32) > 24 * 24; }

/// A DEM with a lake of no-data values, from its file.
BakedSet baked_dem(const MemorySource& dem)
{
    const TempFolder temp;
    write_image(temp / "dem.tif", height_image(dem));
    BakeOptions options = plain_options(Wrap::clamp);
    options.height_file = temp / "dem.tif";
    options.no_data_height = -32767;
    return baked_file(options);
}

/// A leaf whose outline is in the alpha of its color.
BakedSet baked_leaf(const MemorySource& leaf)
{
    const TempFolder temp;
    Image color{leaf.map_width, leaf.map_height, {"R", "G", "B", "A"}, {}};
    for (int y = 0; y < leaf.map_height; ++y)
        for (int x = 0; x < leaf.map_width; ++x)
            for (const float value : {0.1F, 0.6F, 0.1F, is_cut_out(x, y) ? 0.0F : 1.0F})
                color.pixels.push_back(value);
    write_image(temp / "height.exr", height_image(leaf));
    write_image(temp / "color.tif", color);
    BakeOptions options = plain_options(Wrap::clamp);
    options.height_file = temp / "height.exr";
    options.color_file = temp / "color.tif";
    options.color_space = "linear";
    options.alpha_weight = true;
    return baked_file(options);
}

std::optional<std::vector<Image>> maketx_clamped(const MemorySource& surface)
{
    return maketx_levels(height_image(surface), "-d float --wrap clamp");
}

Figure mean_square(const std::string& what, const MemorySource& surface, BakedSet set,
                   double bound = 1e-6)
{
    return Figure(what + ": E[ss] of the whole map", kSlope * kSlope)
        .peer("maketx", of_top(maketx_clamped(surface), kMeanSs))
        .ours(mean_ss(set.top()))
        .bound(bound);
}

Measured missing()
{
    const auto pricked = plane_with(std::numeric_limits<double>::quiet_NaN(), is_one_texel);
    const auto dem = plane_with(-32767, is_lake), leaf = plane_with(0, is_cut_out);
    BakedSet set = baked(pricked, plain_options(Wrap::clamp));
    const auto share_not_finite = mean_over(
        set, 0, [](const SetTexel& texel) { return std::isfinite(texel.slope.s) ? 0.0 : 1.0; });
    const auto maketx_not_finite =
        of_levels(maketx_clamped(pricked), [](const std::vector<Image>& levels) {
            double count = 0;
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x)
                    count += std::isfinite(levels[0].at(x, y, kMeanS)) ? 0 : 1;
            return count;
        });
    return {{mean_square("one NaN", pricked, baked(pricked, plain_options(Wrap::clamp))),
             Figure("one NaN: texels of level 0 that are not finite", 0)
                 .peer("maketx", maketx_not_finite)
                 .ours(64 * 64 * share_not_finite)
                 .relative_to(1, "a texel")
                 .bound(0),
             Figure("one NaN: share of the map that has data", 4095.0 / 4096)
                 .ours(static_cast<double>(set.top().coverage))
                 .bound(1e-6),
             mean_square("DEM with a lake", dem, baked_dem(dem)),
             // The topmost and the lowest texel of the disk are alone in their rows.
             mean_square("leaf", leaf, baked_leaf(leaf), 0.002)},
            {}};
}

// --- 18 ------------------------------------------------------------------------------------------

constexpr double kTexelWidth = 2.0 / 64, kTexelHeight = 2.0 / 32;

/// 64x32 texels over 2x2 units: V-grooves of slopes +-0.5 along s and along t.
MemorySource oblong()
{
    return heights_of(64, 32, [](int x, int y) {
        return 0.5 * (kTexelWidth * std::abs(x % 16 - 8) + kTexelHeight * std::abs(y % 16 - 8));
    });
}

/// Ratio of the roughness along t and along s.
double ratio(double ss, double tt) { return std::sqrt(tt / ss); }

std::optional<double> maketx_ratio(const MemorySource& surface, const std::string& options)
{
    return of_levels(maketx_levels(height_image(surface), "-d float --wrap periodic " + options),
                     [](const std::vector<Image>& levels) {
                         const auto top = [&](int channel) {
                             return static_cast<double>(levels.back().at(0, 0, channel));
                         };
                         return ratio(top(kMeanSs), top(kMeanTt));
                     });
}

/// E[ss] as a reader has it who divides by the texels of the file, here 128 where 100 were meant.
std::optional<double> maketx_resized(const MemorySource& surface)
{
    return of_levels(
        maketx_levels(height_image(surface), "-d float --wrap periodic --resize"),
        [&](const std::vector<Image>& levels) {
            const double scale = static_cast<double>(levels.front().width) / surface.map_width;
            return static_cast<double>(levels.back().at(0, 0, kMeanSs)) * scale * scale;
        });
}

/// A V-groove along the diagonal, slopes 0.25 a texel along s and t.
MemorySource diagonal()
{
    return heights_of(32, 32, [](int x, int y) { return 0.25 * std::abs((x + y) % 16 - 8); });
}

SetTexel baked_with_texels(const MemorySource& surface, double width, double height)
{
    BakeOptions options = plain_options();
    options.texel_size = {{width, height}};
    return baked(surface, options).top();
}

Measured texel_shapes()
{
    const SetTexel top = baked_with_texels(oblong(), kTexelWidth, kTexelHeight);
    const double ours = ratio(mean_ss(top), static_cast<double>(top.slope.tt));
    const auto hundred =
        heights_of(100, 100, [](int x, int) { return 0.5 * std::abs(x % 20 - 10); });
    // Of 16 cells 14 have the product of both slopes, those on the ridge and at the bottom none.
    const double diagonal_covariance = 0.25 * 0.25 * 14 / 16;
    const auto stretched = slopes_of(baked_with_texels(diagonal(), 1, 3)).covariance;
    return {
        {Figure("oblong texels: roughness along t over that along s", 1)
             .peer("maketx", maketx_ratio(oblong(), ""))
             .ours(ours)
             .bound(1e-5),
         Figure("oblong texels: roughness along t over that along s", 1)
             .peer("maketx --uvslopes_scale 2", maketx_ratio(oblong(), "--uvslopes_scale 2"))
             .ours(ours)
             .bound(1e-5),
         Figure("100x100 texels: E[ss]", 0.25)
             .peer("maketx --resize", maketx_resized(hundred))
             .ours(mean_ss(baked_with_texels(hundred, 1, 1)))
             .bound(1e-5),
         Figure("diagonal groove, t stretched by 3: covariance of s and t", diagonal_covariance / 3)
             .peer("plain code, squared scale", diagonal_covariance / 9)
             .ours(static_cast<double>(stretched.st))
             .bound(1e-5)},
        {}};
}

} // namespace

std::vector<FailureCase> texel_cases()
{
    return {
        {17, "Missing texels",
         R"(A plane of slope 0.5, 64x64: with one NaN; as a DEM with a lake of -32767; as a leaf, its
outline in the alpha of the color, height 0 outside.)",
         R"(One NaN spreads to its neighbours at level 0 and to everything above them. Values that mark no
data are taken for heights: cliffs. What lies outside a cut-out is not part of the surface.
Scree leaves such texels out at every level, completes the surface next to them, says what it
left out, and bakes how much of a texel has data.)",
         R"(Give `--no-data VALUE` and, for cut-outs, `--alpha-weight`. Read the coverage texture where a
filter reaches over the border of a hole.)",
         missing},
        {18, "Texels that are not square, stretched UVs",
         R"(64x32 texels over 2x2 units, V-grooves of slopes +-0.5 along both axes; a groove of 100 texels
resized to 128; a diagonal groove stretched by 3 along t.)",
         R"(Slopes in texel units mix units where a texel is not square, and are wrong by the ratio when a
tool resizes. Second moments take the scale squared, the mixed one the product of both. Scree
bakes slopes of world over world.)",
         R"(Give `--world-size` or `--texel-size`. Under a mapping with other scales, scale s and t and
their moments one by one.)",
         texel_shapes},
    };
}

} // namespace scree::test
