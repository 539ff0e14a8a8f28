// Colors to scene-linear, against the standards' own formulas.

#include "texset/color_space.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <vector>

#include "math/error.h"
#include "support/files.h"

namespace scree::test {
namespace {

/// $OCIO for as long as a test runs; empty: unset.
class OcioVariable {
public:
    explicit OcioVariable(const std::string& value)
    {
        if (const char* before = std::getenv("OCIO"))
            before_ = before;
        value.empty() ? unsetenv("OCIO") : setenv("OCIO", value.c_str(), 1);
    }
    ~OcioVariable() { before_ ? setenv("OCIO", before_->c_str(), 1) : unsetenv("OCIO"); }
    OcioVariable(const OcioVariable&) = delete;
    OcioVariable& operator=(const OcioVariable&) = delete;

private:
    std::optional<std::string> before_;
};

using Rgb = std::array<double, 3>;

Rgb converted(const ColorConversion& conversion, const Rgb& color)
{
    std::array<float, 3> pixel{};
    for (size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<float>(color[c]);
    conversion.apply(pixel.data(), 1);
    return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
            static_cast<double>(pixel[2])};
}

// Oracle: IEC 61966-2-1, the piecewise curve.
double linear_of_srgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// Oracle: ACEScg (AP1, white D60) to Rec.709 (D65), chromatic adaptation by Bradford, to the ten
// digits in print: the colour-science and ACES documentation give the same matrix.
constexpr double kAp1ToRec709[3][3] = {{1.7050509927, -0.6217921207, -0.0832588720},
                                       {-0.1302564175, 1.1408047366, -0.0105483191},
                                       {-0.0240033568, -0.1289689761, 1.1529723329}};

std::string error_of(const std::string& config, const std::string& space,
                     const std::string& metadata, const std::string& file)
{
    try {
        const ColorConversion conversion(config, space, metadata, file);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

/// A config whose only color space doubles, so that a test sees whether it was used.
std::string doubling_config()
{
    return "ocio_profile_version: 2\n"
           "roles: {scene_linear: lin, default: doubled}\n"
           "file_rules: [!<Rule> {name: Default, colorspace: doubled}]\n"
           "displays: {d: [!<View> {name: v, colorspace: lin}]}\n"
           "colorspaces:\n"
           "  - !<ColorSpace> {name: lin}\n"
           "  - !<ColorSpace>\n"
           "    name: doubled\n"
           "    to_scene_reference: !<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, "
           "0,0,0,1]}\n";
}

std::filesystem::path write_text(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

// OpenColorIO's curve is the standard's power above 0.04045. Below, it is the straight line that
// meets the power without a kink: slope 1 / 12.92321 up to 0.03929, where the standard rounds to
// 1 / 12.92 and 0.04045. That is 2.5e-4 of the value, at most 7.6e-7.
constexpr double kSrgbAbsolute = 7.6e-7;
constexpr double kSrgbLineRelative = 2.5e-4;
constexpr double kFloatPow = 5e-7; // relative: float arithmetic through one pow

TEST(ColorSpace, SrgbIsUndoneByTheStandardsFormula)
{
    const OcioVariable none("");
    const ColorConversion conversion("", "srgb_tx", "", "a.png");
    EXPECT_EQ(conversion.working_space(), "lin_rec709");
    for (int i = 0; i <= 4096; ++i) {
        const double v = i / 4096.0;
        const Rgb got = converted(conversion, {v, 1 - v, 0.5});
        EXPECT_NEAR(got[0], linear_of_srgb(v), kSrgbAbsolute) << v;
        EXPECT_NEAR(got[1], linear_of_srgb(1 - v), kSrgbAbsolute) << 1 - v;
        EXPECT_NEAR(got[2], 0.21404114048223255, kFloatPow); // of 0.5, by hand
    }
}

TEST(ColorSpace, EveryEightBitSrgbCodeIsRightRelativeToItself)
{
    const OcioVariable none("");
    const ColorConversion conversion("", "srgb_tx", "", "a.png");
    for (int code = 0; code <= 255; ++code) {
        const double v = code / 255.0, want = linear_of_srgb(v);
        const double tolerance = v > 0.04045 ? kFloatPow : kSrgbLineRelative;
        EXPECT_NEAR(converted(conversion, {v, 0, 0})[0], want, tolerance * want) << code;
    }
}

TEST(ColorSpace, AcescgGoesToRec709ByTheKnownMatrix)
{
    const OcioVariable none("");
    for (const char* name : {"acescg", "ACEScg", "lin_ap1"}) {
        const ColorConversion conversion("", name, "", "a.exr");
        EXPECT_EQ(conversion.input_space(), "acescg");
        for (const Rgb& in :
             {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{1, 1, 1}, Rgb{0.18, 0.5, 12}}) {
            const Rgb got = converted(conversion, in);
            for (size_t row = 0; row < 3; ++row) {
                double want = 0, size = 0;
                for (size_t c = 0; c < 3; ++c) {
                    want += kAp1ToRec709[row][c] * in[c];
                    size += std::abs(kAp1ToRec709[row][c] * in[c]);
                }
                // float rounding of a sum of three; the matrix is printed to 1e-10
                EXPECT_NEAR(got[row], want, 5e-7 * size) << name << " row " << row;
            }
        }
    }
}

TEST(ColorSpace, WhiteStaysWhite)
{
    const OcioVariable none("");
    for (const char* name : {"acescg", "aces_ap0", "srgb_tx", "lin_rec709", "raw"}) {
        const Rgb white = converted(ColorConversion("", name, "", "a.exr"), {1, 1, 1});
        for (const double c : white)
            EXPECT_NEAR(c, 1, 2e-6) << name; // float sums of matrix rows whose digits are printed
    }
}

TEST(ColorSpace, LinearColorsPassUntouched)
{
    const OcioVariable none("");
    const ColorConversion conversion("", "lin_rec709", "", "a.exr");
    for (const float v : {0.0F, -0.5F, 1e-30F, 0.1F, 1.0F, 70000.0F, 3e38F}) {
        std::array<float, 3> rgb = {v, 2 * v / 3, -v};
        const auto before = rgb;
        conversion.apply(rgb.data(), 1);
        EXPECT_EQ(rgb, before);
    }
}

// Float pictures may be beyond [0, 1]: nothing may be clamped on the way.
TEST(ColorSpace, NothingIsClamped)
{
    const OcioVariable none("");
    const Rgb got = converted(ColorConversion("", "srgb_tx", "", "a.tif"), {2, 16, -0.01});
    for (size_t c = 0; c < 2; ++c) {
        const double want = linear_of_srgb(c == 0 ? 2 : 16);
        EXPECT_NEAR(got[c], want, kFloatPow * want);
    }
    EXPECT_NEAR(got[2], -0.01 / 12.92, kSrgbLineRelative * 0.01 / 12.92);
}

TEST(ColorSpace, ManyPixelsAreConvertedLikeOne)
{
    const OcioVariable none("");
    const ColorConversion conversion("", "acescg", "", "a.exr");
    std::vector<float> rgb(3 * 1001);
    for (size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = static_cast<float>(i * 37 % 101) / 101;
    const std::vector<float> before = rgb;
    conversion.apply(rgb.data(), 1001);
    for (size_t i = 0; i < rgb.size(); i += 3) {
        std::array<float, 3> one = {before[i], before[i + 1], before[i + 2]};
        conversion.apply(one.data(), 1);
        for (size_t c = 0; c < 3; ++c)
            ASSERT_EQ(rgb[i + c], one[c]) << "pixel " << i / 3;
    }
    conversion.apply(nullptr, 0);
}

TEST(ColorSpace, ARuleOfTheConfigDecidesWhenNobodyElseDoes)
{
    const OcioVariable none("");
    EXPECT_EQ(ColorConversion("", "", "", "/x/a.exr").input_space(), "lin_rec709");
    EXPECT_EQ(ColorConversion("", "", "", "/x/a.hdr").input_space(), "lin_rec709");
    EXPECT_EQ(ColorConversion("", "", "", "/x/a.png").input_space(), "srgb_tx");
    EXPECT_EQ(ColorConversion("", "", "", "/x/a.tif").input_space(), "srgb_tx");
}

TEST(ColorSpace, MetadataGoBeforeRulesAndTheOptionBeforeBoth)
{
    const OcioVariable none("");
    EXPECT_EQ(ColorConversion("", "", "Linear", "a.png").input_space(), "lin_rec709");
    EXPECT_EQ(ColorConversion("", "", "linear", "a.png").input_space(), "lin_rec709");
    EXPECT_EQ(ColorConversion("", "", "sRGB", "a.exr").input_space(), "srgb_tx");
    EXPECT_EQ(ColorConversion("", "", "ACEScg", "a.png").input_space(), "acescg");
    EXPECT_EQ(ColorConversion("", "raw", "sRGB", "a.exr").input_space(), "raw");
    EXPECT_EQ(ColorConversion("", "scene_linear", "sRGB", "a.png").input_space(), "lin_rec709");
    // a name the config does not have: the rules again
    EXPECT_EQ(ColorConversion("", "", "Rec709", "a.exr").input_space(), "lin_rec709");
}

TEST(ColorSpace, TheConfigOfTheOptionGoesBeforeTheOneOfTheEnvironment)
{
    TempFolder temp;
    const auto doubling = write_text(temp / "doubling.ocio", doubling_config()).string();
    {
        const OcioVariable ocio(doubling);
        const ColorConversion conversion("", "", "", "a.png");
        EXPECT_EQ(conversion.input_space(), "doubled");
        EXPECT_EQ(conversion.working_space(), "lin");
        EXPECT_EQ(converted(conversion, {0.25, 1, 3}), (Rgb{0.5, 2, 6}));
    }
    const OcioVariable missing((temp / "missing.ocio").string());
    EXPECT_EQ(converted(ColorConversion(doubling, "", "", "a.png"), {0.25, 1, 3}),
              (Rgb{0.5, 2, 6}));
    EXPECT_NE(error_of("", "", "", "a.png").find("$OCIO"), std::string::npos);
}

// Builds of OpenColorIO with SSE have an approximate power, which its default flags choose (Debian
// 12's build gives the same numbers either way).
TEST(ColorSpace, APlainGammaIsAsExactAsFloat)
{
    const OcioVariable none("");
    TempFolder temp;
    std::string text = doubling_config();
    const std::string matrix = "!<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}";
    ASSERT_NE(text.find(matrix), std::string::npos);
    text.replace(text.find(matrix), matrix.size(), "!<ExponentTransform> {value: 2.2}");
    const auto config = write_text(temp / "gamma.ocio", text).string();
    const ColorConversion conversion(config, "", "", "a.png");
    for (int code = 1; code <= 255; ++code) {
        const double want = std::pow(code / 255.0, 2.2);
        EXPECT_NEAR(converted(conversion, {code / 255.0, 0, 0})[0], want, kFloatPow * want) << code;
    }
}

TEST(ColorSpace, AnUnknownSpaceNamesTheFileTheSpaceAndTheChoices)
{
    const OcioVariable none("");
    const std::string message = error_of("", "sRBG", "", "/x/brick.png");
    for (const char* part : {"/x/brick.png", "'sRBG'", "--color-space", "'srgb_tx'", "'acescg'"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(ColorSpace, AConfigThatCannotBeUsedIsNamed)
{
    const OcioVariable none("");
    TempFolder temp;
    const auto missing = (temp / "missing.ocio").string();
    EXPECT_NE(error_of(missing, "", "", "a.png").find(missing), std::string::npos);
    const auto broken = write_text(temp / "broken.ocio", "ocio_profile_version: {").string();
    EXPECT_NE(error_of(broken, "", "", "a.png").find(broken), std::string::npos);
    std::string text = doubling_config();
    text.replace(text.find("scene_linear"), 12, "scene_loneli");
    const auto roleless = write_text(temp / "roleless.ocio", text).string();
    const std::string message = error_of(roleless, "", "", "a.png");
    EXPECT_NE(message.find(roleless), std::string::npos) << message;
    EXPECT_NE(message.find("scene_linear"), std::string::npos) << message;
}

TEST(ColorSpace, TheConfigInTheFolderIsTheOneTheProgramCarries)
{
    const OcioVariable none("");
    const std::string file = std::string(SCREE_CONFIGS) + "/config.ocio";
    for (const char* space : {"srgb_tx", "acescg", "aces_ap0"})
        EXPECT_EQ(converted(ColorConversion(file, space, "", "a.png"), {0.2, 0.5, 0.9}),
                  converted(ColorConversion("", space, "", "a.png"), {0.2, 0.5, 0.9}));
}

// The ACES studio's config: scene_linear is ACEScg there.
TEST(ColorSpace, TheAcesCgConfigConvertsSrgbToAcescg)
{
    const auto file = data_folder() / "colormaps/config/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio";
    if (data_folder().empty() || !std::filesystem::exists(file))
        GTEST_SKIP() << "no " << file;
    const OcioVariable none("");
    for (const char* metadata : {"sRGB", "srgb"}) {
        const ColorConversion conversion(file.string(), "", metadata, "a.png");
        EXPECT_EQ(conversion.working_space(), "ACEScg");
        EXPECT_EQ(conversion.input_space(), "sRGB - Texture");
        const Rgb in = {0.9, 0.5, 0.1};
        const Rgb got = converted(conversion, in);
        for (size_t row = 0; row < 3; ++row) {
            double back = 0; // the known matrix undoes it
            for (size_t c = 0; c < 3; ++c)
                back += kAp1ToRec709[row][c] * got[c];
            EXPECT_NEAR(back, linear_of_srgb(in[row]), 2e-6); // float, three sums of about 1
        }
    }
    EXPECT_EQ(ColorConversion(file.string(), "", "Linear", "a.exr").input_space(),
              "Linear Rec.709 (sRGB)");
}

} // namespace
} // namespace scree::test
