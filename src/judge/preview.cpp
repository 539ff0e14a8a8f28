#include "judge/preview.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "math/error.h"
#include "reference/render.h"

namespace scree {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;
constexpr Rgbf kSky{0.32F, 0.42F, 0.55F};
constexpr Rgbf kLine{1, 1, 1};

Vec3f single(const Vec3& w)
{
    return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
}

/// Radiance over irradiance of a pixel, and how much of it shows the surface.
struct Pixel {
    Rgbf radiance{};
    float covered = 0;
};

/// A rectangle of pixels, row by row.
using Pixels = std::vector<Pixel>;

/// Where a set is looked up for what a pixel sees of the plane.
TexturePlace texture_place(const reference::PlaneView& view, const Manifest& manifest)
{
    const double per_s = 1 / (manifest.width * manifest.texel_width);
    const double per_t = 1 / (manifest.height * manifest.texel_height);
    // Far away floats have no digits left for the fraction; the maps repeat.
    auto fraction = [](double place) { return static_cast<float>(place - std::floor(place)); };
    auto of = [](double change) { return static_cast<float>(change); };
    return {fraction(view.place.x * per_s), fraction(view.place.y * per_t),
            of(view.along_x.x * per_s),     of(view.along_x.y * per_t),
            of(view.along_y.x * per_s),     of(view.along_y.y * per_t)};
}

Rgbf shaded(const SetLookup& set, const SetTexel& texel, const PreviewScene& scene,
            PreviewPart part, const Vec3f& wo)
{
    const Vec3f wi = single(scene.light);
    if (part == PreviewPart::plain)
        return plain_radiance(texel, scene.material, wo, wi);
    const auto slopes = slopes_of(texel);
    const float exponent = filter::masking(wo, slopes).lambda + filter::masking(wi, slopes).lambda;
    const SetColors& colors = set.colors();
    return radiance(slopes, visible_color(texel, colors, colors.best(), false, wo, exponent),
                    scene.material, wo, wi);
}

/// Plane pixels by lookups, one a pixel, as a renderer would.
Pixels look_up(const SetLookup& set, const PreviewScene& scene, PreviewPart part,
               const reference::Camera& camera, const reference::PictureArea& area)
{
    const auto columns = static_cast<size_t>(area.columns);
    Pixels pixels(columns * static_cast<size_t>(area.rows));
    tbb::parallel_for(0, area.rows, [&](int row) {
        for (size_t i = 0; i < columns; ++i) {
            const double x = area.first_column + static_cast<double>(i) + 0.5;
            const auto view = camera.view_of_plane(set.manifest().h0, x, row + 0.5);
            if (!view)
                continue;
            const SetTexel texel = set.at(texture_place(*view, set.manifest()));
            pixels[static_cast<size_t>(row) * columns + i] = {
                shaded(set, texel, scene, part, single(view->to_viewer)), texel.coverage};
        }
    });
    return pixels;
}

Pixel pixel_of(const reference::Radiance& seen, const Material& material)
{
    const double specular = static_cast<double>(material.f0) * seen.specular;
    Pixel pixel;
    for (size_t c = 0; c < 3; ++c)
        pixel.radiance[c] = static_cast<float>(seen.diffuse[c] + specular);
    pixel.covered = static_cast<float>(seen.covered);
    return pixel;
}

/// The truth with its two halves.
struct TruePixels {
    Pixels all;
    std::array<Pixels, 2> halves;
};

/// Draws areas seen through cameras and keeps account of what that tells.
class Painter {
public:
    Painter(const SetLookup& set, const reference::DisplacedSurface* surface,
            const PreviewScene& scene, int areas)
        : set_(set), surface_(surface), scene_(scene), areas_(areas)
    {}

    Pixels paint(PreviewPart part, const reference::Camera& camera,
                 const reference::PictureArea& area, double angle_deg)
    {
        if (part != PreviewPart::truth)
            return look_up(set_, scene_, part, camera, area);
        TruePixels truth = trace(camera, area);
        for (const PreviewPart other : {PreviewPart::plain, PreviewPart::set})
            compare(other, look_up(set_, scene_, other, camera, area), truth, angle_deg);
        return std::move(truth.all);
    }

