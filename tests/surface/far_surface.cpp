#include "surface/far_surface.h"

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <array>

namespace scree::test {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

namespace {

constexpr unsigned kIsolation = 10;
/// More than any patch has.
constexpr size_t kWeights = 64;

/// What the refiner blends.
template <class Vector>
struct Value {
    Vector value{};
    void Clear(void* = nullptr) { value = Vector(0.0); }
    void AddWithWeight(const Value& other, double weight) { value += other.value * weight; }
};

using Positions = std::vector<Value<Vec3>>;
using Uvs = std::vector<Value<Vec2>>;

Far::PatchTableFactory::Options patch_options()
{
    Far::PatchTableFactory::Options options(kIsolation);
    options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    options.useInfSharpPatch = true;
    options.generateFVarTables = true;
    options.generateFVarLegacyLinearPatches = false;
    options.generateLegacySharpCornerPatches = false;
    options.SetPatchPrecision<double>();
    options.SetFVarPatchPrecision<double>();
    return options;
}

std::unique_ptr<Far::TopologyRefiner> refined(const Mesh& mesh, const SurfaceOptions& options)
{
    Far::TopologyDescriptor::FVarChannel channel;
    channel.numValues = static_cast<int>(mesh.uvs.size());
    channel.valueIndices = mesh.face_uvs.data();
    std::vector<int> edges, corners;
    std::vector<float> edge_sharpness, corner_sharpness;
    for (const Crease& crease : mesh.creases) {
        edges.insert(edges.end(), {crease.from, crease.to});
        edge_sharpness.push_back(static_cast<float>(crease.sharpness));
    }
    for (const SharpCorner& corner : mesh.corners) {
        corners.push_back(corner.vertex);
        corner_sharpness.push_back(static_cast<float>(corner.sharpness));
    }
    Far::TopologyDescriptor cage;
    cage.numVertices = static_cast<int>(mesh.vertices.size());
    cage.numFaces = static_cast<int>(mesh.face_sizes.size());
    cage.numVertsPerFace = mesh.face_sizes.data();
    cage.vertIndicesPerFace = mesh.face_vertices.data();
    cage.numCreases = static_cast<int>(edge_sharpness.size());
    cage.creaseVertexIndexPairs = edges.data();
    cage.creaseWeights = edge_sharpness.data();
    cage.numCorners = static_cast<int>(corners.size());
    cage.cornerVertexIndices = corners.data();
    cage.cornerWeights = corner_sharpness.data();
    cage.numFVarChannels = 1;
    cage.fvarChannels = &channel;
    // The numbers of OpenSubdiv's enumerations, in its order.
    const auto number = [](auto rule) { return static_cast<int>(rule.value()); };
    const SubdivisionRules& asked = options.rules;
    using Rules = Sdc::Options;
    Rules rules;
    rules.SetVtxBoundaryInterpolation(
        static_cast<Rules::VtxBoundaryInterpolation>(number(asked.boundary)));
    rules.SetFVarLinearInterpolation(static_cast<Rules::FVarLinearInterpolation>(number(asked.uv)));
    rules.SetCreasingMethod(static_cast<Rules::CreasingMethod>(number(asked.creases)));
    rules.SetTriangleSubdivision(static_cast<Rules::TriangleSubdivision>(number(asked.triangles)));
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const auto scheme = options.scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(cage, Factory::Options(scheme, rules)));
    refiner->RefineAdaptive(patch_options().GetRefineAdaptiveOptions());
    return refiner;
}

template <class Values, class Indices, class Weights>
auto blend(const Values& values, const Indices& indices, const Weights& weights)
{
    auto sum = values[0].value * 0;
    for (int i = 0; i < indices.size(); ++i)
        sum += values[static_cast<size_t>(indices[i])].value * weights[static_cast<size_t>(i)];
    return sum;
}

} // namespace

struct FarSurface::Data {
    Data(const Mesh& mesh, const SurfaceOptions& options)
        : refiner(refined(mesh, options)),
          table(Far::PatchTableFactory::Create(*refiner, patch_options())), map(*table),
          ptex(*refiner)
    {
        const Far::PrimvarRefinerReal<double> refine(*refiner);
        const auto vertices = static_cast<size_t>(refiner->GetNumVerticesTotal());
        positions.resize(vertices + static_cast<size_t>(table->GetNumLocalPoints()));
        for (size_t i = 0; i < mesh.vertices.size(); ++i)
            positions[i].value = mesh.vertices[i];
        const auto values = static_cast<size_t>(refiner->GetNumFVarValuesTotal());
        uvs.resize(values + static_cast<size_t>(table->GetNumLocalPointsFaceVarying()));
        for (size_t i = 0; i < mesh.uvs.size(); ++i)
            uvs[i].value = mesh.uvs[i];
        Value<Vec3>* from = positions.data();
        Value<Vec2>* uv_from = uvs.data();
        for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
            Value<Vec3>* to = from + refiner->GetLevel(level - 1).GetNumVertices();
            Value<Vec2>* uv_to = uv_from + refiner->GetLevel(level - 1).GetNumFVarValues();
            refine.Interpolate(level, from, to);
            refine.InterpolateFaceVarying(level, uv_from, uv_to);
            from = to;
            uv_from = uv_to;
        }
        if (const auto* local = table->GetLocalPointStencilTable<double>())
            local->UpdateValues(positions.data(), positions.data() + vertices);
        if (const auto* local = table->GetLocalPointFaceVaryingStencilTable<double>())
            local->UpdateValues(uvs.data(), uvs.data() + values);
    }

    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::unique_ptr<Far::PatchTable> table;
    Far::PatchMap map;
    Far::PtexIndices ptex;
    Positions positions;
    Uvs uvs;
};

FarSurface::FarSurface(const Mesh& mesh, const SurfaceOptions& options)
    : data_(std::make_unique<Data>(mesh, options))
{}

FarSurface::~FarSurface() = default;

// Far takes places inside a sub-face of a polygon over [0, 1], but gives derivatives by parameters
// in which its side is 1/2 long, as Bfr's are.

SurfacePoint FarSurface::at(int face, size_t piece, const ParameterPiece& where,
                            const Vec2& place) const
{
    const Vec2 p = (place - where.origin) / where.size;
    const auto* patch =
        data_->map.FindPatch(data_->ptex.GetFaceId(face) + static_cast<int>(piece), p.x, p.y);
    std::array<std::array<double, kWeights>, 6> w{};
    data_->table->EvaluateBasis(*patch, p.x, p.y, w[0].data(), w[1].data(), w[2].data(),
                                w[3].data(), w[4].data(), w[5].data());
    const auto points = data_->table->GetPatchVertices(*patch);
    const auto of = [&](size_t k) { return blend(data_->positions, points, w[k]); };
    return {of(0), of(1), of(2), of(3), of(4), of(5)};
}

UvPoint FarSurface::uv_at(int face, size_t piece, const ParameterPiece& where,
                          const Vec2& place) const
{
    const Vec2 p = (place - where.origin) / where.size;
    const auto* patch =
        data_->map.FindPatch(data_->ptex.GetFaceId(face) + static_cast<int>(piece), p.x, p.y);
    std::array<std::array<double, kWeights>, 3> w{};
    data_->table->EvaluateBasisFaceVarying(*patch, p.x, p.y, w[0].data(), w[1].data(), w[2].data());
    const auto points = data_->table->GetPatchFVarValues(*patch);
    const auto of = [&](size_t k) { return blend(data_->uvs, points, w[k]); };
    return {of(0), of(1), of(2)};
}

} // namespace scree::test
