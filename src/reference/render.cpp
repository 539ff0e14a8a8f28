#include "reference/render.h"

#include <cmath>
#include <mutex>

#include <tbb/parallel_for.h>

#include "reference/facet.h"
#include "reference/jitter.h"

namespace scree::reference {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Sums of Radiance over rays, weighted with the data's weight.
struct RadianceSums {
    int rays = 0;
    Radiance sum;

    void add(const RadianceSums& other)
    {
        rays += other.rays;
        sum.covered += other.sum.covered;
        sum.specular += other.sum.specular;
        for (size_t c = 0; c < 3; ++c)
            sum.diffuse[c] += other.sum.diffuse[c];
    }

    [[nodiscard]] Radiance mean() const
    {
        if (!(sum.covered > 0))
            return {};
        Radiance mean = sum;
        mean.covered = sum.covered / rays;
        mean.specular = sum.specular / sum.covered;
        for (double& c : mean.diffuse)
            c /= sum.covered;
        return mean;
    }
};

class Renderer {
public:
    Renderer(const DisplacedSurface& surface, const Camera& camera, const RenderPlan& plan)
        : surface_(surface), camera_(camera), plan_(plan)
    {}

    RenderedPixel pixel(int column, int row);
    [[nodiscard]] long long rays() const { return rays_; }

private:
    void add(RadianceSums& sums, const Ray& ray);

    const DisplacedSurface& surface_;
    const Camera& camera_;
    const RenderPlan& plan_;
    long long rays_ = 0;
};

void Renderer::add(RadianceSums& sums, const Ray& ray)
{
    ++rays_;
    const auto hit = surface_.hit(ray.origin, ray.direction);
    const SurfacePoint point = hit ? surface_.at(hit->s, hit->t) : SurfacePoint{};
    const Vec3 view = -ray.direction;
    const double facing = towards(view, point.slope);
    // Within rounding of an edge a ray may be taken to the face behind it; such a one does not
    // count.
    if (point.weight > 0 && !(facing > 0))
        return;
    ++sums.rays;
    if (!(point.weight > 0))
        return;
    sums.sum.covered += point.weight;
    const double lit = towards(plan_.light, point.slope);
    if (!(lit > 0))
        return;
    ++rays_;
    if (!surface_.is_open(hit->s, hit->t, plan_.light))
        return;
    const double cosine = lit / std::sqrt(1 + point.slope.length2());
    for (size_t c = 0; c < 3; ++c)
        sums.sum.diffuse[c] += point.weight * point.color[c] * cosine / kPi;
    // Of each ray what gather() takes of each sample of the plane, which sees a facet in proportion
    // to its projected area.
    const double lambda_o = OwnMasking(view, plan_.base_alpha).lambda(facing);
    const double lambda_i = OwnMasking(plan_.light, plan_.base_alpha).lambda(lit);
    const MirrorLobe lobe(view, plan_.light, plan_.base_alpha);
    sums.sum.specular += point.weight * lobe.at(point.slope, lambda_o, lambda_i) / facing;
}

RenderedPixel Renderer::pixel(int column, int row)
{
    const auto x = static_cast<uint64_t>(column), y = static_cast<uint64_t>(row);
    const uint64_t index = y << 32 | x;
    std::array<RadianceSums, 2> halves;
    const auto grid = static_cast<uint64_t>(plan_.grid);
    for (uint64_t j = 0; j < grid; ++j)
        for (uint64_t i = 0; i < grid; ++i) {
            const auto inside = jitter(plan_.seed, index, j * grid + i);
            add(halves[half_of(plan_.seed, index, i, j)],
                camera_.ray(column + (static_cast<double>(i) + inside[0]) / plan_.grid,
                            row + (static_cast<double>(j) + inside[1]) / plan_.grid));
        }
    RenderedPixel pixel;
    for (size_t half = 0; half < 2; ++half)
        pixel.halves[half] = halves[half].mean();
    halves[0].add(halves[1]);
    pixel.all = halves[0].mean();
    return pixel;
}

} // namespace

Rendering render(const DisplacedSurface& surface, const Camera& camera, const PictureArea& area,
                 const RenderPlan& plan, const std::function<void(double)>& progress)
{
    Rendering rendering;
    const auto columns = static_cast<size_t>(area.columns);
    rendering.pixels.resize(columns * static_cast<size_t>(area.rows));
    std::mutex telling;
    int done = 0;
    tbb::parallel_for(0, area.rows, [&](int row) {
        Renderer renderer(surface, camera, plan);
        RenderedPixel* pixels = &rendering.pixels[static_cast<size_t>(row) * columns];
        for (size_t i = 0; i < columns; ++i)
            pixels[i] = renderer.pixel(area.first_column + static_cast<int>(i), row);
        const std::lock_guard<std::mutex> lock(telling);
        rendering.rays += renderer.rays();
        if (progress)
            progress(static_cast<double>(++done) / area.rows);
    });
    return rendering;
}

} // namespace scree::reference
