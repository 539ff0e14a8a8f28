#include "surface/refiner.h"

#include <fmt/format.h>
#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

#include "math/error.h"

namespace scree {

namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Rules = Sdc::Options;

Rules::VtxBoundaryInterpolation of(BoundaryRule rule)
{
    switch (rule) {
    case BoundaryRule::none:
        return Rules::VTX_BOUNDARY_NONE;
    case BoundaryRule::edge_only:
        return Rules::VTX_BOUNDARY_EDGE_ONLY;
    case BoundaryRule::edge_and_corner:
        break;
    }
    return Rules::VTX_BOUNDARY_EDGE_AND_CORNER;
}

Rules::FVarLinearInterpolation of(UvRule rule)
{
    switch (rule) {
    case UvRule::none:
        return Rules::FVAR_LINEAR_NONE;
    case UvRule::corners_only:
        return Rules::FVAR_LINEAR_CORNERS_ONLY;
    case UvRule::corners_plus1:
        return Rules::FVAR_LINEAR_CORNERS_PLUS1;
    case UvRule::corners_plus2:
        return Rules::FVAR_LINEAR_CORNERS_PLUS2;
    case UvRule::boundaries:
        return Rules::FVAR_LINEAR_BOUNDARIES;
    case UvRule::all:
        break;
    }
    return Rules::FVAR_LINEAR_ALL;
}

/// None of the rules is empty.
Rules of(const SubdivisionRules& given)
{
    Rules rules;
    rules.SetVtxBoundaryInterpolation(of(*given.boundary));
    rules.SetFVarLinearInterpolation(of(*given.uv));
    rules.SetTriangleSubdivision(*given.triangles == TriangleRule::catmull_clark
                                     ? Rules::TRI_SUB_CATMARK
                                     : Rules::TRI_SUB_SMOOTH);
    return rules;
}

void expect_triangles(const Mesh& mesh)
{
    const auto other = std::count_if(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                                     [](int size) { return size != 3; });
    if (other > 0)
        throw Error(fmt::format("{}: {} of {} faces are no triangles, which Loop subdivision "
                                "needs; use Catmull-Clark or triangulate the mesh",
                                mesh.name, other, mesh.face_sizes.size()));
}

/// Bfr (3.5, 3.6) leaves gaps of some thousandths of a face between faces where creases of
/// different sharpness meet under Chaikin's rule; without sharpness that falls the rules agree.
void expect_uniform_creases(const Mesh& mesh, CreaseRule rule)
{
    const auto falls = [](const Crease& crease) {
        return crease.sharpness > 0 &&
               crease.sharpness < static_cast<double>(Sdc::Crease::SHARPNESS_INFINITE);
    };
    if (rule == CreaseRule::chaikin && std::any_of(mesh.creases.begin(), mesh.creases.end(), falls))
        throw Error(fmt::format("{}: creases by Chaikin's method with a sharpness below 10, which "
                                "is not supported; use the method normal, or sharpness 10",
                                mesh.name));
}

/// What faces at a vertex cost, in time and memory, grows with the cube of their number: seconds
/// for so many.
constexpr int kMostFacesAtVertex = 1000;

void expect_few_faces_at_vertices(const Mesh& mesh)
{
    std::vector<int> faces_of(mesh.vertices.size());
    for (const int vertex : mesh.face_vertices)
        if (++faces_of[static_cast<size_t>(vertex)] > kMostFacesAtVertex)
            throw Error(fmt::format("{}: more than {} faces at vertex {} (from 0); split the pole "
                                    "by a ring of faces",
                                    mesh.name, kMostFacesAtVertex, vertex));
}

/// The library tells why by a callback without context, one for the program.
class ErrorCapture {
public:
    ErrorCapture() : lock_(mutex())
    {
        text().clear();
        Far::SetErrorCallback(keep_error);
        Far::SetWarningCallback(keep);
    }
    ~ErrorCapture()
    {
        Far::SetErrorCallback(nullptr);
        Far::SetWarningCallback(nullptr);
    }
    ErrorCapture(const ErrorCapture&) = delete;
    ErrorCapture& operator=(const ErrorCapture&) = delete;

