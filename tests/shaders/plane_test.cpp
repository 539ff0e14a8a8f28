// A baked set as shaders read it: src/shaders/scree_set.glsl, and the example that lights a plane.

#include <Imath/ImathVec.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/filter.h"
#include "shaders/gl_fixture.h"
#include "shaders/packed_set.h"

namespace scree::test {
namespace {

using Imath::V2f;
using Imath::V3f;

constexpr float kPi = 3.14159265F;

V3f toward(float theta, float phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

enum Model { kPlainMip, kMeanColor, kColorByHeight };

/// What the plane is lit with and seen by.
struct Scene {
    V3f to_eye{0, 0, 1}; ///< for a viewer far away
    V3f light{0, 0, 1};
    float base_alpha = 0.3F;
    V3f f0{0.04F, 0.05F, 0.06F};
    int model = kColorByHeight;
};

const V3f kIrradiance(6, 5.8F, 5.4F);

/// The kernel's C++ front on one texel, read by the names of the files' channels.
V3f radiance(const SampleSet& set, size_t level, int x, int y, const V3f& wo, const Scene& scene)
{
    filter::Slopes<float> slopes = slopes_of(set, level, x, y);
    if (scene.model == kPlainMip)
        slopes = {slopes.mean, {}, 0};
    ColorLook look;
    look.color_model = scene.model == kColorByHeight ? 1 : 0;
    look.light_exponent = filter::masking(scene.light, slopes).lambda;
    const V3f color = visible_color(set, level, x, y, wo, look);
    const float diffuse = filter::diffuse(wo, scene.light, slopes);
    const float specular = filter::specular(wo, scene.light, slopes, scene.base_alpha);
    const V3f half = (wo + scene.light).normalized();
    const V3f fresnel = scene.f0 + (V3f(1) - scene.f0) * std::pow(1 - half.dot(wo), 5.0F);
    return (color * (diffuse / kPi) + fresnel * specular) * kIrradiance;
}

/// A pinhole at `eye` that looks up the plane (towards -y, away from +y), tilted down.
struct Camera {
    V3f eye;
    float down_rad = 0;
    float scale = 1; ///< cotangent of half the field of view, vertically
    float aspect = 4.0F / 3.0F;

    V3f forward() const { return {0, -std::cos(down_rad), -std::sin(down_rad)}; }
    V3f up() const { return {0, -std::sin(down_rad), std::cos(down_rad)}; }

    /// Column by column. y_sign -1: for worlds whose y runs up.
    std::vector<float> world_to_clip(float y_sign = 1) const
    {
        const V3f rows[4] = {V3f(scale / aspect, 0, 0), up() * scale, forward(), forward()};
        const float nearest = 1e-3F;
        std::vector<float> m;
        for (int column = 0; column < 3; ++column)
            for (const V3f& row : rows)
                m.push_back(column == 1 ? y_sign * row[column] : row[column]);
        for (int row = 0; row < 4; ++row)
            m.push_back(-rows[row].dot(eye) - (row == 2 ? 2 * nearest : 0)); // z > -w: w > nearest
        return m;
    }

    /// Where the plane is seen at (x, y) in [-1, 1]; false above the horizon.
    bool hit(float x, float y, V3f& place) const
    {
        const V3f ray = forward() + V3f(x * aspect / scale, 0, 0) + up() * (y / scale);
        if (ray.z >= 0)
            return false;
        place = eye - ray * (eye.z / ray.z);
        return true;
    }
};

/// The example's program with the textures of a set.
class Plane {
public:
    Plane(GlContext& context, const SampleSet& set, GlFilter filter)
        : context_(context), set_(set),
          program_(context.program({"src/shaders/scree_plane.vert"},
                                   {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                                    "src/shaders/scree_set.glsl", "src/shaders/scree_plane.frag"}))
    {
        const PackedSet packed = pack(set);
        textures_ = {{"slope", context.texture(packed.slope, filter)},
                     {"extra", context.texture(packed.extra, filter)},
                     {"color", context.texture(packed.color, filter)},
                     {"color_height", context.texture(packed.color_height, filter)}};
    }

    void show_level(size_t level)
    {
        for (const auto& texture : textures_)
            context_.show_level(texture.second, static_cast<int>(level));
    }

    /// The whole map, seen from far away: as many pixels as texels.
    Image draw(const Scene& scene, size_t level)
    {
        const float w = set_.world_width, h = set_.world_height;
        const Image& size = set_.slope[level];
        const V3f& e = scene.to_eye;
        return draw(scene, {e.x, e.y, e.z, 0}, {0, 0, w, h},
                    {2 / w, 0, 0, 0, 0, 2 / h, 0, 0, 0, 0, 0, 0, -1, -1, 0, 1}, size.width,
                    size.height, false);
    }

    /// A plane of `repeats` maps in the distance; y_sign -1: in a world whose y runs up.
    Image draw(const Scene& scene, const Camera& camera, float repeats, float y_sign, int width,
               int height)
    {
        Scene given = scene;
        given.light.y *= y_sign;
        const float side = repeats * set_.world_width, far = -2 * repeats * set_.world_height;
        const V3f& e = camera.eye;
        return draw(given, {e.x, y_sign * e.y, e.z, 1}, {-side, y_sign * far, side, 0},
                    camera.world_to_clip(y_sign), width, height, y_sign < 0);
    }

private:
    Image draw(const Scene& scene, const std::vector<float>& eye,
               const std::vector<float>& rectangle, const std::vector<float>& world_to_clip,
               int width, int height, bool v_up)
    {
        context_.bind(program_, textures_);
        const auto vector = [](const V3f& v) { return std::vector<float>{v.x, v.y, v.z}; };
        context_.set(program_, "world_size", {set_.world_width, set_.world_height});
        context_.set(program_, "rectangle", rectangle);
        context_.set(program_, "world_to_clip", world_to_clip);
        context_.set(program_, "eye", eye);
        context_.set(program_, "light", vector(scene.light));
        context_.set(program_, "irradiance", vector(kIrradiance));
        context_.set(program_, "f0", vector(scene.f0));
        context_.set(program_, "base_alpha", std::vector<float>{scene.base_alpha});
        context_.set(program_, "model", scene.model);
        context_.set(program_, "v_up", v_up ? 1 : 0);
        return context_.draw(program_, width, height);
    }

    GlContext& context_;
    const SampleSet& set_;
    GLuint program_;
    std::vector<std::pair<std::string, GLuint>> textures_;
};

/// Where SCREE_PICTURES names a folder, what was drawn, for looking at.
void keep_picture(const Image& image, const std::string& name)
{
    const char* folder = std::getenv("SCREE_PICTURES");
    if (folder == nullptr)
        return;
    Image picture{image.width, image.height, {"R", "G", "B"}, {}};
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (int k = 0; k < 3; ++k)
                picture.pixels.push_back(std::pow(std::min(image.at(x, y, k), 1.0F), 1 / 2.2F));
    write_image(std::filesystem::path(folder) / (name + ".png"), picture, "uint8");
}

Camera receding(const SampleSet& set)
{
    Camera camera;
    camera.eye = {0.3F * set.world_width, 0.4F * set.world_height, 0.5F * set.world_height};
    camera.down_rad = 0.35F;
    camera.scale = 1.7F;
    return camera;
}

/// A light ahead, so that the highlight lies on the plane.
Scene against_the_light(int model)
{
    Scene scene;
    scene.light = toward(1.1F, -1.5F);
    scene.base_alpha = 0.15F;
    scene.model = model;
    return scene;
}

/// Two pictures of equal alpha: largest difference relative to the larger pixel of the two.
double largest_relative_difference(const Image& a, const Image& b)
{
    double largest = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int k = 0; k < 3; ++k) {
                const double p = a.at(x, y, k), q = b.at(x, y, k);
                if (p != q)
                    largest = std::max(largest, std::abs(p - q) / std::max(p, q));
            }
    return largest;
}

class PlaneShader : public Glsl {};

// Nearest texels and a direction to the viewer that is the same everywhere leave nothing between
// the file and the formula but the packing.
TEST_P(PlaneShader, PixelsAreThoseOfTheCppFront)
{
    const SampleSet set = bake_sample("bricks", 60, 45);
    Plane plane(context(), set, GlFilter::nearest);
    double worst = 0;
    for (const size_t level : {0U, 2U, 4U, 5U}) {
        plane.show_level(level);
        for (const float theta : {0.0F, 0.7F, 1.45F})
            for (const float light : {0.0F, 1.0F, 1.5F})
                for (const int model : {kPlainMip, kMeanColor, kColorByHeight}) {
                    Scene scene;
                    scene.to_eye = toward(theta, 0.8F).normalized();
                    scene.light = toward(light, -2.0F).normalized();
                    scene.model = model;
                    const Image image = plane.draw(scene, level);
                    for (int y = 0; y < image.height; ++y)
                        for (int x = 0; x < image.width; ++x) {
                            const V3f want = radiance(set, level, x, y, scene.to_eye, scene);
                            ASSERT_EQ(image.at(x, y, 3), 1);
                            for (int k = 0; k < 3; ++k) {
                                const double error = std::abs(image.at(x, y, k) - want[k]) /
                                                     std::max(want.length(), 1e-30F);
                                worst = std::max(worst, error);
                                ASSERT_LE(error, 1e-5)
                                    << image.at(x, y, k) << " for " << want[k] << ", level "
                                    << level << " texel " << x << "," << y << " channel " << k
                                    << " model " << model << " view " << theta << " light "
                                    << light;
                            }
                        }
                }
    }
    RecordProperty("worst", fmt::format("{:.2e}", worst));
}

// The place on the plane, and with it the direction to the viewer, is interpolated in the
// hardware's own way: 1e-4 of the pixel.
TEST_P(PlaneShader, PixelsInPerspectiveAreThoseOfTheCppFront)
{
    const SampleSet set = bake_sample("bricks", 64, 64);
    Plane plane(context(), set, GlFilter::nearest);
    const size_t level = 2;
    plane.show_level(level);
    const int n = set.slope[level].width, width = 80, height = 60;
    const Camera camera = receding(set);
    const Scene scene = against_the_light(kColorByHeight);
    const Image image = plane.draw(scene, camera, 4, 1, width, height);
    const auto center = [](int pixel, int count) {
        return 2 * (static_cast<float>(pixel) + 0.5F) / static_cast<float>(count) - 1;
    };
    int compared = 0;
    double worst = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            V3f place;
            if (image.at(x, y, 3) == 0 || !camera.hit(center(x, width), center(y, height), place))
                continue;
            const float s = place.x / set.world_width * static_cast<float>(n);
            const float t = place.y / set.world_height * static_cast<float>(n);
            const auto near_border = [](float a) { return std::abs(a - std::round(a)) < 0.01F; };
            if (near_border(s) || near_border(t))
                continue; // either texel may be the nearest
            const auto texel = [n](float a) {
                return ((static_cast<int>(std::floor(a)) % n) + n) % n;
            };
            const V3f want =
                radiance(set, level, texel(s), texel(t), (camera.eye - place).normalized(), scene);
            for (int k = 0; k < 3; ++k) {
                const double error =
                    std::abs(image.at(x, y, k) - want[k]) / std::max(want.length(), 1e-30F);
                worst = std::max(worst, error);
                ASSERT_LE(error, 1e-4) << image.at(x, y, k) << " for " << want[k] << ", pixel " << x
                                       << "," << y << " channel " << k;
            }
            ++compared;
        }
    EXPECT_GT(compared, width * height / 2);
    RecordProperty("worst", fmt::format("{:.2e}", worst));
}

TEST_P(PlaneShader, FilteredPlaneIsFiniteAndNotNegative)
{
    for (const std::string kind : {"bricks", "fractal"}) {
        const SampleSet set = bake_sample(kind, 256, 256);
        Plane plane(context(), set, GlFilter::trilinear);
        for (const int model : {kPlainMip, kMeanColor, kColorByHeight}) {
            const Image image =
                plane.draw(against_the_light(model), receding(set), 40, 1, 160, 120);
            keep_picture(image, fmt::format("plane_{}_{}", kind, model));
            int lit = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    for (int k = 0; k < 3; ++k)
                        ASSERT_TRUE(std::isfinite(image.at(x, y, k)) && image.at(x, y, k) >= 0)
                            << image.at(x, y, k) << " at pixel " << x << "," << y << " of " << kind
                            << ", model " << model;
                    lit += image.at(x, y, 3) == 1 && image.at(x, y, 0) > 0 ? 1 : 0;
                }
            EXPECT_GT(lit, image.width * image.height / 2) << kind << ", model " << model;
        }
    }
}

