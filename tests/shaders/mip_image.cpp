#include "shaders/mip_image.h"

#include <gtest/gtest.h>

namespace scree::test {

void write_mip_image(const std::filesystem::path& file, const std::vector<Image>& levels,
                     const std::function<void(OIIO::ImageSpec&)>& describe)
{
    auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out) << file << ": " << OIIO::geterror();
    for (size_t l = 0; l < levels.size(); ++l) {
        const Image& level = levels[l];
        OIIO::ImageSpec spec(level.width, level.height, static_cast<int>(level.channels.size()),
                             OIIO::TypeDesc::FLOAT);
        spec.channelnames = level.channels;
        spec.tile_width = spec.tile_height = 64;
        spec.attribute("textureformat", "Plain Texture"); // else OpenImageIO writes no levels
        spec.attribute("wrapmodes", "periodic,periodic");
        describe(spec);
        ASSERT_TRUE(
            out->open(file.string(), spec,
                      l == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel))
            << out->geterror();
        ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, level.pixels.data()))
            << out->geterror();
    }
    ASSERT_TRUE(out->close()) << out->geterror();
}

} // namespace scree::test
