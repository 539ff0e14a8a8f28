#include "texset/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "math/error.h"
#include "texset/writable.h"

namespace scree {

namespace {

/// IEC 61966-2-1; v in [0, 1].
float srgb_of_linear(float v)
{
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
}

std::vector<uint8_t> srgb_bytes(const Picture& picture)
{
    constexpr uint8_t kMagenta[3] = {255, 0, 255};
    std::vector<uint8_t> bytes(picture.rgb.size());
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const float* rgb = &picture.rgb[i];
        const bool is_number = !std::isnan(rgb[0]) && !std::isnan(rgb[1]) && !std::isnan(rgb[2]);
        for (size_t c = 0; c < 3; ++c)
            bytes[i + c] = is_number ? static_cast<uint8_t>(std::lround(
                                           255 * srgb_of_linear(std::clamp(rgb[c], 0.0F, 1.0F))))
                                     : kMagenta[c];
    }
    return bytes;
}

OIIO::ImageSpec spec_of(const Picture& picture, OIIO::TypeDesc::BASETYPE type)
{
    OIIO::ImageSpec spec(picture.width, picture.height, 3, type);
    spec.attribute("DateTime", ""); // else OpenImageIO writes the time: equal pictures, other bytes
    return spec;
}

std::string lower_case_ending(const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

OIIO::ImageSpec srgb_spec(const Picture& picture, const std::string& ending)
{
    OIIO::ImageSpec spec = spec_of(picture, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (ending == ".jpg" || ending == ".jpeg") { // TIFF would take it as a wish too
        spec.attribute("Compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    return spec;
}

bool write_pixels(OIIO::ImageOutput& out, const Picture& picture, bool as_light)
{
    return as_light ? out.write_image(OIIO::TypeDesc::FLOAT, picture.rgb.data())
                    : out.write_image(OIIO::TypeDesc::UINT8, srgb_bytes(picture).data());
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why)
{
    throw Error(fmt::format("{}: cannot be written: {}", file.string(), why));
}

/// Removes a file unless it was renamed.
struct PartialFile {
    std::filesystem::path path;

    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    ~PartialFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

} // namespace

void check_picture_name(const std::filesystem::path& file)
{
    expect_writable(file);
    if (!OIIO::ImageOutput::create(file.string())) {
        OIIO::geterror(); // said better here
        refuse(file, "no picture format has this ending; use .png, .jpg or .exr");
    }
}

double fitting_exposure(std::vector<float> values)
{
    if (values.empty())
        return 1;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 98 / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at > 0 ? 0.8 / static_cast<double>(*at) : 1;
}

std::vector<uint8_t> png_bytes(const Picture& picture)
{
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto out = OIIO::ImageOutput::create("png");
    if (!out || !out->set_ioproxy(&memory) ||
        !out->open("picture.png", srgb_spec(picture, ".png")) ||
        !write_pixels(*out, picture, false) || !out->close())
        throw Error(fmt::format("a {}x{} picture cannot be made into a PNG: {}", picture.width,
                                picture.height, out ? out->geterror() : OIIO::geterror()));
    return bytes;
}

void write_picture(const Picture& picture, const std::filesystem::path& file)
{
    check_picture_name(file);
    const std::filesystem::path target = file_to_replace(file);
    const std::string ending = lower_case_ending(file);
    const PartialFile partial{target.parent_path() / fmt::format(".{}.scree-{}{}",
                                                                 target.stem().string(), getpid(),
                                                                 ending)};
    auto fail = [&](std::string why) {
        const size_t at = why.find(partial.path.string());
        if (at != std::string::npos)
            why.replace(at, partial.path.string().size(), file.string());
        refuse(file, why);
    };
    const auto out = OIIO::ImageOutput::create(partial.path.string());
    const bool as_light = ending == ".exr" || ending == ".hdr";
    const OIIO::ImageSpec spec =
        as_light ? spec_of(picture, OIIO::TypeDesc::FLOAT) : srgb_spec(picture, ending);
    if (!out->open(partial.path.string(), spec) || !write_pixels(*out, picture, as_light) ||
        !out->close())
        fail(out->geterror());
    std::error_code failed;
    std::filesystem::rename(partial.path, target, failed);
    if (failed)
        fail(failed.message());
}

} // namespace scree