    static std::string& text()
    {
        static std::string kept;
        return kept;
    }

private:
    static std::mutex& mutex()
    {
        static std::mutex only;
        return only;
    }
    static void keep(const char* message)
    {
        if (text().empty())
            text() = message;
    }
    static void keep_error(Far::ErrorType /*type*/, const char* message) { keep(message); }

    std::lock_guard<std::mutex> lock_;
};

/// Arrays that a descriptor refers to.
struct Sharpness {
    std::vector<int> edges, vertices;
    std::vector<float> of_edges, of_vertices;

    explicit Sharpness(const Mesh& mesh)
    {
        for (const Crease& crease : mesh.creases) {
            edges.insert(edges.end(), {crease.from, crease.to});
            of_edges.push_back(limited(crease.sharpness));
        }
        for (const SharpCorner& corner : mesh.corners) {
            vertices.push_back(corner.vertex);
            of_vertices.push_back(limited(corner.sharpness));
        }
    }

    static float limited(double sharpness)
    {
        return std::min(static_cast<float>(sharpness), Sdc::Crease::SHARPNESS_INFINITE);
    }
};

void expect_creases_on_edges(const Mesh& mesh, const Far::TopologyRefiner& refiner)
{
    for (const Crease& crease : mesh.creases)
        if (refiner.GetLevel(0).FindEdge(crease.from, crease.to) == Far::INDEX_INVALID)
            throw Error(fmt::format("{}: a crease between vertices {} and {} (from 0), which no "
                                    "edge connects; remove it or name both ends of an edge",
                                    mesh.name, crease.from, crease.to));
}

} // namespace

VertexUvs uvs_by_vertex(const Mesh& mesh)
{
    VertexUvs out;
    std::map<std::tuple<int, double, double>, int> known;
    out.indices.reserve(mesh.face_uvs.size());
    for (size_t i = 0; i < mesh.face_uvs.size(); ++i) {
        const Vec2 uv = mesh.uvs[static_cast<size_t>(mesh.face_uvs[i])];
        const auto [at, added] = known.try_emplace({mesh.face_vertices[i], uv.x, uv.y},
                                                   static_cast<int>(out.values.size()));
        if (added)
            out.values.push_back(uv);
        out.indices.push_back(at->second);
    }
    return out;
}

std::unique_ptr<Far::TopologyRefiner> make_refiner(const Mesh& mesh, const SurfaceOptions& options,
                                                   const VertexUvs& uvs)
{
    if (options.scheme == Scheme::loop)
        expect_triangles(mesh);
    const SubdivisionRules rules = rules_in_effect(options.rules, mesh.rules);
    expect_uniform_creases(mesh, *rules.creases);
    expect_few_faces_at_vertices(mesh);
    const Sharpness sharp(mesh);
    Far::TopologyDescriptor::FVarChannel channel;
    channel.numValues = static_cast<int>(uvs.values.size());
    channel.valueIndices = uvs.indices.data();
    Far::TopologyDescriptor cage;
    cage.numVertices = static_cast<int>(mesh.vertices.size());
    cage.numFaces = static_cast<int>(mesh.face_sizes.size());
    cage.numVertsPerFace = mesh.face_sizes.data();
    cage.vertIndicesPerFace = mesh.face_vertices.data();
    cage.numCreases = static_cast<int>(sharp.of_edges.size());
    cage.creaseVertexIndexPairs = sharp.edges.data();
    cage.creaseWeights = sharp.of_edges.data();
    cage.numCorners = static_cast<int>(sharp.vertices.size());
    cage.cornerVertexIndices = sharp.vertices.data();
    cage.cornerWeights = sharp.of_vertices.data();
    cage.numHoles = static_cast<int>(mesh.holes.size());
    cage.holeIndices = mesh.holes.data();
    cage.numFVarChannels = 1;
    cage.fvarChannels = &channel;

    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const ErrorCapture capture;
    const Factory::Options kept(
        options.scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, of(rules));
    std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(cage, kept));
    if (!refiner)
        throw Error(fmt::format("{}: OpenSubdiv cannot make a surface of this mesh: {}; repair its "
                                "faces",
                                mesh.name, ErrorCapture::text()));
    expect_creases_on_edges(mesh, *refiner);
    return refiner;
}

} // namespace scree
