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
#include "support/color.h"
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

Rgb converted(const ColorConversion& conversion, const Rgb& color)
{
    std::array<float, 3> pixel{};
    for (size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<float>(color[c]);
    conversion.apply(pixel.data(), 1);
    return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
            static_cast<double>(pixel[2])};
}

// Oracle: ACEScg (AP1, white D60) to Rec.709 (D65), chromatic adaptation by Bradford, to the ten
// digits in print: the colour-science and ACES documentation give the same matrix.
constexpr double kAp1ToRec709[3][3] = {{1.7050509927, -0.6217921207, -0.0832588720},
                                       {-0.1302564175, 1.1408047366, -0.0105483191},
                                       {-0.0240033568, -0.1289689761, 1.1529723329}};

ColorConversion conversion_of(const std::string& config, const std::string& space,
                              const std::string& stated, const std::string& file)
{
    return ColorConversion({config, "", space, stated, file});
}

/// From `space` of a config to a working space.
ColorConversion into(const std::string& working, const std::string& config,
                     const std::string& space)
{
    return ColorConversion({config, working, space, "", "a.exr"});
}

std::string error_of(const ColorRequest& request)
{
    try {
        const ColorConversion conversion(request);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

std::string error_of(const std::string& config, const std::string& space, const std::string& stated,
                     const std::string& file)
{
    return error_of({config, "", space, stated, file});
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
    const ColorConversion conversion = conversion_of("", "srgb_tx", "", "a.png");
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
    const ColorConversion conversion = conversion_of("", "srgb_tx", "", "a.png");
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
        const ColorConversion conversion = conversion_of("", name, "", "a.exr");
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

// 0.7328 and the like of the matrices cancel: float sums of three terms that are this large.
double size_of(const Matrix& m, const Rgb& v)
{
    double size = 0;
    for (const Rgb& row : m)
        for (size_t c = 0; c < 3; ++c)
            size = std::max(size, std::abs(row[c] * v[c]));
    return size;
}

TEST(ColorSpace, PrimariesAreExchangedAsTheirDefinitionsSay)
{
    const OcioVariable none("");
    const std::pair<const char*, Primaries> spaces[] = {
        {"lin_rec709", kRec709}, {"acescg", kAp1}, {"aces_ap0", kAp0}};
    for (const auto& [from, from_xy] : spaces)
        for (const auto& [to, to_xy] : spaces) {
            const Matrix m = rgb_to_rgb(from_xy, to_xy);
            const ColorConversion conversion = into(to, "", from);
            EXPECT_EQ(conversion.input_space(), from);
            EXPECT_EQ(conversion.working_space(), to);
            for (const Rgb& in : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{0.18, 0.5, 12}}) {
                const Rgb want = times(m, in), got = converted(conversion, in);
                for (size_t c = 0; c < 3; ++c) // two matrices in a row where neither is Rec.709
                    EXPECT_NEAR(got[c], want[c], 1e-6 * size_of(m, in)) << from << " to " << to;
            }
        }
}

TEST(ColorSpace, WhiteStaysWhite)
{
    const OcioVariable none("");
    for (const char* name : {"acescg", "aces_ap0", "srgb_tx", "lin_rec709", "raw"}) {
        const Rgb white = converted(conversion_of("", name, "", "a.exr"), {1, 1, 1});
        for (const double c : white)
            EXPECT_NEAR(c, 1, 2e-6) << name; // float sums of matrix rows whose digits are printed
    }
}

TEST(ColorSpace, LinearColorsPassUntouched)
{
    const OcioVariable none("");
    const ColorConversion conversion = conversion_of("", "lin_rec709", "", "a.exr");
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
    const Rgb got = converted(conversion_of("", "srgb_tx", "", "a.tif"), {2, 16, -0.01});
    for (size_t c = 0; c < 2; ++c) {
        const double want = linear_of_srgb(c == 0 ? 2 : 16);
        EXPECT_NEAR(got[c], want, kFloatPow * want);
    }
    EXPECT_NEAR(got[2], -0.01 / 12.92, kSrgbLineRelative * 0.01 / 12.92);
}

TEST(ColorSpace, ManyPixelsAreConvertedLikeOne)
{
    const OcioVariable none("");
    const ColorConversion conversion = conversion_of("", "acescg", "", "a.exr");
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
    EXPECT_EQ(conversion_of("", "", "", "/x/a.exr").input_space(), "lin_rec709");
    EXPECT_EQ(conversion_of("", "", "", "/x/a.hdr").input_space(), "lin_rec709");
    EXPECT_EQ(conversion_of("", "", "", "/x/a.png").input_space(), "srgb_tx");
    EXPECT_EQ(conversion_of("", "", "", "/x/a.tif").input_space(), "srgb_tx");
}

TEST(ColorSpace, MetadataGoBeforeRulesAndTheOptionBeforeBoth)
{
    const OcioVariable none("");
    EXPECT_EQ(conversion_of("", "", "Linear", "a.png").input_space(), "lin_rec709");
    EXPECT_EQ(conversion_of("", "", "linear", "a.png").input_space(), "lin_rec709");
    EXPECT_EQ(conversion_of("", "", "sRGB", "a.exr").input_space(), "srgb_tx");
    EXPECT_EQ(conversion_of("", "", "ACEScg", "a.png").input_space(), "acescg");
    EXPECT_EQ(conversion_of("", "raw", "sRGB", "a.exr").input_space(), "raw");
    EXPECT_EQ(conversion_of("", "scene_linear", "sRGB", "a.png").input_space(), "lin_rec709");
    // a name the config does not have: the rules again
    EXPECT_EQ(conversion_of("", "", "Rec709", "a.exr").input_space(), "lin_rec709");
}

TEST(ColorSpace, TheConfigOfTheOptionGoesBeforeTheOneOfTheEnvironment)
{
    TempFolder temp;
    const auto doubling = write_text(temp / "doubling.ocio", doubling_config()).string();
    {
        const OcioVariable ocio(doubling);
        const ColorConversion conversion = conversion_of("", "", "", "a.png");
        EXPECT_EQ(conversion.input_space(), "doubled");
        EXPECT_EQ(conversion.working_space(), "lin");
        EXPECT_EQ(converted(conversion, {0.25, 1, 3}), (Rgb{0.5, 2, 6}));
    }
    const OcioVariable missing((temp / "missing.ocio").string());
    EXPECT_EQ(converted(conversion_of(doubling, "", "", "a.png"), {0.25, 1, 3}), (Rgb{0.5, 2, 6}));
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
    const ColorConversion conversion = conversion_of(config, "", "", "a.png");
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
        EXPECT_EQ(converted(conversion_of(file, space, "", "a.png"), {0.2, 0.5, 0.9}),
                  converted(conversion_of("", space, "", "a.png"), {0.2, 0.5, 0.9}));
}

// The ACES studio's config: scene_linear is ACEScg there.
TEST(ColorSpace, TheAcesCgConfigConvertsSrgbToAcescg)
{
    const auto file = data_folder() / "colormaps/config/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio";
    if (data_folder().empty() || !std::filesystem::exists(file))
        GTEST_SKIP() << "no " << file;
    const OcioVariable none("");
    for (const char* metadata : {"sRGB", "srgb"}) {
        const ColorConversion conversion = conversion_of(file.string(), "", metadata, "a.png");
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
    EXPECT_EQ(conversion_of(file.string(), "", "Linear", "a.exr").input_space(),
              "Linear Rec.709 (sRGB)");
}

// --- the working space ---------------------------------------------------------------------------

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Path of one of the ACES studio's configs; empty where the data folder is absent.
std::string studio_config(const std::string& name)
{
    const auto file = data_folder() / "colormaps/config" / name;
    return !data_folder().empty() && std::filesystem::exists(file) ? file.string() : "";
}

const char* const kCgConfig = "cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio";
const char* const kDemoConfig = "ocio-v2_demo.ocio";

TEST(ColorSpace, TheWorkingSpaceIsASpaceARoleOrAnAlias)
{
    const OcioVariable none("");
    EXPECT_EQ(into("", "", "raw").working_space(), "lin_rec709");
    EXPECT_EQ(into("scene_linear", "", "raw").working_space(), "lin_rec709");
    EXPECT_EQ(into("aces_interchange", "", "raw").working_space(), "aces_ap0");
    EXPECT_EQ(into("ACEScg", "", "raw").working_space(), "acescg");
    EXPECT_EQ(into("lin_ap0", "", "raw").working_space(), "aces_ap0");
}

TEST(ColorSpace, ARoleIsNotNeededWhereAWorkingSpaceIsNamed)
{
    const OcioVariable none("");
    TempFolder temp;
    std::string text = doubling_config();
    text.replace(text.find("scene_linear"), 12, "scene_loneli");
    const auto roleless = write_text(temp / "roleless.ocio", text).string();
    EXPECT_EQ(converted(into("lin", roleless, "doubled"), {0.25, 1, 3}), (Rgb{0.5, 2, 6}));
}

TEST(ColorSpace, AWorkingSpaceThatIsNotSceneLinearIsAnErrorWithTheChoices)
{
    const OcioVariable none("");
    for (const char* space : {"srgb_tx", "color_picking", "raw"}) {
        const std::string message = error_of({"", space, "", "", "/x/brick.png"});
        for (const char* part : {"/x/brick.png", "--working-space", "not scene-linear",
                                 "'lin_rec709', 'acescg', 'aces_ap0'"})
            EXPECT_TRUE(contains(message, part)) << part << " is not in: " << message;
        EXPECT_EQ(contains(message, "'raw' holds data"), std::string(space) == "raw") << message;
    }
    TempFolder temp;
    std::string text = doubling_config();
    text.replace(text.find("name: lin}"), 10, "name: lin, encoding: log}");
    const auto config = write_text(temp / "log.ocio", text).string();
    EXPECT_TRUE(contains(error_of({config, "", "", "", "a.exr"}), "role scene_linear, 'lin' is"));
    const std::string message = error_of({"", "acescq", "", "", "/x/brick.png"});
    for (const char* part : {"/x/brick.png", "--working-space 'acescq'", "not in", "'srgb_tx'"})
        EXPECT_TRUE(contains(message, part)) << part << " is not in: " << message;
}

TEST(ColorSpace, TheAcesConfigsTakeTheirSceneLinearSpacesAndNoOthers)
{
    const OcioVariable none("");
    const std::string cg = studio_config(kCgConfig), demo = studio_config(kDemoConfig);
    if (cg.empty() || demo.empty())
        GTEST_SKIP() << "no data folder";
    for (const char* space : {"ACEScg", "lin_ap0", "Linear Rec.709 (sRGB)", "lin_rec2020"})
        EXPECT_EQ(error_of({cg, space, "", "", "a.exr"}), "") << space;
    // encoded by its own word; without a word; data; a display's
    for (const char* space : {"ACEScct", "sRGB - Texture", "Raw", "CIE-XYZ-D65"}) {
        const std::string message = error_of({cg, space, "", "", "a.exr"});
        EXPECT_TRUE(contains(message, "'ACES2065-1', 'ACEScg', 'Linear P3-D65', 'Linear Rec.2020', "
                                      "'Linear Rec.709 (sRGB)'"))
            << space << ": " << message;
    }
    for (const char* space : {"ACEScg", "aces", "scene-linear Rec.709-sRGB"})
        EXPECT_EQ(error_of({demo, space, "", "", "a.exr"}), "") << space;
    for (const char* space : {"ACEScct", "sRGB", "Raw", "ARRI LogC"})
        EXPECT_TRUE(contains(error_of({demo, space, "", "", "a.exr"}), "not scene-linear"))
            << space;
}

// --- what a header states ------------------------------------------------------------------------

TEST(ColorSpace, AHeadersNamesAreFoundUnderTheConfigsOwn)
{
    const OcioVariable none("");
    const std::string cg = studio_config(kCgConfig), demo = studio_config(kDemoConfig);
    struct Case {
        std::string config;
        const char *stated, *space;
    };
    std::vector<Case> cases = {
        {"", "sRGB", "srgb_tx"},          {"", "lin_rec709", "lin_rec709"},
        {"", "ACEScg", "acescg"},         {"", "ACES2065-1", "aces_ap0"},
        {"", "color_picking", "srgb_tx"}, {"", "scene_linear", "lin_rec709"}};
    if (!cg.empty())
        cases.insert(cases.end(), {{cg, "sRGB", "sRGB - Texture"},
                                   {cg, "lin_rec709", "Linear Rec.709 (sRGB)"},
                                   {cg, "lin_rec2020", "Linear Rec.2020"},
                                   {cg, "lin_p3d65", "Linear P3-D65"},
                                   {cg, "ACEScg", "ACEScg"},
                                   {cg, "ACES2065-1", "ACES2065-1"},
                                   {cg, "Gamma2.2", "Gamma 2.2 Rec.709 - Texture"},
                                   {cg, "Gamma1.8", "Gamma 1.8 Rec.709 - Texture"},
                                   {cg, "color_picking", "sRGB - Texture"},
                                   {cg, "scene_linear", "ACEScg"}});
    if (!demo.empty())
        cases.insert(cases.end(), {{demo, "sRGB", "sRGB"},
                                   {demo, "lin_rec709", "scene-linear Rec.709-sRGB"},
                                   {demo, "ACEScg", "ACEScg"},
                                   {demo, "ACES2065-1", "ACES2065-1"}});
    for (const auto& [config, stated, space] : cases) {
        const ColorConversion conversion = conversion_of(config, "", stated, "x.png");
        EXPECT_EQ(conversion.input_space(), space) << config << ": " << stated;
        EXPECT_TRUE(conversion.notes().empty()) << config << ": " << stated;
    }
}

// One color into three configs by what its header says, out in ACEScg.
TEST(ColorSpace, TheAcesConfigsGiveTheStandardsNumbers)
{
    const OcioVariable none("");
    const Rgb in = {0.9, 0.5, 0.1};
    for (const std::string& config :
         {std::string(), studio_config(kCgConfig), studio_config(kDemoConfig)})
        for (const auto& [stated, primaries] :
             {std::pair("sRGB", kRec709), {"lin_rec709", kRec709}, {"ACES2065-1", kAp0}}) {
            const bool encoded = std::string(stated) == "sRGB";
            const ColorConversion conversion({config, "ACEScg", "", stated, "x.png"});
            const Rgb got = converted(conversion, in);
            Rgb light = in;
            for (double& c : light)
                c = encoded ? linear_of_srgb(c) : c;
            const Rgb want = times(rgb_to_rgb(primaries, kAp1), light);
            for (size_t c = 0; c < 3; ++c) // float, three sums of about 1
                EXPECT_NEAR(got[c], want[c], 2e-6) << config << ": " << stated;
        }
}

TEST(ColorSpace, TheCarriedConfigKnowsThePrimariesThatHeadersState)
{
    const OcioVariable none("");
    const Rgb in = {0.9, 0.5, 0.1};
    for (const auto& [stated, primaries] : {std::pair("lin_rec709", kRec709),
                                            {"ACES2065-1", kAp0},
                                            {"ACEScg", kAp1},
                                            {"lin_rec2020", kRec2020},
                                            {"lin_p3d65", kP3D65}}) {
        const Rgb got = converted(ColorConversion({"", "", "", stated, "x.exr"}), in);
        const Rgb want = times(rgb_to_rgb(primaries, kRec709), in);
        for (size_t c = 0; c < 3; ++c) // float, three sums of about 1
            EXPECT_NEAR(got[c], want[c], 2e-6) << stated;
    }
    const Rgb gamma = converted(ColorConversion({"", "", "", "Gamma2.2", "x.png"}), in);
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(gamma[c], std::pow(in[c], 2.2), 1e-6);
}

TEST(ColorSpace, ANameTheConfigDoesNotKnowIsNotedAndItsFallbackOrTheRulesDecide)
{
    const OcioVariable none("");
    for (const auto& [stated, fallback, file, space] :
         {std::tuple("Display P3", "sRGB", "/x/a.exr", "srgb_tx"),
          {"Display P3", "", "/x/a.exr", "lin_rec709"},
          {"lin_awg3", "", "/x/a.exr", "lin_rec709"},
          {"lin_awg3", "", "/x/a.png", "srgb_tx"},
          {"Gamma1.8", "sRGB", "/x/a.png", "srgb_tx"}}) {
        const ColorConversion conversion({"", "", "", stated, file, fallback});
        EXPECT_EQ(conversion.input_space(), space);
        ASSERT_EQ(conversion.notes().size(), 1U);
        for (const std::string& part :
             {std::string(file), std::string("'") + stated + "'",
              "read as '" + std::string(space) + "'", std::string("--color-space")})
            EXPECT_TRUE(contains(conversion.notes()[0], part)) << conversion.notes()[0];
        EXPECT_TRUE(ColorConversion({"", "", "raw", stated, file, fallback}).notes().empty())
            << "the user has said what it is";
    }
}

TEST(ColorSpace, JustLinearGivesWayToARuleButNotToTheDefaultRule)
{
    const OcioVariable none("");
    TempFolder temp;
    std::string text = doubling_config();
    const std::string rule = "[!<Rule> {name: Default";
    text.replace(text.find(rule), rule.size(),
                 "[!<Rule> {name: exr, extension: exr, pattern: \"*\", colorspace: doubled}, "
                 "!<Rule> {name: Default");
    const auto config = write_text(temp / "rule.ocio", text).string();
    EXPECT_EQ(conversion_of(config, "", "Linear", "a.exr").input_space(), "doubled");
    EXPECT_EQ(conversion_of(config, "", "Linear", "a.hdr").input_space(), "lin");
    EXPECT_EQ(conversion_of(config, "", "lin", "a.exr").input_space(), "lin");
    EXPECT_TRUE(conversion_of(config, "", "Linear", "a.exr").notes().empty());
}

} // namespace
} // namespace scree::test
