#include "judge/preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "math/error.h"

namespace scree {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;
constexpr Rgbf kSky{0.32F, 0.42F, 0.55F}; // flat, as it is shown: no exposure
constexpr Rgbf kLine{1, 1, 1};

/// Paints parts of a scene, area by area, and keeps account of what the truth tells and costs.
class Painter {
public:
    /// views  of the scene: each has an area for every part
    Painter(const SetLookup& set, const reference::DisplacedSurface* surface,
            const PreviewScene& scene, int views)
        : set_(set), surface_(surface), scene_(scene)
    {
        for (const PreviewPart part : scene.parts)
            work_ += views * (kLookUpWork + (part == PreviewPart::truth ? kTraceWork : 0));
    }

    ShadedPixels paint(PreviewPart part, const reference::Camera& camera,
                       const reference::PictureArea& area, double angle_deg)
    {
        LookedUp looked_up =
            look_up(set_, scene_.material, scene_.light, camera, area, progress(kLookUpWork));
        if (part == PreviewPart::plain)
            return std::move(looked_up.plain);
        if (part == PreviewPart::set)
            return std::move(looked_up.set);
        TruePixels truth = traced(camera, area);
        account_.errors.push_back(
            {angle_deg, compare(looked_up.plain, truth), compare(looked_up.set, truth)});
        return std::move(truth.all);
    }

    [[nodiscard]] const Preview& account() const { return account_; }

private:
    static constexpr double kLookUpWork = 1, kTraceWork = 4; // of an area, in time, roughly

    /// Of a piece of the work, which counts as done from its end on.
    std::function<void(double)> progress(double work)
    {
        const double before = done_;
        done_ += work;
        return [this, before, work](double share) {
            if (scene_.progress)
                scene_.progress((before + work * share) / work_);
        };
    }

    TruePixels traced(const reference::Camera& camera, const reference::PictureArea& area)
    {
        // Areas of one seed would share their jitter, and their noise.
        const uint64_t seed = scene_.seed + account_.errors.size();
        const auto begin = std::chrono::steady_clock::now();
        TruePixels truth = trace(*surface_, scene_.material, scene_.light, camera, area,
                                 scene_.grid, seed, progress(kTraceWork));
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        account_.seconds += passed.count();
        account_.rays += truth.rays;
        account_.samples += static_cast<long long>(truth.all.size()) * scene_.grid * scene_.grid;
        return truth;
    }

    const SetLookup& set_;
    const reference::DisplacedSurface* surface_;
    const PreviewScene& scene_;
    double work_ = 0, done_ = 0;
    Preview account_; ///< without the picture
};

double exposure_of(const std::vector<ShadedPixels>& shown)
{
    std::vector<float> brightest;
    for (const ShadedPixels& pixels : shown)
        for (const ShadedPixel& pixel : pixels)
            if (pixel.covered > 0)
                brightest.push_back(
                    *std::max_element(pixel.radiance.begin(), pixel.radiance.end()));
    return fitting_exposure(std::move(brightest));
}

float* at(Picture& picture, int x, int y)
{
    return &picture.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) +
                             static_cast<size_t>(x))];
}

Picture blank(int width, int height)
{
    Picture picture{
        width, height,
        std::vector<float>(3 * static_cast<size_t>(width) * static_cast<size_t>(height))};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            std::copy(kLine.begin(), kLine.end(), at(picture, x, y));
    return picture;
}

/// Puts pixels into a picture, before the sky.
void put(Picture& picture, const ShadedPixels& pixels, int columns, int left, int top,
         double exposure)
{
    for (size_t i = 0; i < pixels.size(); ++i) {
        const int index = static_cast<int>(i);
        float* rgb = at(picture, left + index % columns, top + index / columns);
        for (size_t c = 0; c < 3; ++c)
            rgb[c] = pixels[i].covered * pixels[i].radiance[c] * static_cast<float>(exposure) +
                     (1 - pixels[i].covered) * kSky[c];
    }
}