// Light from above, so that nothing but the view hides the mortar between the bricks.
TEST_P(PlaneShader, ColorFollowsHeightAtGrazingViewsOnly)
{
    const SampleSet set = bake_sample("bricks", 64, 64);
    Plane plane(context(), set, GlFilter::nearest);
    const size_t level = 5;
    plane.show_level(level);
    const auto difference = [&](float theta) {
        Scene scene;
        scene.to_eye = toward(theta, 0.8F);
        scene.model = kMeanColor;
        const Image mean = plane.draw(scene, level);
        scene.model = kColorByHeight;
        return largest_relative_difference(mean, plane.draw(scene, level));
    };
    EXPECT_EQ(difference(0), 0);
    EXPECT_LT(difference(0.2F), 1e-3);
    EXPECT_GT(difference(1.4F), 0.02);
}

TEST_P(PlaneShader, SlopesThatAFootprintHoldsSpreadTheHighlight)
{
    const SampleSet set = bake_sample("fractal", 64, 64);
    Plane plane(context(), set, GlFilter::nearest);
    const size_t last = set.slope.size() - 1;
    plane.show_level(last);
    const auto seen_at = [&](int model, float theta) {
        Scene scene;
        scene.to_eye = toward(theta, 0.3F);
        scene.base_alpha = 0.1F;
        scene.f0 = V3f(1); // little but highlight
        scene.model = model;
        return plane.draw(scene, last).at(0, 0, 1);
    };
    EXPECT_GT(seen_at(kPlainMip, 0), 2 * seen_at(kMeanColor, 0)) << "too narrow, so too bright";
    EXPECT_LT(seen_at(kPlainMip, 0.5F), 0.5F * seen_at(kMeanColor, 0.5F)) << "too dark beside it";
}

