#include "support/files.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace scree::test {

namespace fs = std::filesystem;

TempFolder::TempFolder()
{
    std::string name = (fs::temp_directory_path() / "scree-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
}

TempFolder::~TempFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void write_image(const fs::path& file, const Image& image, const std::string& type)
{
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         OIIO::TypeDesc(type));
    spec.channelnames = image.channels;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out) << file << ": " << OIIO::geterror();
    ASSERT_TRUE(out->open(file.string(), spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data())) << out->geterror();
    ASSERT_TRUE(out->close()) << out->geterror();
}

std::vector<Image> read_levels(const fs::path& file)
{
    std::vector<Image> levels;
    auto in = OIIO::ImageInput::open(file.string());
    if (!in) {
        ADD_FAILURE() << file << ": " << OIIO::geterror();
        return levels;
    }
    for (int level = 0; in->seek_subimage(0, level); ++level) {
        const OIIO::ImageSpec spec = in->spec();
        Image image{spec.width, spec.height, spec.channelnames, {}};
        image.pixels.resize(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                            static_cast<size_t>(spec.nchannels));
        if (!in->read_image(0, level, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                            image.pixels.data())) {
            ADD_FAILURE() << file << " level " << level << ": " << in->geterror();
            return levels;
        }
        levels.push_back(std::move(image));
    }
    return levels;
}

std::string read_bytes(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

fs::path data_folder()
{
    const fs::path folder = SCREE_TEST_DATA;
    return fs::is_directory(folder) ? folder : fs::path();
}

} // namespace scree::test
