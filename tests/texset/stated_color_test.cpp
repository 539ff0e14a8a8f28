// What a header says of its colors, and what image files of many kinds say.

#include "texset/stated_color.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <limits>

#include "support/color.h"
#include "support/files.h"
#include "texset/image_rows.h"

namespace scree::test {
namespace {

std::array<float, 8> in_float(const Primaries& primaries, double off = 0)
{
    std::array<float, 8> xy{};
    for (size_t i = 0; i < 8; ++i)
        xy[i] = static_cast<float>(primaries[i] + off);
    return xy;
}

const std::pair<const char*, Primaries> kSpaces[] = {{"lin_rec709", kRec709},
                                                     {"lin_rec2020", kRec2020},
                                                     {"lin_p3d65", kP3D65},
                                                     {"ACES2065-1", kAp0},
                                                     {"ACEScg", kAp1}};

TEST(StatedColor, KnownPrimariesNameTheirSpaceWithinAThousandth)
{
    for (const auto& [name, primaries] : kSpaces) {
        ColorHeader header;
        header.space = "Linear";
        for (const double off : {0.0, 0.0009, -0.0009}) {
            header.chromaticities = in_float(primaries, off);
            EXPECT_EQ(stated_color(header).space, name) << off;
            EXPECT_EQ(stated_color(header).fallback, "Linear"); // light, of some primaries
        }
        for (size_t i = 0; i < 8; ++i) { // each coordinate counts, those of white too
            header.chromaticities = in_float(primaries);
            (*header.chromaticities)[i] += 0.002F;
            EXPECT_EQ(stated_color(header).space.rfind("primaries (", 0), 0U) << name << " " << i;
            EXPECT_EQ(stated_color(header).fallback, "Linear"); // light, of some primaries
        }
    }
    ColorHeader nonsense;
    nonsense.chromaticities.emplace();
    nonsense.chromaticities->fill(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(stated_color(nonsense).space.rfind("primaries (nan", 0), 0U);
}

TEST(StatedColor, AnAcesContainerIsAp0UnlessItsPrimariesSayOtherwise)
{
    ColorHeader header;
    header.space = "Linear";
    header.aces_container = true;
    EXPECT_EQ(stated_color(header).space, "ACES2065-1");
    header.chromaticities = in_float(kAp1);
    EXPECT_EQ(stated_color(header).space, "ACEScg");
}

TEST(StatedColor, AProfileGoesBeforeTheFormatsHabit)
{
    for (const auto& [profile, space, fallback] :
         {std::tuple("sRGB IEC61966-2.1", "sRGB", ""),
          {"Artifex Software SRGB ICC Profile", "sRGB", ""},
          {"Linear sRGB", "Linear sRGB", "Gamma2.2"},
          {"Display P3", "Display P3", "Gamma2.2"},
          {"", "unnamed ICC profile", "Gamma2.2"}}) {
        ColorHeader header;
        header.space = "Gamma2.2";
        header.icc_profile = profile;
        EXPECT_EQ(stated_color(header).space, space);
        EXPECT_EQ(stated_color(header).fallback, fallback);
    }
}

TEST(StatedColor, OpenImageIosWordStandsWhereThereIsNothingElse)
{
    for (const auto& [word, fallback] : {std::pair("sRGB", ""),
                                         {"Linear", ""},
                                         {"Gamma2.2", "sRGB"},
                                         {"Gamma1.8", ""},
                                         {"", ""}}) {
        ColorHeader header;
        header.space = word;
        EXPECT_EQ(stated_color(header).space, word);
        EXPECT_EQ(stated_color(header).fallback, fallback);
    }
}

TEST(StatedColor, BytesOfAFileDoNotReachMessagesUnseen)
{
    ColorHeader header;
    header.icc_profile = std::string("Profil g\xe9n\xe9rique\n\x1b[2J\0rest", 26);
    EXPECT_EQ(stated_color(header).space, "Profil g?n?rique??[2J");
    header.icc_profile = std::string(100000, 'x');
    EXPECT_EQ(stated_color(header).space, std::string(80, 'x'));
}

// --- files ---------------------------------------------------------------------------------------

using Describe = std::function<void(OIIO::ImageSpec&)>;

Describe profile(const std::string& description)
{
    return [description](OIIO::ImageSpec& spec) { set_icc_profile(spec, description); };
}

Describe space(const std::string& name)
{
    return [name](OIIO::ImageSpec& spec) { spec.attribute("oiio:ColorSpace", name); };
}

std::string big_endian(uint32_t value)
{
    std::string bytes;
    for (const int shift : {24, 16, 8, 0})
        bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data)
{
    const std::string body = type + data;
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(static_cast<uint32_t>(data.size())) + body +
           big_endian(static_cast<uint32_t>(crc));
}

// By hand, since OpenImageIO writes a text chunk that says the same and goes before the others.
TEST(StatedColor, IsReadFromThePngChunksThatOtherProgramsWrite)
{
    TempFolder temp;
    const std::string row = {0, 100, 50, 25}; // filter, R, G, B
    std::string packed(64, '\0');
    uLongf size = packed.size();
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                       reinterpret_cast<const Bytef*>(row.data()), row.size()),
              Z_OK);
    const std::string rgb_of_8_bits = {8, 2, 0, 0, 0};
    const std::string gamma_22 = chunk("gAMA", big_endian(45455));
    for (const auto& [chunks, space, fallback] :
         {std::tuple(std::string(), "sRGB", ""),
          {chunk("sRGB", std::string(1, '\0')), "sRGB", ""},
          {chunk("sRGB", std::string(1, '\0')) + gamma_22, "sRGB", ""},
          {gamma_22, "Gamma2.2", "sRGB"},
          {chunk("gAMA", big_endian(55556)), "Gamma1.8", ""},
          {chunk("gAMA", big_endian(100000)), "linear", ""}}) {
        std::ofstream(temp / "a.png", std::ios::binary)
            << "\x89PNG\r\n\x1a\n"
            << chunk("IHDR", big_endian(1) + big_endian(1) + rgb_of_8_bits) << chunks
            << chunk("IDAT", packed.substr(0, size)) << chunk("IEND", "");
        const ImageInfo info = ImageRows(temp / "a.png").info();
        EXPECT_EQ(info.color_space, space);
        EXPECT_EQ(info.color_fallback, fallback) << space;
    }
}

TEST(StatedColor, IsReadFromFilesOfManyKinds)
{
    TempFolder temp;
    const Image image{2, 1, {"R", "G", "B"}, {0.2F, 0.4F, 0.6F, 0.8F, 0.1F, 0.3F}};
    const Describe nothing = [](OIIO::ImageSpec&) {};
    struct Case {
        const char *name, *type;
        Describe describe;
        const char *space, *fallback;
    };
    std::vector<Case> cases = {
        {"a.png", "uint8", nothing, "sRGB", ""},
        {"a.png", "uint8", space("ACEScg"), "ACEScg", ""}, // a text chunk of OpenImageIO's
        {"a.png", "uint8", profile("sRGB IEC61966-2.1"), "sRGB", ""},
        {"a.png", "uint16", profile("Display P3"), "Display P3", "sRGB"},
        {"a.jpg", "uint8", nothing, "sRGB", ""},
        {"a.jpg", "uint8", profile("Adobe RGB (1998)"), "Adobe RGB (1998)", "sRGB"},
        {"a.tif", "uint8", nothing, "", ""},
        {"a.tif", "uint16", profile("sRGB built-in"), "sRGB", ""},
        {"a.tif", "uint16", profile("ProPhoto RGB"), "ProPhoto RGB", ""},
        {"a.hdr", "float", nothing, "linear", ""},
        {"a.exr", "half", nothing, "Linear", ""},
    };
    for (const auto& [name, primaries] : kSpaces) {
        const auto xy = primaries;
        cases.push_back({"a.exr", "half",
                         [xy](OIIO::ImageSpec& spec) { set_chromaticities(spec, xy); }, name,
                         "Linear"});
    }
    cases.push_back({"a.exr", "half",
                     [](OIIO::ImageSpec& spec) { spec.attribute("acesImageContainerFlag", 1); },
                     "ACES2065-1", ""});
    for (const auto& [name, type, describe, stated, fallback] : cases) {
        write_image_with(temp / name, image, type, describe);
        const ImageInfo info = ImageRows(temp / name).info();
        EXPECT_EQ(info.color_space, stated) << name;
        EXPECT_EQ(info.color_fallback, fallback) << name << ", " << stated;
        EXPECT_TRUE(info.notes.empty()) << name;
    }
}

} // namespace
} // namespace scree::test
