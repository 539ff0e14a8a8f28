#pragma once

#include <memory>

#include "surface/limit_surface.h"

namespace scree::test {

/// The slow twin of LimitSurface: OpenSubdiv's Far patch tables over the whole cage, which share
/// with Bfr the rules of subdivision and the bases of patches, but neither topology nor refinement.
///
/// Indices of texture coordinates are taken as the mesh has them.
class FarSurface {
public:
    /// options  with all rules; the mesh's own are not looked at
    FarSurface(const Mesh& mesh, const SurfaceOptions& options);
    ~FarSurface();
    FarSurface(const FarSurface&) = delete;
    FarSurface& operator=(const FarSurface&) = delete;

    /// piece  of the face, with `place` inside
    [[nodiscard]] SurfacePoint at(int face, size_t piece, const ParameterPiece& where,
                                  const Vec2& place) const;
    [[nodiscard]] UvPoint uv_at(int face, size_t piece, const ParameterPiece& where,
                                const Vec2& place) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace scree::test