/// At the middle of the map, on the plane of its mean height.
reference::Aim aim_at(const Manifest& manifest, double angle_deg, double azimuth_deg)
{
    reference::Aim aim;
    aim.target = {manifest.width * manifest.texel_width / 2,
                  manifest.height * manifest.texel_height / 2};
    aim.plane = manifest.h0;
    aim.angle_rad = angle_deg * kRadPerDegree;
    aim.azimuth_rad = azimuth_deg * kRadPerDegree;
    return aim;
}

reference::Camera plane_camera(const Manifest& manifest, const PlaneShot& shot, double highest)
{
    reference::Aim aim = aim_at(manifest, shot.angle_deg, shot.azimuth_deg);
    aim.width = shot.repeats * manifest.width * manifest.texel_width;
    aim.columns = shot.width;
    aim.rows = shot.height;
    auto camera = reference::Camera::pinhole(aim, shot.field_of_view_deg * kRadPerDegree);
    const double eye = camera.ray(0, 0).origin.z;
    if (eye <= highest)
        throw Error(fmt::format("the camera would be at height {:.3g}, inside a surface that "
                                "reaches up to {:.3g}; show more repeats, or a smaller view angle",
                                eye, highest));
    return camera;
}

reference::Camera tile_camera(const Manifest& manifest, const StripShot& shot, double angle_deg,
                              double highest)
{
    reference::Aim aim = aim_at(manifest, angle_deg, shot.azimuth_deg);
    aim.width = shot.tile * shot.texels_per_pixel * manifest.texel_width;
    aim.columns = aim.rows = shot.tile;
    return reference::Camera::distant(aim, highest + manifest.texel_width); // above it, if flat
}

} // namespace

std::string preview_part_name(PreviewPart part)
{
    switch (part) {
    case PreviewPart::plain:
        return "plain MIP";
    case PreviewPart::set:
        return "set";
    case PreviewPart::truth:
        break;
    }
    return "reference";
}

Preview draw_plane(const SetLookup& set, const reference::DisplacedSurface* surface,
                   const PreviewScene& scene, const PlaneShot& shot)
{
    const double highest = surface != nullptr ? surface->highest() : set.manifest().height_max;
    const reference::Camera camera = plane_camera(set.manifest(), shot, highest);
    Painter painter(set, surface, scene, 1);
    const int parts = static_cast<int>(scene.parts.size());
    std::vector<ShadedPixels> shown;
    std::vector<int> borders{0};
    for (const PreviewPart part : scene.parts) {
        const int first = borders.back();
        borders.push_back(static_cast<int>(borders.size()) * shot.width / parts);
        shown.push_back(painter.paint(part, camera, {first, borders.back() - first, shot.height},
                                      shot.angle_deg));
    }
    Preview preview = painter.account();
    preview.exposure = scene.exposure > 0 ? scene.exposure : exposure_of(shown);
    preview.picture = blank(shot.width, shot.height);
    for (size_t i = 0; i < shown.size(); ++i) {
        put(preview.picture, shown[i], borders[i + 1] - borders[i], borders[i], 0,
            preview.exposure);
        for (int y = 0; i > 0 && y < shot.height; ++y)
            std::copy(kLine.begin(), kLine.end(), at(preview.picture, borders[i], y));
    }
    return preview;
}

Preview draw_strip(const SetLookup& set, const reference::DisplacedSurface* surface,
                   const PreviewScene& scene, const StripShot& shot)
{
    constexpr int kGap = 2;
    const double highest = surface != nullptr ? surface->highest() : set.manifest().height_max;
    const int columns = static_cast<int>(shot.angles_deg.size());
    const int rows = static_cast<int>(scene.parts.size());
    Painter painter(set, surface, scene, columns);
    std::vector<ShadedPixels> shown; // column by column
    for (const double angle : shot.angles_deg)
        for (const PreviewPart part : scene.parts)
            shown.push_back(painter.paint(part, tile_camera(set.manifest(), shot, angle, highest),
                                          {0, shot.tile, shot.tile}, angle));
    Preview preview = painter.account();
    preview.exposure = scene.exposure > 0 ? scene.exposure : exposure_of(shown);
    const int step = shot.tile + kGap;
    preview.picture = blank(columns * step - kGap, rows * step - kGap);
    auto pixels = shown.begin();
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row)
            put(preview.picture, *pixels++, shot.tile, column * step, row * step, preview.exposure);
    return preview;
}

} // namespace scree
