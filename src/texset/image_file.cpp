#include "texset/image_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "math/error.h"

namespace scree {

namespace {

void set(OIIO::ImageSpec& spec, const std::string& name, const std::string& value)
{
    spec.attribute(name, value);
}

void set(OIIO::ImageSpec& spec, const std::string& name, int value) { spec.attribute(name, value); }

void set(OIIO::ImageSpec& spec, const std::string& name, float value)
{
    spec.attribute(name, value);
}

void set(OIIO::ImageSpec& spec, const std::string& name, double value)
{
    spec.attribute(name, OIIO::TypeDesc::DOUBLE, &value);
}

} // namespace

struct ImageFile::Output {
    std::unique_ptr<OIIO::ImageOutput> file;
};

ImageFile::ImageFile(std::filesystem::path path, int width, int height,
                     const std::vector<std::string>& channels, const Attributes& attributes)
    : path_(std::move(path)),
      partial_(path_.parent_path() /
               fmt::format(".{}.scree-{}.exr", path_.filename().string(), getpid())),
      output_(std::make_unique<Output>())
{
    OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = channels;
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", ""); // else OpenImageIO writes the time: equal images, other bytes
    for (const auto& attribute : attributes)
        std::visit([&spec, &name = attribute.first](const auto& value) { set(spec, name, value); },
                   attribute.second);
    output_->file = OIIO::ImageOutput::create(partial_.string());
    if (!output_->file)
        throw Error(fmt::format("{}: cannot be written: {}", path_.string(), OIIO::geterror()));
    if (!output_->file->open(partial_.string(), spec))
        throw Error(
            fmt::format("{}: cannot be written: {}", path_.string(), output_->file->geterror()));
}

ImageFile::~ImageFile()
{
    output_->file.reset();
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
}

void ImageFile::write_row(const float* pixels)
{
    if (!output_->file->write_scanline(next_row_++, 0, OIIO::TypeDesc::FLOAT, pixels))
        throw Error(
            fmt::format("{}: cannot be written: {}", path_.string(), output_->file->geterror()));
}

void ImageFile::close()
{
    std::error_code failed;
    if (!output_->file->close())
        throw Error(
            fmt::format("{}: cannot be written: {}", path_.string(), output_->file->geterror()));
    std::filesystem::rename(partial_, path_, failed);
    if (failed)
        throw Error(fmt::format("{}: cannot be written: {}", path_.string(), failed.message()));
}

} // namespace scree