    /// The errors and the account; the caller draws the picture.
    Preview account()
    {
        account_.noise = true_square_ > 0 ? std::sqrt(noise_square_ / true_square_) : 0;
        return std::move(account_);
    }

private:
    TruePixels trace(const reference::Camera& camera, const reference::PictureArea& area)
    {
        reference::RenderPlan plan;
        plan.light = scene_.light;
        plan.base_alpha = static_cast<double>(scene_.material.base_alpha);
        plan.grid = scene_.grid;
        plan.seed = scene_.seed + static_cast<uint64_t>(traced_);
        const auto begin = std::chrono::steady_clock::now();
        const auto rendering =
            reference::render(*surface_, camera, area, plan, [this](double done) {
                if (scene_.progress)
                    scene_.progress((traced_ + done) / areas_);
            });
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
        ++traced_;
        account_.seconds += passed.count();
        account_.rays += rendering.rays;
        account_.samples += static_cast<long long>(rendering.pixels.size()) * plan.grid * plan.grid;
        TruePixels truth;
        for (const auto& pixel : rendering.pixels) {
            truth.all.push_back(pixel_of(pixel.all, scene_.material));
            for (size_t half = 0; half < 2; ++half)
                truth.halves[half].push_back(pixel_of(pixel.halves[half], scene_.material));
        }
        return truth;
    }

    void compare(PreviewPart part, const Pixels& pixels, const TruePixels& truth, double angle_deg)
    {
        constexpr float kWhole = 0.999F;
        double square = 0, true_square = 0, sum = 0, true_sum = 0, noise = 0;
        for (size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i].covered < kWhole || truth.all[i].covered < kWhole)
                continue;
            for (size_t c = 0; c < 3; ++c) {
                auto value = [c](const Pixel& pixel) {
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
            return;
        account_.errors.push_back(
            {angle_deg, part, sum / true_sum, std::sqrt(square / true_square)});
        noise_square_ += noise;
        true_square_ += true_square;
    }

    const SetLookup& set_;
    const reference::DisplacedSurface* surface_;
    const PreviewScene& scene_;
    int areas_, traced_ = 0;
    double noise_square_ = 0, true_square_ = 0;
    Preview account_;
};

/// The exposure that makes the brightest of what is shown, but for 2 %, 0.8.
double fitting_exposure(const std::vector<Pixels>& shown)
{
    std::vector<float> brightest;
    for (const Pixels& pixels : shown)
        for (const Pixel& pixel : pixels)
            if (pixel.covered > 0)
                brightest.push_back(
                    *std::max_element(pixel.radiance.begin(), pixel.radiance.end()));
    if (brightest.empty())
        return 1;
    const auto at = brightest.begin() + static_cast<std::ptrdiff_t>(brightest.size() * 98 / 100);
    std::nth_element(brightest.begin(), at, brightest.end());
    return *at > 0 ? 0.8 / static_cast<double>(*at) : 1;
}

Picture blank(int width, int height)
{
    Picture picture{width, height, {}};
    for (long long i = 0; i < static_cast<long long>(width) * height; ++i)
        picture.rgb.insert(picture.rgb.end(), kLine.begin(), kLine.end());
    return picture;
}

/// Puts pixels into a picture, before the sky.
void put(Picture& picture, const Pixels& pixels, int columns, int left, int top, double exposure)
{
    for (size_t i = 0; i < pixels.size(); ++i) {
        const int x = left + static_cast<int>(i) % columns, y = top + static_cast<int>(i) / columns;
        float* rgb = &picture.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) +
                                       static_cast<size_t>(x))];
        for (size_t c = 0; c < 3; ++c)
            rgb[c] = pixels[i].covered * pixels[i].radiance[c] * static_cast<float>(exposure) +
                     (1 - pixels[i].covered) * kSky[c];
    }
}