// The same scene told in a world whose y runs up. Places on the plane differ by their rounding.
TEST_P(PlaneShader, WorldWithVUpShowsTheSamePicture)
{
    const SampleSet set = bake_sample("bricks", 128, 128);
    Plane plane(context(), set, GlFilter::trilinear);
    const Scene scene = against_the_light(kColorByHeight);
    const Image down = plane.draw(scene, receding(set), 4, 1, 80, 60);
    const Image up = plane.draw(scene, receding(set), 4, -1, 80, 60);
    EXPECT_LT(largest_relative_difference(down, up), 1e-3);

    // A test that would pass without the switch shows nothing.
    Scene mirrored = scene;
    mirrored.light.y *= -1;
    EXPECT_GT(largest_relative_difference(down, plane.draw(mirrored, receding(set), 4, -1, 80, 60)),
              0.1);
}

TEST_P(PlaneShader, ExplicitLevelsAndTheOtherFunctionsAreThoseOfTheCppFront)
{
    const SampleSet set = bake_sample("fractal", 60, 45);
    const GLuint program =
        context().program({"tests/shaders/screen.vert"},
                          {"src/kernel/prelude_glsl.h", "src/kernel/scree_filter.h",
                           "src/shaders/scree_set.glsl", "tests/shaders/footprint_lod.frag"});
    const PackedSet packed = pack(set);
    context().bind(program,
                   {{"slope", context().texture(packed.slope, GlFilter::nearest)},
                    {"extra", context().texture(packed.extra, GlFilter::nearest)},
                    {"color", context().texture(packed.color, GlFilter::nearest)},
                    {"color_height", context().texture(packed.color_height, GlFilter::nearest)}});
    const V3f wo = toward(1.3F, 2.5F).normalized();
    const float base_alpha = 0.2F;
    context().set(program, "wo", {wo.x, wo.y, wo.z});
    context().set(program, "base_alpha", std::vector<float>{base_alpha});
    for (const size_t level : {0U, 1U, 3U, 5U}) {
        const int width = set.slope[level].width, height = set.slope[level].height;
        context().set(program, "size", {static_cast<float>(width), static_cast<float>(height)});
        context().set(program, "level", std::vector<float>{static_cast<float>(level)});
        std::array<Image, 3> images;
        for (int what = 0; what < 3; ++what) {
            context().set(program, "what", what);
            images[static_cast<size_t>(what)] = context().draw(program, width, height);
        }
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto slopes = slopes_of(set, level, x, y);
                const V3f normal = filter::normal(filter::visible_slopes(wo, slopes).mean);
                const auto rough = filter::beckmann_roughness(slopes.covariance, base_alpha);
                const float lambda = filter::masking(wo, slopes).lambda;
                const V3f color = visible_color(set, level, x, y, wo, {});
                const float want[3][4] = {{normal.x, normal.y, normal.z, 0},
                                          {rough.alpha_x, rough.alpha_y, rough.angle_rad, 0},
                                          {color.x, color.y, color.z, lambda}};
                for (size_t what = 0; what < 3; ++what)
                    for (int k = 0; k < 4; ++k)
                        ASSERT_NEAR(images[what].at(x, y, k), want[what][k],
                                    1e-5 * std::max(1.0F, want[what][k]))
                            << "what " << what << " number " << k << " level " << level << " texel "
                            << x << "," << y;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Set, PlaneShader, both_dialects(), dialect_name);

} // namespace
} // namespace scree::test
