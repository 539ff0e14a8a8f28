#pragma once

#include <memory>
#include <vector>

#include "pipeline/storage_error.h"
#include "texset/manifest.h"

namespace scree {

/// Chooses the pixel type of every texture by measuring what half storage costs.
class PixelTypes {
public:
    /// Of textures that hold texels; the table of a color map stays as it is.
    PixelTypes(const std::vector<TextureRecord>& textures, const MomentLayout& layout,
               const ValueScale& scale, int width, int height);

    /// To be given to a MomentPyramid.
    [[nodiscard]] std::vector<TexelVisitor*> visitors() const;

    /// Records the errors, and takes half where its error is within the tolerance.
    ///
    /// textures  those of the constructor
    void choose(std::vector<TextureRecord>& textures, double half_tolerance) const;

private:
    std::vector<std::unique_ptr<StorageError>> errors_; ///< one a texture, null for a table
};

} // namespace scree
