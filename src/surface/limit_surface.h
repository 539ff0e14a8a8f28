#pragma once

#include <memory>
#include <vector>

#include "surface/mesh.h"
#include "surface/surface_point.h"

namespace scree {

/// What is asked of a surface beyond what its mesh says; a rule given here wins over the file's.
///
/// Where neither says anything: edge_and_corner boundaries, uniform creases and Catmull-Clark
/// triangles, texture coordinates linear everywhere. These are OpenSubdiv's own defaults, save for
/// boundaries: its default there is none, which would leave holes along every border.
struct SurfaceOptions {
    Scheme scheme = Scheme::catmull_clark;
    SubdivisionRules rules;
};

/// A part of a face's parameters (p, q): the square [p0, p0 + size] x [q0, q0 + size], or its half
/// p - p0 + q - q0 <= size.
struct ParameterPiece {
    Vec2 origin{0, 0};
    double size = 1;
    bool triangle = false;

    /// The nearest place inside, or close to it for a triangle.
    [[nodiscard]] Vec2 clamp(const Vec2& place) const;
    /// Distance to the border, in parts of the piece; 0 on it.
    [[nodiscard]] double border_distance(const Vec2& place) const;
};

/// The limit surface of one face of the cage, ready to be evaluated. Holds its control points;
/// refers to the surface it came from, which must live longer. Evaluation is thread safe.
class FaceSurface {
public:
    FaceSurface();
    ~FaceSurface();
    FaceSurface(FaceSurface&&) noexcept;
    FaceSurface& operator=(FaceSurface&&) noexcept;

    /// The face's parameters: one square (quadrilaterals), one triangle (Loop), or one square a
    /// corner. Empty for a face without a surface: a hole, or at a boundary without rule.
    [[nodiscard]] const std::vector<ParameterPiece>& pieces() const { return pieces_; }

    /// place  inside a piece
    [[nodiscard]] SurfacePoint at(const Vec2& place) const;
    [[nodiscard]] UvPoint uv_at(const Vec2& place) const;

    /// Texture coordinates are bilinear in each piece, or linear in a triangle.
    [[nodiscard]] bool has_linear_uvs() const;
    /// A box that holds the face's texture coordinates.
    [[nodiscard]] std::pair<Vec2, Vec2> uv_bounds() const;

private:
    friend class LimitSurface;
    struct Data;
    std::unique_ptr<Data> data_;
    std::vector<ParameterPiece> pieces_;
};

/// The surface that subdividing a cage again and again leads to, with its texture coordinates.
///
/// Exact (OpenSubdiv's Bfr, in double) but within 2^-10 of a face's size of an extraordinary
/// vertex, where a Gregory patch stands in for infinitely many smaller ones: positions and
/// derivatives stay finite there. Within 1/4 of a face at vertices of more than 64 faces. A
/// sharpness of 10 and more is infinite.
///
/// Corners of faces at one vertex that have the same texture coordinates count as one, whatever
/// their indices; corners at different vertices never do.
class LimitSurface {
public:
    /// throws Error: Loop of a mesh with other faces than triangles, a crease that is no edge,
    ///        a vertex of more than 1000 faces, Chaikin's creases with a sharpness below 10, a
    ///        topology that OpenSubdiv refuses
    LimitSurface(const Mesh& mesh, const SurfaceOptions& options);
    ~LimitSurface();
    LimitSurface(const LimitSurface&) = delete;
    LimitSurface& operator=(const LimitSurface&) = delete;

    [[nodiscard]] int face_count() const;
    /// Thread safe.
    [[nodiscard]] FaceSurface face(int index) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace scree
