#include "texset/color_space.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
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

/// Names that one space goes by in configs and in headers, those of the ACES configs first.
const std::vector<std::vector<const char*>>& synonyms()
{
    static const std::vector<std::vector<const char*>> all = {
        {"srgb_tx", "sRGB - Texture", "Utility - sRGB - Texture", "sRGB", "srgb_texture",
         "Input - Generic - sRGB - Texture"},
        {"lin_rec709", "Linear Rec.709 (sRGB)", "Utility - Linear - Rec.709",
         "Utility - Linear - sRGB", "lin_srgb", "lin_rec709_srgb", "Linear Rec.709",
         "scene-linear Rec.709-sRGB", "Linear"},
        {"ACEScg", "lin_ap1", "ACES - ACEScg"},
        {"ACES2065-1", "aces_ap0", "lin_ap0", "aces2065_1", "ACES - ACES2065-1"},
        {"lin_rec2020", "Linear Rec.2020", "Utility - Linear - Rec.2020"},
        {"lin_p3d65", "Linear P3-D65", "Utility - Linear - P3-D65", "Linear DCI-P3 D65"},
        {"Gamma1.8", "g18_rec709_tx", "g18_rec709", "Utility - Gamma 1.8 - Rec.709 - Texture"},
        {"Gamma2.2", "g22_rec709_tx", "g22_rec709", "Utility - Gamma 2.2 - Rec.709 - Texture"},
        {"Gamma2.4", "g24_rec709_tx", "g24_rec709", "Utility - Gamma 2.4 - Rec.709 - Texture"},
    };
    return all;
}

bool is_just_linear(const std::string& stated) { return lower(stated) == "linear"; }

/// The config's name for a space that a header names; empty where the config has none.
std::string find_stated(const ocio::Config& config, const std::string& stated)
{
    if (stated.empty())
        return {};
    if (const auto space = config.getColorSpace(stated.c_str()))
        return space->getName();
    const auto same = [&](const char* name) { return lower(name) == lower(stated); };
    for (const auto& names : synonyms())
        if (std::any_of(names.begin(), names.end(), same))
            for (const char* name : names)
                if (const auto space = config.getColorSpace(name))
                    return space->getName();
    const auto linear = config.getColorSpace(ocio::ROLE_SCENE_LINEAR);
    return linear && is_just_linear(stated) ? linear->getName() : "";
}

/// Whether numbers of the space are proportional to light in the scene, as far as can be told.
bool is_scene_linear(const ocio::ConstConfigRcPtr& config, const ocio::ConstColorSpaceRcPtr& space)
{
    if (space->isData() || space->getReferenceSpaceType() != ocio::REFERENCE_SPACE_SCENE)
        return false;
    const std::string encoding = space->getEncoding();
    if (!encoding.empty())
        return encoding == "scene-linear";
    // Configs leave encodings out (the ACES CG config that of "sRGB - Texture"): ask the numbers.
    const auto linear = config->getColorSpace(ocio::ROLE_SCENE_LINEAR);
    if (!linear)
        return true;
    std::array<float, 6> light = {0.25F, 0.25F, 0.25F, 0.5F, 0.5F, 0.5F};
    ocio::PackedImageDesc pixels(light.data(), 2, 1, 3);
    try {
        config->getProcessor(space->getName(), linear->getName())
            ->getDefaultCPUProcessor()
            ->apply(pixels);
    } catch (const ocio::Exception&) {
        return true; // a file of the config is missing: the conversion itself will say so
    }
    constexpr float kFloatSums = 1e-4F; // of matrix rows, relative; no encoding comes near it
    return std::abs(light[4] - 2 * light[1]) <= kFloatSums * std::abs(light[4]);
}

/// The config's spaces, or those of them that are scene-linear.
std::string spaces_of(const ocio::ConstConfigRcPtr& config, bool only_scene_linear)
{
    std::string list;
    for (int i = 0; i < config->getNumColorSpaces(); ++i) {
        const auto space = config->getColorSpace(config->getColorSpaceNameByIndex(i));
        if (!only_scene_linear || is_scene_linear(config, space))
            list += fmt::format("{}'{}'", list.empty() ? "" : ", ", space->getName());
    }
    return list;
}

ocio::ConstColorSpaceRcPtr find_asked(const ocio::ConstConfigRcPtr& config, const char* option,
                                      const std::string& asked, const std::string& file)
{
    if (auto space = config->getColorSpace(asked.c_str()))
        return space;
    throw Error(fmt::format("{}: {} '{}' is not in the OpenColorIO config; it has {}", file, option,
                            asked, spaces_of(config, false)));
}

std::string choose_working_space(const ocio::ConstConfigRcPtr& config, const ColorRequest& request)
{
    const bool by_role = request.working_space.empty();
    if (by_role && !config->getColorSpace(ocio::ROLE_SCENE_LINEAR))
        throw Error(fmt::format("{}: the OpenColorIO config has no role '{}', which names the "
                                "space colors are averaged in; name one with --working-space",
                                request.config_file, ocio::ROLE_SCENE_LINEAR));
    const auto space =
        find_asked(config, "--working-space",
                   by_role ? ocio::ROLE_SCENE_LINEAR : request.working_space, request.file);
    if (is_scene_linear(config, space))
        return space->getName();
    throw Error(
        fmt::format("{}: {} '{}' {}, not scene-linear: averages of its numbers are no "
                    "averages of light; --working-space may be one of {}",
                    request.file, by_role ? "the config's role scene_linear," : "--working-space",
                    space->getName(), space->isData() ? "holds data" : "is encoded or a display's",
                    spaces_of(config, true)));
}

std::string choose_input_space(const ocio::ConstConfigRcPtr& config, const ColorRequest& request)
{
    if (!request.input_space.empty())
        return find_asked(config, "--color-space", request.input_space, request.file)->getName();
    const char* by_rule = config->getColorSpaceFromFilepath(request.file.c_str());
    const bool has_rule = !config->filepathOnlyMatchesDefaultRule(request.file.c_str());
    for (const std::string& stated : {request.file_metadata, request.file_fallback}) {
        if (is_just_linear(stated) && has_rule)
            return by_rule;
        if (std::string found = find_stated(*config, stated); !found.empty())
            return found;
    }
    const auto space = config->getColorSpace(by_rule); // a rule may name a role
    return space ? space->getName() : by_rule;
}

} // namespace

struct ColorConversion::Processor {
    ocio::ConstCPUProcessorRcPtr cpu;
};

ColorConversion::ColorConversion(const ColorRequest& request)
    : processor_(std::make_unique<Processor>())
{
    const auto config = load_config(request.config_file);
    try {
        working_space_ = choose_working_space(config, request);
        input_space_ = choose_input_space(config, request);
        // Lossless: nothing approximated for speed, whatever a version's default allows.
        processor_->cpu = config->getProcessor(input_space_.c_str(), working_space_.c_str())
                              ->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    } catch (const ocio::Exception& e) {
        throw Error(fmt::format("{}: no conversion from '{}' to '{}': {}", request.file,
                                input_space_, working_space_, e.what()));
    }
    const std::string& stated = request.file_metadata;
    if (request.input_space.empty() && !stated.empty() && find_stated(*config, stated).empty())
        notes_.push_back(fmt::format("{}: its header says '{}', which the OpenColorIO config does "
                                     "not know; its colors were read as '{}'; if they are not, "
                                     "give --color-space",
                                     request.file, stated, input_space_));
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
