#include "texset/image_rows.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>
#include <utility>

#include "math/error.h"
#include "texset/readable.h"
#include "texset/stated_color.h"

namespace scree {

namespace fs = std::filesystem;

namespace {

constexpr int kStripRows = 64;

/// Nothing compresses pixels better than this: deflate reaches 1032 : 1 and run lengths less.
/// A header that claims more is damaged or hostile, and would cost its claim in memory.
constexpr double kMostBytesAPerByte = 20000;
/// Smaller claims are harmless, whatever the file's size.
constexpr double kHarmlessBytes = 64e6;

/// Wider rows than this are no texture; they are a broken header.
constexpr int kWidestImage = 1 << 20;

std::string join(const std::vector<std::string>& words)
{
    std::string joined;
    for (const auto& word : words)
        joined += (joined.empty() ? "" : ",") + word;
    return joined;
}

/// OpenImageIO's reason, without its trailing line break.
std::string reason(std::string words)
{
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back())) != 0)
        words.pop_back();
    std::replace(words.begin(), words.end(), '\n', ' ');
    return words.empty() ? "unknown reason" : words;
}

void expect_sane(const OIIO::ImageSpec& spec, const fs::path& path)
{
    const auto name = path.string();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        throw Error(fmt::format("{}: the image is {}x{} with {} channels; nothing to bake", name,
                                spec.width, spec.height, spec.nchannels));
    // OpenImageIO 2.4 divides by it when it reads scan lines, of any format.
    if (spec.get_int_attribute("tiff:RowsPerStrip", 1) < 1)
        throw Error(fmt::format("{}: strips of {} rows; the file is damaged", name,
                                spec.get_int_attribute("tiff:RowsPerStrip")));
    if (spec.deep)
        throw Error(fmt::format("{}: deep pixels; flatten the image first", name));
    if (spec.depth > 1)
        throw Error(fmt::format("{}: a volume of {} slices; expected an image", name, spec.depth));
    const double claimed = static_cast<double>(spec.width) * spec.height * spec.nchannels *
                           static_cast<double>(spec.format.size());
    std::error_code failed;
    const auto file_bytes = static_cast<double>(fs::file_size(path, failed));
    const bool incredible =
        !failed && claimed > kHarmlessBytes && claimed > file_bytes * kMostBytesAPerByte;
    if (spec.width > kWidestImage || spec.height > kWidestImage || incredible)
        throw Error(fmt::format("{}: the header claims {}x{} pixels, {} channels, in a file of {} "
                                "bytes; the file is damaged",
                                name, spec.width, spec.height, spec.nchannels, file_bytes));
}

int bits_of_integer(const OIIO::TypeDesc& type)
{
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return 8;
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return 16;
    case OIIO::TypeDesc::UINT32:
    case OIIO::TypeDesc::INT32:
        return 32;
    default:
        return 0;
    }
}

/// OpenImageIO 2.4 loses the errors of damaged TIFF strips and tiles when it decompresses them by
/// itself, several at a time, and gives whatever is in memory; read singly it reports them.
bool is_tiff(const OIIO::ImageInput& file) { return std::string(file.format_name()) == "tiff"; }

/// Whether color is multiplied by alpha in what OpenImageIO gives. Where the format fixes it,
/// OpenImageIO 2.4 leaves "oiio:UnassociatedAlpha" out although it hands straight color on.
bool is_premultiplied(const OIIO::ImageSpec& spec, const std::string& format)
{
    if (spec.alpha_channel < 0 || spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0)
        return false;
    if (format == "targa") {
        constexpr int kPremultiplied = 4; // attributes type of the TGA 2.0 extension area
        return spec.get_int_attribute("targa:alpha_type") == kPremultiplied;
    }
    const auto straight = {"bmp", "dds", "ico", "jpeg2000"};
    return std::find(straight.begin(), straight.end(), format) == straight.end();
}

ColorHeader color_header(const OIIO::ImageSpec& spec)
{
    ColorHeader header;
    header.space = spec.get_string_attribute("oiio:ColorSpace");
    if (spec.find_attribute("ICCProfile") != nullptr)
        header.icc_profile = spec.get_string_attribute("ICCProfile:profile_description");
    std::array<float, 8> xy{};
    if (spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xy.data()))
        header.chromaticities = xy;
    header.aces_container = spec.get_int_attribute("acesImageContainerFlag") == 1;
    return header;
}

ImageInfo info_of(const OIIO::ImageSpec& spec, const std::string& format, const fs::path& path)
{
    ImageInfo info;
    info.path = path.string();
    info.width = spec.width;
    info.height = spec.height;
    info.channels = spec.channelnames;
    info.type = spec.format.c_str();
    info.integer_bits = bits_of_integer(spec.format);
    if (info.integer_bits != 0) { // fewer bits in the file than in memory, such as a 4-bit palette
        const int file_bits = spec.get_int_attribute("oiio:BitsPerSample", info.integer_bits);
        info.integer_bits = std::min(info.integer_bits, std::max(1, file_bits));
    }
    info.alpha_channel = spec.alpha_channel;
    info.premultiplied = is_premultiplied(spec, format);
    StatedColor color = stated_color(color_header(spec));
    info.color_space = std::move(color.space);
    info.color_fallback = std::move(color.fallback);
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        info.notes.push_back(fmt::format(
            "{}: the data window is {}x{} at ({}, {}) in a display window of {}x{} at ({}, {}); "
            "the data window is baked as the whole map",
            info.path, spec.width, spec.height, spec.x, spec.y, spec.full_width, spec.full_height,
            spec.full_x, spec.full_y));
    return info;
}

} // namespace

