#include "reference/block_scene.h"

#include <cstdint>
#include <string>
#include <vector>

#include <embree3/rtcore.h>

#include "math/error.h"

namespace scree::reference {
namespace {

constexpr int kBlockCells = 8; // along each axis

constexpr float kUlp = 0x1p-24F; // rounding of a float of 1

struct Bounds {
    double low, high;
};

/// Of the cells that have all their corners; low > high where there is none.
Bounds bounds_of(const NodeGrid& grid, const CellBlock& block)
{
    Bounds bounds{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
    for (int j = block.first_j; j < block.end_j; ++j)
        for (int i = block.first_i; i < block.end_i; ++i) {
            const double* upper = grid.row(j) + i;
            const double* lower = grid.row(j + 1) + i;
            if (std::isnan(upper[0] + upper[1] + lower[0] + lower[1]))
                continue;
            bounds.low = std::min({bounds.low, upper[0], upper[1], lower[0], lower[1]});
            bounds.high = std::max({bounds.high, upper[0], upper[1], lower[0], lower[1]});
        }
    return bounds;
}

/// What the callbacks know of a ray, beside what Embree does.
struct RayContext : RTCIntersectContext {
    const GridRay* ray = nullptr;
    Span span;
    double nearest = std::numeric_limits<double>::infinity();
};

float above(double value)
{
    return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

} // namespace

struct BlockScene::Embree {
    const NodeGrid* grid = nullptr;
    std::vector<CellBlock> blocks;
    float height_scale = 1; ///< of heights in float, so that they lie in [0, 1]
    float margin_xy = 0, margin_z = 0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::string refusal;

    explicit Embree(const NodeGrid& of) : grid(&of)
    {
        if (grid->range() > 0)
            height_scale = static_cast<float>(1 / grid->range());
        // Origin, direction and box are rounded once each, positions along the ray once more.
        margin_xy = 8 * kUlp * static_cast<float>(std::max(grid->columns(), grid->rows()));
        margin_z = 8 * kUlp;
    }
    ~Embree()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    void find_blocks();
    void build();
    void check() const;
    RTCRay float_ray(const GridRay& ray, Span span) const;

    static void on_error(void* self, RTCError, const char* what);
    static void bounds(const RTCBoundsFunctionArguments* args);
    static void intersect(const RTCIntersectFunctionNArguments* args);
    static void occluded(const RTCOccludedFunctionNArguments* args);
};

void BlockScene::Embree::on_error(void* self, RTCError, const char* what)
{
    static_cast<Embree*>(self)->refusal = what != nullptr ? what : "unknown error";
}

void BlockScene::Embree::check() const
{
    if (!refusal.empty())
        throw Error("ray casting: Embree says '" + refusal + "'; a smaller map needs less memory");
}

void BlockScene::Embree::find_blocks()
{
    const int cells_x = grid->columns() - 1, cells_y = grid->rows() - 1;
    for (int j = 0; j < cells_y; j += kBlockCells)
        for (int i = 0; i < cells_x; i += kBlockCells) {
            const CellBlock block{i, j, std::min(i + kBlockCells, cells_x),
                                  std::min(j + kBlockCells, cells_y)};
            const Bounds height = bounds_of(*grid, block);
            if (height.low <= height.high)
                blocks.push_back(block);
        }
}

void BlockScene::Embree::build()
{
    device = rtcNewDevice(nullptr);
    if (device == nullptr)
        throw Error("ray casting: Embree does not start; it needs a processor with SSE2");
    rtcSetDeviceErrorFunction(device, on_error, this);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    check();
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(blocks.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    check();
}

void BlockScene::Embree::bounds(const RTCBoundsFunctionArguments* args)
{
    const auto& self = *static_cast<const Embree*>(args->geometryUserPtr);
    const CellBlock& block = self.blocks[args->primID];
    const Bounds height = bounds_of(*self.grid, block);
    RTCBounds& box = *args->bounds_o;
    box.lower_x = static_cast<float>(block.first_i) - self.margin_xy;
    box.lower_y = static_cast<float>(block.first_j) - self.margin_xy;
    box.lower_z = static_cast<float>(height.low) * self.height_scale - self.margin_z;
    box.upper_x = static_cast<float>(block.end_i) + self.margin_xy;
    box.upper_y = static_cast<float>(block.end_j) + self.margin_xy;
    box.upper_z = static_cast<float>(height.high) * self.height_scale + self.margin_z;
}

void BlockScene::Embree::occluded(const RTCOccludedFunctionNArguments* args)
{
    const auto& self = *static_cast<const Embree*>(args->geometryUserPtr);
    const auto& context = *static_cast<const RayContext*>(args->context);
    const GridRay& ray = *context.ray;
    const double limit = -self.grid->tolerance();
    const bool below = march(
        self.blocks[args->primID], ray, context.span, [&](int i, int j, double from, double to) {
            return clearance(*self.grid, i, j, ray, from).least(to - from) < limit;
        });
    if (below) // Embree's sign for it
        reinterpret_cast<RTCRay*>(args->ray)->tfar = -std::numeric_limits<float>::infinity();
}

void BlockScene::Embree::intersect(const RTCIntersectFunctionNArguments* args)
{
    const auto& self = *static_cast<const Embree*>(args->geometryUserPtr);
    auto& context = *static_cast<RayContext*>(args->context);
    const GridRay& ray = *context.ray;
    const bool met = march(self.blocks[args->primID], ray,
                           {context.span.from, std::min(context.span.to, context.nearest)},
                           [&](int i, int j, double from, double to) {
                               const auto zero = clearance(*self.grid, i, j, ray, from)
                                                     .first_zero(to - from, self.grid->tolerance());
                               if (zero)
                                   context.nearest = from + *zero;
                               return zero.has_value();
                           });
    if (met)
        reinterpret_cast<RTCRayHit*>(args->rayhit)->ray.tfar = above(context.nearest);
}

RTCRay BlockScene::Embree::float_ray(const GridRay& ray, Span span) const
{
    RTCRay out{};
    out.org_x = static_cast<float>(ray.x);
    out.org_y = static_cast<float>(ray.y);
    out.org_z = static_cast<float>(ray.z) * height_scale;
    out.dir_x = static_cast<float>(ray.dx);
    out.dir_y = static_cast<float>(ray.dy);
    out.dir_z = static_cast<float>(ray.dz) * height_scale;
    out.tnear = static_cast<float>(span.from) * (1 - 2 * kUlp);
    out.tfar = above(span.to);
    out.mask = ~0U;
    return out;
}

BlockScene::BlockScene(const NodeGrid& grid) : embree_(std::make_unique<Embree>(grid))
{
    embree_->find_blocks();
    embree_->build();
}

BlockScene::~BlockScene() = default;

bool BlockScene::is_below(const GridRay& ray, Span span) const
{
    RayContext context;
    rtcInitIntersectContext(&context);
    context.ray = &ray;
    context.span = span;
    RTCRay cast = embree_->float_ray(ray, span);
    rtcOccluded1(embree_->scene, &context, &cast);
    return cast.tfar < 0;
}

std::optional<double> BlockScene::first_meeting(const GridRay& ray, Span span) const
{
    RayContext context;
    rtcInitIntersectContext(&context);
    context.ray = &ray;
    context.span = span;
    RTCRayHit cast{};
    cast.ray = embree_->float_ray(ray, span);
    cast.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context, &cast);
    if (context.nearest <= span.to)
        return context.nearest;
    return {};
}

} // namespace scree::reference