void check_camera(const reference::Camera& camera, const reference::DisplacedSurface& surface)
{
    const double eye = camera.ray(0, 0).origin.z;
    if (eye <= surface.highest())
        throw Error(fmt::format("the camera would be at height {:.3g}, inside a surface that "
                                "reaches up to {:.3g}; show more repeats, or a smaller view angle",
                                eye, surface.highest()));
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
    const Manifest& manifest = set.manifest();
    reference::Aim aim;
    aim.target = {manifest.width * manifest.texel_width / 2,
                  manifest.height * manifest.texel_height / 2};
    aim.plane = manifest.h0;
    aim.angle_rad = shot.angle_deg * kRadPerDegree;
    aim.azimuth_rad = shot.azimuth_deg * kRadPerDegree;
    aim.width = shot.repeats * manifest.width * manifest.texel_width;
    aim.columns = shot.width;
    aim.rows = shot.height;
    const auto camera = reference::Camera::pinhole(aim, shot.field_of_view_deg * kRadPerDegree);
    if (surface != nullptr)
        check_camera(camera, *surface);

    Painter painter(set, surface, scene, 1);
    const int parts = static_cast<int>(scene.parts.size());
    std::vector<Pixels> shown;
    std::vector<reference::PictureArea> areas;
    for (int i = 0; i < parts; ++i) {
        const int first = i * shot.width / parts, end = (i + 1) * shot.width / parts;
        areas.push_back({first, end - first, shot.height});
        shown.push_back(painter.paint(scene.parts[static_cast<size_t>(i)], camera, areas.back(),
                                      shot.angle_deg));
    }
    Preview preview = painter.account();
    preview.exposure = scene.exposure > 0 ? scene.exposure : fitting_exposure(shown);
    preview.picture = blank(shot.width, shot.height);
    for (size_t i = 0; i < shown.size(); ++i) {
        put(preview.picture, shown[i], areas[i].columns, areas[i].first_column, 0,
            preview.exposure);
        for (int y = 0; i > 0 && y < shot.height; ++y) {
            const auto at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(shot.width) +
                                 static_cast<size_t>(areas[i].first_column));
            std::copy(kLine.begin(), kLine.end(),
                      preview.picture.rgb.begin() + static_cast<std::ptrdiff_t>(at));
        }
    }
    return preview;
}

Preview draw_strip(const SetLookup& set, const reference::DisplacedSurface* surface,
                   const PreviewScene& scene, const StripShot& shot)
{
    constexpr int kGap = 2;
    const Manifest& manifest = set.manifest();
    const int tiles = static_cast<int>(shot.angles_deg.size());
    Painter painter(set, surface, scene, tiles);
    std::vector<Pixels> shown; // parts of the first angle, of the second, ...
    for (const double angle : shot.angles_deg) {
        reference::Aim aim;
        aim.target = {manifest.width * manifest.texel_width / 2,
                      manifest.height * manifest.texel_height / 2};
        aim.plane = manifest.h0;
        aim.angle_rad = angle * kRadPerDegree;
        aim.azimuth_rad = shot.azimuth_deg * kRadPerDegree;
        aim.width = shot.tile * shot.texels_per_pixel * manifest.texel_width;
        aim.columns = aim.rows = shot.tile;
        const double top = surface != nullptr ? surface->highest() : manifest.height_max;
        const auto camera = reference::Camera::distant(aim, top + manifest.texel_width);
        for (const PreviewPart part : scene.parts)
            shown.push_back(painter.paint(part, camera, {0, shot.tile, shot.tile}, angle));
    }
    Preview preview = painter.account();
    preview.exposure = scene.exposure > 0 ? scene.exposure : fitting_exposure(shown);
    const int rows = static_cast<int>(scene.parts.size()), step = shot.tile + kGap;
    preview.picture = blank(tiles * step - kGap, rows * step - kGap);
    for (int i = 0; i < tiles * rows; ++i)
        put(preview.picture, shown[static_cast<size_t>(i)], shot.tile, i / rows * step,
            i % rows * step, preview.exposure);
    return preview;
}

} // namespace scree
