#include <cmath>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/surfaces.h"
#include "math/error.h"

namespace scree::test {
namespace {

// --- 14 ------------------------------------------------------------------------------------------

BakedSet baked_as(const MemorySource& surface, PixelTypeChoice type)
{
    BakeOptions options = plain_options();
    options.pixel_type = type;
    return baked(surface, options);
}

std::optional<double> maketx_mean_square(const MemorySource& surface)
{
    return of_top(maketx_levels(height_image(surface), "-d half --wrap periodic"), kMeanSs);
}

/// What a bake says that stops; empty where it does not.
template <class Bake>
std::string refusal(Bake bake)
{
    try {
        bake();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

Measured half_range()
{
    constexpr double kSteep = 300, kShallow = 1e-4;
    const auto cliff = v_groove(64, 16, kSteep), polished = v_groove(64, 16, kShallow);
    return {{Figure("E[ss], slopes +-300", kSteep * kSteep)
                 .peer("maketx -d half", maketx_mean_square(cliff))
                 .ours(mean_ss(baked_as(cliff, PixelTypeChoice::automatic).top()))
                 .bound(1e-6),
             Figure("E[ss], slopes +-0.0001", kShallow * kShallow)
                 .peer("maketx -d half", maketx_mean_square(polished))
                 .ours(mean_ss(baked_as(polished, PixelTypeChoice::automatic).top()))
                 .bound(1e-6),
             Figure("the same with `--pixel-type half`", kShallow * kShallow)
                 .ours(mean_ss(baked_as(polished, PixelTypeChoice::half).top()))
                 .bound(6)
                 .aside()},
            {{"slopes of +-300 with `--pixel-type half`",
              refusal([&] { baked_as(cliff, PixelTypeChoice::half); })}}};
}

// --- 20 ------------------------------------------------------------------------------------------

/// The options of a file that is written for the bake.
template <class Of>
auto of_file(const Image& image, const std::string& type, const std::string& ending, Of of)
{
    const TempFolder temp;
    BakeOptions options = plain_options();
    options.height_file = temp / ("in." + ending);
    options.name = "asset";
    write_image(options.height_file, image, type);
    return of(options);
}

constexpr double kGroove = 0.125; // slope of a V-groove whose heights are 0 to 1

/// Heights 0 to 1 along s, a ramp that 8 bits make a stair of: four texels a step.
Image stair()
{
    return height_image(heights_of(256, 16, [](int x, int) {
        const int step = x / 4;
        return step / 255.0;
    }));
}

Image in_three_channels(const Image& grey)
{
    Image rgb{grey.width, grey.height, {"R", "G", "B"}, {}};
    for (const float value : grey.pixels)
        rgb.pixels.insert(rgb.pixels.end(), 3, value);
    return rgb;
}

Image in_unit_range(Image normals)
{
    for (float& value : normals.pixels)
        value = (value + 1) / 2;
    return normals;
}

/// Mean slope of level 0: maketx's further levels start from it.
std::optional<double> maketx_mean_slope(const std::optional<std::vector<Image>>& levels)
{
    return of_levels(levels,
                     [](const std::vector<Image>& all) { return mean_over(all[0], kMeanS); });
}

double mean_slope(const BakeOptions& options) { return mean_s(baked_file(options).top()); }

Measured eight_bits()
{
    const double slope = 1 / 255.0 / 4;
    BakedSet set = of_file(stair(), "uint8", "tif", [](BakeOptions options) {
        options.wrap_s = options.wrap_t = Wrap::clamp;
        return baked_file(options);
    });
    const auto levels = maketx_levels(stair(), "-d float --wrap clamp", "uint8", "tif");
    Measured all;
    all.figures.push_back(Figure("ramp in 8 bits, four texels a step: variance", 0)
                              .peer("maketx", of_levels(levels, variance_of_top))
                              .ours(raw_variance_s(set.top()))
                              .relative_to(slope * slope, "the squared slope")
                              .bound(3.1)); // 3 but for the first and the last texels
    for (const std::string& warning : set.manifest().warnings)
        all.our_words.push_back({"the ramp", warning});
    return all;
}

Figure sixteen_bits()
{
    const Image groove = height_image(v_groove(64, 16, kGroove));
    return Figure("groove in 16-bit integers: mean slope", 0)
        .peer("maketx without -d",
              maketx_mean_slope(maketx_levels(groove, "--wrap periodic", "uint16", "tif")))
        .ours(of_file(groove, "uint16", "tif", mean_slope))
        .relative_to(kGroove, "the slope")
        .bound(1e-4); // heights rounded to 2^-16
}

Measured nearly_grey()
{
    Image rgb = in_three_channels(height_image(v_groove(64, 16, kGroove)));
    rgb.pixels[1] += 1 / 255.0F; // as from a JPEG file
    const auto by_channel = [](BakeOptions options) {
        options.height_channel = "R";
        return mean_slope(options);
    };
    const std::string words = of_file(rgb, "float", "exr", [](const BakeOptions& options) {
        return refusal([&] { baked_file(options); });
    });
    return {{Figure("groove as RGB, one value off grey by 1/255: mean slope", 0)
                 .peer("maketx", maketx_mean_slope(maketx_levels(rgb, "-d float")))
                 .ours(of_file(rgb, "float", "exr", by_channel))
                 .relative_to(kGroove, "the slope")
                 .bound(1e-6)},
            {{"the RGB groove", words.substr(words.find(": ") + 2)}}}; // without the file's folder
}

Figure unit_normals()
{
    const auto plane = slope_map_of(64, 16, [](int, int) { return std::array<double, 2>{0.5, 0}; });
    const Image normals = in_unit_range(normal_image(plane));
    return Figure("normal map stored in [0, 1]: slope", 0.5)
        .peer("maketx", maketx_mean_slope(maketx_levels(normals, "-d float --bumpformat normal")))
        .ours(of_file(normals, "float", "exr",
                      [](BakeOptions options) {
                          options.normal_input = true;
                          return mean_slope(options);
                      }))
        .bound(1e-6);
}

Measured encodings()
{
    Measured all = eight_bits();
    const Measured grey = nearly_grey();
    all.figures.insert(all.figures.end(), {sixteen_bits(), grey.figures[0], unit_normals()});
    add_words(all, grey.our_words);
    return all;
}

} // namespace

std::vector<FailureCase> number_cases()
{
    return {
        {14, "Half floats out of range",
         R"(V-grooves along t of slopes +-300 (a scale forgotten, a cliff) and +-0.0001 (polished metal),
64x16.)",
         R"(Half floats hold squares of slopes up to 255.9 and down to 0.0002. Beyond, E[ss] saturates or is
0, and nothing says so. Scree takes float where half would cost more than `--half-tolerance` and
stops where a type given by hand overflows.)",
         R"(Leave `--pixel-type` on auto. Given half by hand, a surface this smooth loses all its roughness.)",
         half_range},
        {20, "How the input is encoded",
         R"(A ramp in 8 bits; a groove in 16-bit integers; the groove as RGB that is not quite grey; a
normal map of slope 0.5 stored in [0, 1].)",
         R"(8 bits turn a ramp into a stair, whose treads and risers are real slopes as far as any baker can
tell. Integer inputs make maketx write integers, which cannot be negative; it takes three
channels that differ anywhere for a normal map, and normals for [-1, 1].)",
         R"(Give heights in 16 bits or float; Scree cannot undo the terraces of 8 bits but says how much of
the variance they explain. Smooth such a map before the bake. Name the channel of an RGB height
map.)",
         encodings},
    };
}

} // namespace scree::test
