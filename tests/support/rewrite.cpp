#include "support/rewrite.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <vector>

namespace scree::test {

void rewrite_texture(const std::filesystem::path& file, int level, int x, int y, int channel,
                     const std::function<float(float)>& change)
{
    const std::string name = file.string();
    auto check = [&name](bool good) {
        if (!good)
            throw std::runtime_error(name + ": " + OIIO::geterror());
    };
    std::vector<OIIO::ImageSpec> specs;
    std::vector<std::vector<float>> levels;
    auto input = OIIO::ImageInput::open(name);
    check(input != nullptr);
    for (int l = 0; input->seek_subimage(0, l); ++l) {
        const OIIO::ImageSpec& spec = specs.emplace_back(input->spec());
        levels.emplace_back(static_cast<size_t>(spec.image_pixels()) *
                            static_cast<size_t>(spec.nchannels));
        check(input->read_image(0, l, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                levels.back().data()));
    }
    input->close();

    const OIIO::ImageSpec& spec = specs.at(static_cast<size_t>(level));
    float& number = levels[static_cast<size_t>(level)].at(
        (static_cast<size_t>(y) * static_cast<size_t>(spec.width) + static_cast<size_t>(x)) *
            static_cast<size_t>(spec.nchannels) +
        static_cast<size_t>(channel));
    number = change(number);

    auto output = OIIO::ImageOutput::create(name);
    check(output != nullptr);
    for (size_t l = 0; l < specs.size(); ++l) {
        check(output->open(name, specs[l],
                           l == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel));
        check(output->write_image(OIIO::TypeDesc::FLOAT, levels[l].data()));
    }
    check(output->close());
}

} // namespace scree::test
