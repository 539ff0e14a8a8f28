#include "judge/texel_images.h"

#include <algorithm>
#include <cmath>

#include "reference/footprint.h"
#include "reference/gather.h"

namespace scree {

namespace {

constexpr Rgbf kHidden{0.2F, 0.2F, 0.2F};

Vec3f single(const Vec3& w)
{
    return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
}

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

Rgbf shown(const SetTexel& texel, const SetColors& colors, const Material& material,
           const Vec3f& wo, const Vec3f& wi)
{
    const auto slopes = slopes_of(texel);
    const float exponent = filter::masking(wo, slopes).lambda + filter::masking(wi, slopes).lambda;
    const ColorModel best = colors.best();
    return radiance(slopes,
                    visible_color(texel, colors, best, colors.adds_slope(best), wo, exponent),
                    material, wo, wi);
}

Rgbf seen(const reference::Estimate& estimate, const Material& material)
{
    const reference::Lit& lit = estimate.all.lit.front();
    Rgbf color;
    for (size_t i = 0; i < 3; ++i)
        color[i] =
            static_cast<float>(lit.diffuse[i] + static_cast<double>(material.f0) * lit.specular);
    return color;
}

double exposure_of(const Picture& truth)
{
    std::vector<float> values = truth.rgb;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 98 / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at > 0 ? 0.8 / static_cast<double>(*at) : 1;
}

/// Texels of which nothing is seen show nowhere; gray, and no difference.
void expose(TexelImages& images, const std::vector<reference::Estimate>& truths)
{
    images.exposure = exposure_of(images.truth);
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

    size_t pixel = 0;
    for (int y = 0; y < height; ++y)
        for (const SetTexel& texel : set.row(level, y)) {
            put(images.plain, pixel, plain_radiance(texel, material, single(wo), single(wi)));
            put(images.set, pixel, shown(texel, set.colors(), material, single(wo), single(wi)));
            put(images.truth, pixel, seen(truths[pixel], material));
            ++pixel;
        }
    expose(images, truths);
    return images;
}

} // namespace scree
