#include "support/color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::test {

namespace {

Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix all{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            for (size_t k = 0; k < 3; ++k)
                all[i][j] += a[i][k] * b[k][j];
    return all;
}

Matrix inverse(const Matrix& m)
{
    Matrix adjugate{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            const size_t r0 = (j + 1) % 3, r1 = (j + 2) % 3, c0 = (i + 1) % 3, c1 = (i + 2) % 3;
            adjugate[i][j] = m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
        }
    const double determinant =
        m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
    for (auto& row : adjugate)
        for (double& value : row)
            value /= determinant;
    return adjugate;
}

Matrix diagonal(const Rgb& d) { return {Rgb{d[0], 0, 0}, Rgb{0, d[1], 0}, Rgb{0, 0, d[2]}}; }

/// XYZ of chromaticity (x, y) at Y = 1.
Rgb xyz(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

Rgb white_of(const Primaries& p) { return xyz(p[6], p[7]); }

/// Columns in proportion to the primaries, scaled so that (1, 1, 1) is white.
Matrix rgb_to_xyz(const Primaries& p)
{
    Matrix columns{};
    for (size_t c = 0; c < 3; ++c) {
        const double x = p[2 * c], y = p[2 * c + 1];
        columns[0][c] = x;
        columns[1][c] = y;
        columns[2][c] = 1 - x - y;
    }
    return product(columns, diagonal(times(inverse(columns), white_of(p))));
}

/// Scales the cone responses of Bradford's matrix from one white to another.
Matrix adaptation(const Rgb& from, const Rgb& to)
{
    const Matrix cones = {Rgb{0.8951, 0.2664, -0.1614}, Rgb{-0.7502, 1.7135, 0.0367},
                          Rgb{0.0389, -0.0685, 1.0296}};
    const Rgb a = times(cones, from), b = times(cones, to);
    return product(inverse(cones),
                   product(diagonal({b[0] / a[0], b[1] / a[1], b[2] / a[2]}), cones));
}

} // namespace

Rgb times(const Matrix& m, const Rgb& v)
{
    Rgb product{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k)
            product[i] += m[i][k] * v[k];
    return product;
}

Matrix rgb_to_rgb(const Primaries& from, const Primaries& to)
{
    return product(inverse(rgb_to_xyz(to)),
                   product(adaptation(white_of(from), white_of(to)), rgb_to_xyz(from)));
}

double linear_of_srgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double srgb_of_linear(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

std::vector<uint8_t> icc_profile(const std::string& description)
{
    std::string bytes;
    auto word = [&](uint32_t value) {
        for (const int shift : {24, 16, 8, 0})
            bytes += static_cast<char>(value >> shift & 0xFF);
    };
    // The 'desc' type: its ASCII string, then empty Unicode and Macintosh ones.
    const auto length = static_cast<uint32_t>(description.size() + 1);
    const uint32_t tag_size = (12 + length + 4 + 4 + 2 + 1 + 67 + 3) / 4 * 4;
    constexpr uint32_t kHeader = 128, kTagTable = 4 + 12;
    const uint32_t size = kHeader + kTagTable + tag_size;

    word(size);
    bytes += "none";
    word(0x02100000); // version 2.1
    bytes += "mntrRGB XYZ ";
    for (const uint32_t date : {0x07E40001U, 0x00010000U, 0U}) // 2020-01-01
        word(date);
    bytes += "acsp";
    bytes.resize(68);
    for (const uint32_t d50 : {0xF6D6U, 0x10000U, 0xD32DU}) // the illuminant that all profiles have
        word(d50);
    bytes.resize(kHeader);

    word(1);
    bytes += "desc";
    word(kHeader + kTagTable);
    word(tag_size);

    bytes += "desc";
    word(0);
    word(length);
    bytes += description;
    bytes.resize(size);
    return {bytes.begin(), bytes.end()};
}

void write_image_with(const std::filesystem::path& file, const Image& image,
                      const std::string& type,
                      const std::function<void(OIIO::ImageSpec&)>& describe)
{
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         OIIO::TypeDesc(type));
    spec.channelnames = image.channels;
    describe(spec);
    auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out) << file << ": " << OIIO::geterror();
    ASSERT_TRUE(out->open(file.string(), spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data())) << out->geterror();
    ASSERT_TRUE(out->close()) << out->geterror();
}

void set_icc_profile(OIIO::ImageSpec& spec, const std::string& description)
{
    const std::vector<uint8_t> bytes = icc_profile(description);
    spec.attribute("ICCProfile",
                   OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(bytes.size())),
                   bytes.data());
}

void set_chromaticities(OIIO::ImageSpec& spec, const Primaries& primaries)
{
    std::array<float, 8> xy{};
    for (size_t i = 0; i < xy.size(); ++i)
        xy[i] = static_cast<float>(primaries[i]);
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xy.data());
}

} // namespace scree::test
