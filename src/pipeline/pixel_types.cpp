#include "pipeline/pixel_types.h"

namespace scree {

namespace {

/// Of few numbers, that stay as they are.
bool is_measured(Map map) { return map != Map::map && map != Map::exponent; }

} // namespace

PixelTypes::PixelTypes(const std::vector<TextureRecord>& textures, const MomentLayout& layout,
                       const ValueScale& scale, int width, int height)
{
    for (const TextureRecord& texture : textures)
        errors_.push_back(is_measured(texture.map) ? std::make_unique<StorageError>(
                                                         texture.map, layout, scale, width, height)
                                                   : nullptr);
}

std::vector<TexelVisitor*> PixelTypes::visitors() const
{
    std::vector<TexelVisitor*> visitors;
    for (const auto& error : errors_)
        if (error)
            visitors.push_back(error.get());
    return visitors;
}

void PixelTypes::choose(std::vector<TextureRecord>& textures, double half_tolerance) const
{
    for (size_t i = 0; i < textures.size(); ++i) {
        if (!errors_[i])
            continue;
        textures[i].half_error = errors_[i]->half_error();
        textures[i].float_error = errors_[i]->float_error();
        textures[i].type =
            *textures[i].half_error <= half_tolerance ? PixelType::half : PixelType::float32;
    }
}

} // namespace scree
