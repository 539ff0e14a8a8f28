#include "judge/texel_images.h"

#include <algorithm>
#include <cmath>

#include "reference/footprint.h"
#include "reference/gather.h"

namespace scree {

namespace {

constexpr Rgbf kHidden{0.2F, 0.2F, 0.2F};

Picture picture_of(int width, int height)
{
    return {width, height,
            std::vector<float>(3 * static_cast<size_t>(width) * static_cast<size_t>(height))};
}

void put(Picture& picture, size_t pixel, const Rgbf& color)
{
    std::copy(color.begin(), color.end(),
              picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

Rgbf seen(const reference::Estimate& estimate, const Material& material)
{
    const reference::Rgb radiance =
        radiance_of(estimate.all.lit.front(), static_cast<double>(material.f0));
    return {static_cast<float>(radiance[0]), static_cast<float>(radiance[1]),
            static_cast<float>(radiance[2])};
}

/// Texels of which nothing is seen show nowhere; gray, and no difference.
void expose(TexelImages& images, const std::vector<reference::Estimate>& truths)
{
    images.exposure = fitting_exposure(images.truth.rgb);
    const auto factor = static_cast<float>(images.exposure);
    for (Picture* picture : {&images.plain, &images.set, &images.truth})
        for (float& value : picture->rgb)
            value *= factor;
    for (size_t i = 0; i < images.truth.rgb.size(); ++i)
        images.difference.rgb[i] =
            static_cast<float>(kDifferenceGain) * std::abs(images.set.rgb[i] - images.truth.rgb[i]);
    for (size_t pixel = 0; pixel < truths.size(); ++pixel)
        if (!(truths[pixel].all.seen.front().area > 0)) {
            put(images.truth, pixel, kHidden);
            put(images.difference, pixel, {0, 0, 0});
        }
}

} // namespace

int level_to_draw(const Manifest& manifest, int most)
{
    int level = 0;
    while (std::max(manifest.width, manifest.height) >> level > most)
        ++level;
    return level;
}

TexelImages draw_texels(SetReader& set, const reference::DisplacedSurface& surface, int level,
                        const Vec3& wo, const Vec3& wi, const Material& material, int grid,
                        const std::function<void(double)>& progress)
{
    const Manifest& manifest = set.manifest();
    const int width = reference::level_size(manifest.width, level);
    const int height = reference::level_size(manifest.height, level);
    TexelImages images;
    images.level = level;
    images.angle_deg = std::acos(wo.z) * 180 / 3.14159265358979323846;
    images.plain = images.set = images.truth = images.difference = picture_of(width, height);

    std::vector<reference::Footprint> footprints;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            footprints.push_back(
                reference::footprint_of(manifest.width, manifest.height, level, x, y));
    reference::GatherPlan plan;
    plan.views = {wo};
    plan.lights = {wi};
    plan.base_alpha = static_cast<double>(material.base_alpha);
    plan.grid = grid;
    const auto truths = reference::gather_all(surface, footprints, plan, progress);

    const Vec3f to_viewer(wo), to_light(wi);
    size_t pixel = 0;
    for (int y = 0; y < height; ++y)
        for (const SetTexel& texel : set.row(level, y)) {
            put(images.plain, pixel, plain_radiance(texel, material, to_viewer, to_light));
            put(images.set, pixel,
                set_radiance(texel, set.colors(), material, to_viewer, to_light));
            put(images.truth, pixel, seen(truths[pixel], material));
            ++pixel;
        }
    expose(images, truths);
    return images;
}

} // namespace scree
