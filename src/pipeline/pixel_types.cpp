#include "pipeline/pixel_types.h"

namespace scree {

PixelTypes::PixelTypes(const std::vector<TextureRecord>& textures, const MomentLayout& layout,
                       const ValueScale& scale, int width, int height)
{
    for (const TextureRecord& texture : textures)
        errors_.push_back(texture.map == Map::map ? nullptr
                                                  : std::make_unique<StorageError>(
                                                        texture.map, layout, scale, width, height));
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
