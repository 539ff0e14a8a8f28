#include "reference/block_scene.h"

#include <cstdint>
#include <string>
#include <vector>

#include <embree3/rtcore.h>

#include "math/error.h"

namespace scree::reference {
namespace {

constexpr int kBlockCells = 8; // along each axis

constexpr double kRounding = 0x1p-24; // of a number to float, relative

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
    RayContext(const GridRay& of, double length) : ray(of), end(length)
    {
        rtcInitIntersectContext(this);
    }

    const GridRay& ray;
    double end; ///< of the part that is asked for, in steps; the nearest meeting once there is one
    bool met = false;
};

/// A float that is not less.
float not_below(double value)
{
    return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

/// Whether a ray is that much below the surface over a part of a cell.
bool is_below_in_cell(const NodeGrid& grid, int i, int j, const GridRay& ray, double from,
                      double to)
{
    // Most cells lie below the ray altogether; with a NaN among them either way leads to false.
    const double* upper = grid.row(j) + i;
    const double* lower = grid.row(j + 1) + i;
    const double highest = std::max(std::max(upper[0], upper[1]), std::max(lower[0], lower[1]));
    if (std::min(ray.z_at(from), ray.z_at(to)) > highest)
        return false;
    return clearance(grid, i, j, ray, from).least(to - from) < -grid.tolerance();
}

} // namespace

struct BlockScene::Embree {
    const NodeGrid* grid = nullptr;
    std::vector<CellBlock> blocks;
    double height_scale = 1; ///< what makes heights lie in [0, 1]
    double margin_xy = 0, margin_z = 0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::string refusal;

    explicit Embree(const NodeGrid& of) : grid(&of)
    {
        if (grid->range() > 0)
            height_scale = 1 / grid->range();
        // Origin and direction are rounded once, and so is the box: at any step the ray that Embree
        // has is within 2 such errors of the true one. Embree's own rounding is met by its flag
        // RTC_SCENE_FLAG_ROBUST.
        margin_xy = 8 * kRounding * std::max(grid->columns(), grid->rows());
        margin_z = 8 * kRounding;
    }
    ~Embree()
    {
        if (scene != nullptr)
            rtcReleaseScene(scene);
        if (device != nullptr)
            rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    void find_blocks();
    void build();
    void check() const;
    RTCRay float_ray(const GridRay& ray, double length) const;

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
    // No limit of threads: Embree would set it for all of the process; it shares TBB's anyway.
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
    box.lower_x = static_cast<float>(block.first_i - self.margin_xy);
    box.lower_y = static_cast<float>(block.first_j - self.margin_xy);
    box.lower_z = static_cast<float>(height.low * self.height_scale - self.margin_z);
    box.upper_x = static_cast<float>(block.end_i + self.margin_xy);
    box.upper_y = static_cast<float>(block.end_j + self.margin_xy);
    box.upper_z = static_cast<float>(height.high * self.height_scale + self.margin_z);
}

void BlockScene::Embree::occluded(const RTCOccludedFunctionNArguments* args)
{
    const auto& self = *static_cast<const Embree*>(args->geometryUserPtr);
    const auto& context = *static_cast<const RayContext*>(args->context);
    auto is_below = [&](int i, int j, double from, double to) {
        return is_below_in_cell(*self.grid, i, j, context.ray, from, to);
    };
    if (march(self.blocks[args->primID], context.ray, context.end,
              is_below)) // Embree's sign for it
        reinterpret_cast<RTCRay*>(args->ray)->tfar = -std::numeric_limits<float>::infinity();
}

void BlockScene::Embree::intersect(const RTCIntersectFunctionNArguments* args)
{
    const auto& self = *static_cast<const Embree*>(args->geometryUserPtr);
    auto& context = *static_cast<RayContext*>(args->context);
    auto meets = [&](int i, int j, double from, double to) {
        const auto zero = clearance(*self.grid, i, j, context.ray, from)
                              .first_zero(to - from, self.grid->tolerance());
        if (zero) {
            context.end = from + *zero;
            context.met = true;
        }
        return zero.has_value();
    };
    if (march(self.blocks[args->primID], context.ray, context.end, meets))
        reinterpret_cast<RTCRayHit*>(args->rayhit)->ray.tfar = not_below(context.end);
}

RTCRay BlockScene::Embree::float_ray(const GridRay& ray, double length) const
{
    RTCRay out{};
    out.org_x = static_cast<float>(ray.x);
    out.org_y = static_cast<float>(ray.y);
    out.org_z = static_cast<float>(ray.z * height_scale);
    out.dir_x = static_cast<float>(ray.dx);
    out.dir_y = static_cast<float>(ray.dy);
    out.dir_z = static_cast<float>(ray.dz * height_scale);
    out.tfar = not_below(length);
    out.mask = ~0U;
    return out;
}

BlockScene::BlockScene(const NodeGrid& grid) : embree_(std::make_unique<Embree>(grid))
{
    embree_->find_blocks();
    embree_->build();
}

BlockScene::~BlockScene() = default;

bool BlockScene::is_below(const GridRay& ray, double length) const
{
    RayContext context(ray, length);
    RTCRay cast = embree_->float_ray(ray, length);
    rtcOccluded1(embree_->scene, &context, &cast);
    return cast.tfar < 0;
}

std::optional<double> BlockScene::first_meeting(const GridRay& ray, double length) const
{
    RayContext context(ray, length);
    RTCRayHit cast{};
    cast.ray = embree_->float_ray(ray, length);
    cast.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context, &cast);
    if (context.met)
        return context.end;
    return {};
}

} // namespace scree::reference
