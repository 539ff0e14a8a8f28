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
    if (input_->levels.empty() || input_->spec(0).tile_width <= 0)
        throw Error(fmt::format("{}: is not tiled, so not a texture of a set; bake the set again",
                                file.string()));
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
    // OpenImageIO reads whole tiles.
    const int begin = first - first % spec.tile_height;
    const int end = std::min(
        (first + count + spec.tile_height - 1) / spec.tile_height * spec.tile_height, spec.height);
    const auto stride = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.nchannels);
    std::vector<float> pixels(stride * static_cast<size_t>(end - begin));
    if (!input_->file->read_tiles(0, level, 0, spec.width, begin, end, 0, 1, 0, spec.nchannels,
                                  OIIO::TypeDesc::FLOAT, pixels.data()))
        throw Error(fmt::format("{}: level {} cannot be read: {}; the file is damaged, bake the "
                                "set again",
                                input_->path.string(), level, input_->file->geterror()));
    pixels.erase(pixels.begin(),
                 pixels.begin() + static_cast<std::ptrdiff_t>(stride) * (first - begin));
    pixels.resize(stride * static_cast<size_t>(count));
    return pixels;
}

} // namespace scree