struct ImageRows::Input {
    std::unique_ptr<OIIO::ImageInput> file;
    OIIO::ImageSpec spec;
};

ImageRows::ImageRows(const fs::path& path) : input_(std::make_unique<Input>())
{
    expect_readable(path, "an image");
    OIIO::ImageSpec keep_unassociated;
    keep_unassociated.attribute("oiio:UnassociatedAlpha", 1);
    input_->file = OIIO::ImageInput::open(path.string(), &keep_unassociated);
    if (!input_->file)
        throw Error(fmt::format("{}: cannot be read as an image: {}", path.string(),
                                reason(OIIO::geterror())));
    input_->spec = input_->file->spec();
    expect_sane(input_->spec, path);
    if (is_tiff(*input_->file))
        input_->file->threads(1);
    info_ = info_of(input_->spec, input_->file->format_name(), path);
    if (input_->file->seek_subimage(1, 0))
        info_.notes.push_back(
            fmt::format("{}: has several parts; the first is baked", path.string()));
    if (!input_->file->seek_subimage(0, 0))
        throw Error(
            fmt::format("{}: cannot be read: {}", path.string(), reason(input_->file->geterror())));
    input_->file->geterror(); // clear what the look for a second part left
}

ImageRows::~ImageRows() = default;
ImageRows::ImageRows(ImageRows&&) noexcept = default;
ImageRows& ImageRows::operator=(ImageRows&&) noexcept = default;

bool ImageRows::read_one_by_one(int y0, int y1, int first_channel, int end_channel)
{
    const OIIO::ImageSpec& spec = input_->spec;
    const auto all = static_cast<size_t>(spec.nchannels);
    const auto wanted = static_cast<ptrdiff_t>(end_channel - first_channel);
    std::vector<float> row(static_cast<size_t>(spec.width) * all);
    float* to = strip_.data();
    for (int y = y0; y < y1; ++y) {
        if (!input_->file->read_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data()))
            return false;
        for (size_t at = static_cast<size_t>(first_channel); at < row.size(); at += all)
            to = std::copy_n(&row[at], wanted, to);
    }
    return true;
}

void ImageRows::fill_strip(int first_channel, int end_channel)
{
    const OIIO::ImageSpec& spec = input_->spec;
    const int rows = spec.tile_height > 0 ? spec.tile_height : kStripRows;
    strip_begin_ = next_row_;
    strip_end_ = std::min(next_row_ - next_row_ % rows + rows, spec.height);
    const auto channels = static_cast<size_t>(end_channel - first_channel);
    strip_.resize(static_cast<size_t>(strip_end_ - strip_begin_) * static_cast<size_t>(spec.width) *
                  channels);

    const int y0 = spec.y + strip_begin_, y1 = spec.y + strip_end_;
    bool read = false;
    if (spec.tile_width > 0)
        read = input_->file->read_tiles(0, 0, spec.x, spec.x + spec.width, y0, y1, spec.z,
                                        spec.z + 1, first_channel, end_channel,
                                        OIIO::TypeDesc::FLOAT, strip_.data());
    else if (is_tiff(*input_->file))
        read = read_one_by_one(y0, y1, first_channel, end_channel);
    else
        read = input_->file->read_scanlines(0, 0, y0, y1, 0, first_channel, end_channel,
                                            OIIO::TypeDesc::FLOAT, strip_.data());
    // Some readers return true and leave just a message.
    if (!read || input_->file->has_error())
        throw Error(fmt::format("{}: rows {} to {} cannot be read; the file is damaged or cut "
                                "short: {}",
                                info_.path, strip_begin_, strip_end_ - 1,
                                reason(input_->file->geterror())));
}

void ImageRows::next(int count, const std::vector<int>& channels, float* pixels)
{
    const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
    const int stride = *last + 1 - *first;
    for (int row = 0; row < count; ++row, ++next_row_) {
        if (next_row_ >= strip_end_)
            fill_strip(*first, *last + 1);
        const float* from =
            strip_.data() + static_cast<ptrdiff_t>(next_row_ - strip_begin_) * info_.width * stride;
        if (stride == static_cast<int>(channels.size()) &&
            std::is_sorted(channels.begin(), channels.end())) {
            pixels = std::copy_n(from, static_cast<ptrdiff_t>(info_.width) * stride, pixels);
            continue;
        }
        for (int x = 0; x < info_.width; ++x, from += stride)
            for (const int channel : channels)
                *pixels++ = from[channel - *first];
    }
}

void ImageRows::release()
{
    input_.reset();
    strip_ = {};
}

int channel_index(const ImageInfo& info, const std::string& name_or_number,
                  const std::string& option)
{
    const auto found = std::find(info.channels.begin(), info.channels.end(), name_or_number);
    if (found != info.channels.end())
        return static_cast<int>(found - info.channels.begin());
    const bool is_number = !name_or_number.empty() && name_or_number.size() < 6 &&
                           std::all_of(name_or_number.begin(), name_or_number.end(),
                                       [](unsigned char c) { return std::isdigit(c) != 0; });
    if (is_number && std::stoul(name_or_number) < info.channels.size())
        return std::stoi(name_or_number);
    throw Error(fmt::format("{}: no channel '{}'; it has {}; name one of them with {}", info.path,
                            name_or_number, join(info.channels), option));
}

std::string describe(const ImageInfo& info)
{
    return fmt::format("{}x{}, channels {}", info.width, info.height, join(info.channels));
}

} // namespace scree
