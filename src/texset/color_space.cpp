#include "texset/color_space.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

#include "math/error.h"
#include "texset/builtin_ocio_config.h"

namespace scree {

namespace ocio = OCIO_NAMESPACE;

namespace {

ocio::ConstConfigRcPtr load_config(const std::string& config_file)
{
    const char* from_environment = std::getenv("OCIO");
    std::string source = config_file;
    if (source.empty() && from_environment != nullptr)
        source = from_environment;
    try {
        if (!source.empty())
            return ocio::Config::CreateFromFile(source.c_str());
        std::istringstream text(kBuiltinOcioConfig);
        return ocio::Config::CreateFromStream(text);
    } catch (const ocio::Exception& e) {
        throw Error(fmt::format("{}: cannot be used as an OpenColorIO config ({}): {}", source,
                                config_file.empty() ? "from $OCIO" : "--ocio-config", e.what()));
    }
}

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The config's name for what file metadata call a color space: OpenImageIO writes "sRGB" and
/// "Linear" where configs have many names.
std::string space_from_metadata(const ocio::Config& config, const std::string& metadata)
{
    if (metadata.empty())
        return {};
    if (const auto space = config.getColorSpace(metadata.c_str()))
        return space->getName();
    using Names = std::array<const char*, 6>;
    const std::array<std::pair<const char*, Names>, 2> known = {{
        {"srgb",
         {"srgb_tx", "sRGB - Texture", "Utility - sRGB - Texture", "sRGB", "srgb_texture",
          "Input - Generic - sRGB - Texture"}},
        {"linear",
         {"lin_rec709", "Linear Rec.709 (sRGB)", "Utility - Linear - sRGB", "lin_srgb", "Linear",
          "scene_linear"}},
    }};
    for (const auto& [name, candidates] : known)
        if (lower(metadata) == name)
            for (const char* candidate : candidates)
                if (const auto space = config.getColorSpace(candidate))
                    return space->getName();
    return {};
}

std::string spaces_of(const ocio::Config& config)
{
    std::string names;
    for (int i = 0; i < config.getNumColorSpaces(); ++i)
        names += fmt::format("{}'{}'", i == 0 ? "" : ", ", config.getColorSpaceNameByIndex(i));
    return names;
}

std::string choose_input_space(const ocio::Config& config, const std::string& asked,
                               const std::string& metadata, const std::string& file)
{
    if (!asked.empty()) {
        if (const auto space = config.getColorSpace(asked.c_str()))
            return space->getName();
        throw Error(fmt::format("{}: --color-space '{}' is not in the OpenColorIO config; it has "
                                "{}",
                                file, asked, spaces_of(config)));
    }
    const std::string named = space_from_metadata(config, metadata);
    return named.empty() ? config.getColorSpaceFromFilepath(file.c_str()) : named;
}

} // namespace

struct ColorConversion::Processor {
    ocio::ConstCPUProcessorRcPtr cpu;
};

ColorConversion::ColorConversion(const std::string& config_file, const std::string& input_space,
                                 const std::string& file_metadata, const std::string& file)
    : processor_(std::make_unique<Processor>())
{
    const auto config = load_config(config_file);
    const auto working = config->getColorSpace(ocio::ROLE_SCENE_LINEAR);
    if (!working)
        throw Error(fmt::format("{}: the OpenColorIO config has no role '{}', which names the "
                                "space colors are averaged in",
                                config_file, ocio::ROLE_SCENE_LINEAR));
    working_space_ = working->getName();
    input_space_ = choose_input_space(*config, input_space, file_metadata, file);
    try {
        // Lossless: nothing approximated for speed, whatever a version's default allows.
        processor_->cpu = config->getProcessor(input_space_.c_str(), working_space_.c_str())
                              ->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    } catch (const ocio::Exception& e) {
        throw Error(fmt::format("{}: no conversion from '{}' to '{}': {}", file, input_space_,
                                working_space_, e.what()));
    }
}

ColorConversion::~ColorConversion() = default;
ColorConversion::ColorConversion(ColorConversion&&) noexcept = default;
ColorConversion& ColorConversion::operator=(ColorConversion&&) noexcept = default;

void ColorConversion::apply(float* rgb, long pixels) const
{
    if (processor_->cpu->isNoOp() || pixels == 0)
        return;
    ocio::PackedImageDesc image(rgb, pixels, 1, 3);
    processor_->cpu->apply(image);
}

} // namespace scree
