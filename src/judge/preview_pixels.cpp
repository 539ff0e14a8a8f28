#include "judge/preview_pixels.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <mutex>

namespace scree {

namespace {

/// Where a set is looked up for what a pixel sees of the plane.
TexturePlace texture_place(const reference::PlaneView& view, const Manifest& manifest)
{
    const double per_s = 1 / (manifest.width * manifest.texel_width);
    const double per_t = 1 / (manifest.height * manifest.texel_height);
    // Far away a float would have no digits left for the place within a repeat.
    auto fraction = [](double place) { return static_cast<float>(place - std::floor(place)); };
    auto share = [](double change) { return static_cast<float>(change); };
    return {fraction(view.place.x * per_s), fraction(view.place.y * per_t),
            share(view.along_x.x * per_s),  share(view.along_x.y * per_t),
            share(view.along_y.x * per_s),  share(view.along_y.y * per_t)};
}

ShadedPixel shaded(const reference::Radiance& seen, const Material& material)
{
    const double specular = static_cast<double>(material.f0) * seen.specular;
    ShadedPixel pixel;
    for (size_t c = 0; c < 3; ++c)
        pixel.radiance[c] = static_cast<float>(seen.diffuse[c] + specular);
    pixel.covered = static_cast<float>(seen.covered);
    return pixel;
}

} // namespace

LookedUp look_up(const SetLookup& set, const Material& material, const Vec3& light,
                 const reference::Camera& camera, const reference::PictureArea& area,
                 const std::function<void(double)>& progress)
{
    const auto columns = static_cast<size_t>(area.columns);
    const size_t count = columns * static_cast<size_t>(area.rows);
    LookedUp pixels{ShadedPixels(count), ShadedPixels(count)};
    const Vec3f wi(light);
    std::mutex telling;
    int done = 0;
    tbb::parallel_for(0, area.rows, [&](int row) {
        for (size_t i = 0; i < columns; ++i) {
            const double x = area.first_column + static_cast<double>(i) + 0.5;
            const auto view = camera.view_of_plane(set.manifest().h0, x, row + 0.5);
            if (!view)
                continue;
            const SetTexel texel = set.at(texture_place(*view, set.manifest()));
            const Vec3f wo(view->to_viewer);
            const size_t pixel = static_cast<size_t>(row) * columns + i;
            pixels.plain[pixel] = {plain_radiance(texel, material, wo, wi), texel.coverage};
            pixels.set[pixel] = {set_radiance(texel, set.colors(), material, wo, wi),
                                 texel.coverage};
        }
        if (!progress)
            return;
        const std::lock_guard<std::mutex> lock(telling);
        progress(static_cast<double>(++done) / area.rows);
    });
    return pixels;
}

TruePixels trace(const reference::DisplacedSurface& surface, const Material& material,
                 const Vec3& light, const reference::Camera& camera,
                 const reference::PictureArea& area, int grid, uint64_t seed,
                 const std::function<void(double)>& progress)
{
    reference::RenderPlan plan;
    plan.light = light;
    plan.base_alpha = static_cast<double>(material.base_alpha);
    plan.grid = grid;
    plan.seed = seed;
    const auto rendering = reference::render(surface, camera, area, plan, progress);
    TruePixels truth;
    truth.rays = rendering.rays;
    for (const reference::RenderedPixel& pixel : rendering.pixels) {
        truth.all.push_back(shaded(pixel.all, material));
        for (size_t half = 0; half < 2; ++half)
            truth.halves[half].push_back(shaded(pixel.halves[half], material));
    }
    return truth;
}

PixelErrors compare(const ShadedPixels& pixels, const TruePixels& truth)
{
    constexpr float kWhole = 0.999F; // coverage is a filtered float
    double sum = 0, true_sum = 0, square = 0, true_square = 0, noise = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i].covered < kWhole || truth.all[i].covered < kWhole)
            continue;
        for (size_t c = 0; c < 3; ++c) {
            auto value = [c](const ShadedPixel& pixel) {
                return static_cast<double>(pixel.radiance[c]);
            };
            const double is = value(pixels[i]), should = value(truth.all[i]);
            const double halves = value(truth.halves[0][i]) - value(truth.halves[1][i]);
            sum += is;
            true_sum += should;
            square += (is - should) * (is - should);
            true_square += should * should;
            noise += halves * halves / 4;
        }
    }
    if (!(true_square > 0))
        return {0, 0, 0};
    return {sum / true_sum, std::sqrt(square / true_square), std::sqrt(noise / true_square)};
}

} // namespace scree
