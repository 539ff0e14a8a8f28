#include "texset/mip_reader.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "texset/readable.h"

namespace scree {

struct MipReader::Input {
    std::filesystem::path path;
    std::unique_ptr<OIIO::ImageInput> file;
    std::vector<OIIO::ImageSpec> levels;

    [[nodiscard]] const OIIO::ImageSpec& spec(int level) const
    {
        return levels.at(static_cast<size_t>(level));
    }
};

MipReader::MipReader(const std::filesystem::path& file) : input_(std::make_unique<Input>())
{
    expect_readable(file, "a texture of a set");
    input_->path = file;
    input_->file = OIIO::ImageInput::open(file.string());
    if (!input_->file)
        throw Error(
            fmt::format("{}: cannot be read as an image: {}", file.string(), OIIO::geterror()));
    for (int level = 0; input_->file->seek_subimage(0, level); ++level)
        input_->levels.push_back(input_->file->spec());
}

MipReader::~MipReader() = default;
MipReader::MipReader(MipReader&&) noexcept = default;

int MipReader::levels() const { return static_cast<int>(input_->levels.size()); }
int MipReader::width(int level) const { return input_->spec(level).width; }
int MipReader::height(int level) const { return input_->spec(level).height; }

const std::vector<std::string>& MipReader::channels() const { return input_->spec(0).channelnames; }

std::vector<float> MipReader::rows(int level, int first, int count)
{
    const OIIO::ImageSpec& spec = input_->spec(level);
    const auto stride = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.nchannels);
    // OpenImageIO reads whole tiles.
    const int step = std::max(spec.tile_height, 1);
    const int begin = first - first % step;
    const int end = std::min((first + count + step - 1) / step * step, spec.height);
    std::vector<float> pixels(stride * static_cast<size_t>(end - begin));
    OIIO::ImageInput& file = *input_->file;
    const bool is_read = spec.tile_height > 0
                             ? file.read_tiles(0, level, 0, spec.width, begin, end, 0, 1, 0,
                                               spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())
                             : file.read_scanlines(0, level, begin, end, 0, 0, spec.nchannels,
                                                   OIIO::TypeDesc::FLOAT, pixels.data());
    if (!is_read)
        throw Error(fmt::format("{}: level {} cannot be read: {}; the file is damaged, bake the "
                                "set again",
                                input_->path.string(), level, file.geterror()));
    pixels.erase(pixels.begin(),
                 pixels.begin() + static_cast<std::ptrdiff_t>(stride) * (first - begin));
    pixels.resize(stride * static_cast<size_t>(count));
    return pixels;
}

} // namespace scree
