#include "chart/methods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/normal.h"
#include "math/vec.h"
#include "support/some_footprint.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A plane of one color: no spread of anything.
FootprintData plane(const Vec2& slope, const Rgbf& color, float h)
{
    FootprintData data;
    const auto s = static_cast<float>(slope.x), t = static_cast<float>(slope.y);
    data.set.color = color;
    data.set.slope = {s, s * s, s * t, t, t * t};
    data.set.h = h;
    data.set.hh = h * h;
    for (size_t c = 0; c < 3; ++c) {
        data.set.color_height[c] = color[c] * h;
        data.set.color_s[c] = color[c] * s;
        data.set.color_t[c] = color[c] * t;
    }
    data.sobel = data.set.slope;
    data.normal = filter::normal(filter::Vec2<float>(s, t));
    return data;
}

/// Smith's Lambda of a plane of slope `m` with isotropic Gaussian slopes of deviation sigma.
double lambda(const Vec3& w, const Vec2& m, double sigma)
{
    const double z = (w.z - w.x * m.x - w.y * m.y) / (sigma * std::hypot(w.x, w.y));
    return normal_pdf(z) / z - normal_cdf(-z);
}

// Oracle: Beckmann's lobe about a plane with height-correlated Smith masking, in closed form.
double lobe(const Vec3& wo, const Vec3& wi, const Vec2& m, double alpha)
{
    const Vec3 h = wo + wi;
    const Vec2 off = Vec2(-h.x / h.z, -h.y / h.z) - m;
    const double sigma = alpha / std::sqrt(2);
    const double cos4 = std::pow(h.z * h.z / h.length2(), 2);
    const double d = std::exp(-off.length2() / (alpha * alpha)) / (kPi * alpha * alpha) / cos4;
    const double facing = wo.z - wo.x * m.x - wo.y * m.y;
    return d / (4 * facing * (1 + lambda(wo, m, sigma) + lambda(wi, m, sigma)));
}

TEST(Methods, PlanesLookAlikeToAll)
{
    const Rgbf color = {0.5F, 0.25F, 0.125F};
    const MapTable table = straight_table({0.5, 0.25, 0.125}, {0.5, 0.25, 0.125});
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    for (const Vec2& slope : {Vec2(0, 0), Vec2(0.25, -0.125)})
        for (const double theta_o : {0.1, 0.8, 1.2})
            for (const double theta_i : {0.3, 1.1}) {
                const Vec3 wo = toward(theta_o, 0.7), wi = toward(theta_i, 2.9);
                const Vec3 n = Vec3(-slope.x, -slope.y, 1).normalized();
                const double diffuse = std::max(0.0, n.dot(wi)) / kPi;
                const double specular = 0.04 * lobe(wo, wi, slope, 0.3);
                const FootprintData data = plane(slope, color, 0.75F);
                for (const Method& method : methods()) {
                    const Rgbf seen = method.color(data, setting, Vec3f(wo));
                    const Rgbf lit = method.radiance(data, setting, Vec3f(wo), Vec3f(wi));
                    for (size_t c = 0; c < 3; ++c) {
                        // Moments with a mean lose digits to cancellation: rounding of 0.1 leaves
                        // a deviation of 1e-4, and the slope that is seen moves by as much.
                        EXPECT_NEAR(seen[c] / color[c], 1, 1e-6) << method.name;
                        EXPECT_NEAR(lit[c], static_cast<double>(color[c]) * diffuse + specular,
                                    1e-4 * (diffuse + specular))
                            << method.name << " slope " << slope.x << " theta " << theta_o << " "
                            << theta_i;
                    }
                }
            }
}

/// Every number of a footprint, and the texture it lies in.
struct Channel {
    MethodTexture texture;
    int index; ///< within the texture
    float* value;
};

std::vector<Channel> channels_of(FootprintData& data)
{
    using T = MethodTexture;
    SetTexel& set = data.set;
    std::vector<Channel> all;
    const auto add = [&all](T texture, std::initializer_list<float*> values) {
        int index = 0;
        for (const Channel& channel : all)
            index += channel.texture == texture ? 1 : 0;
        for (float* value : values)
            all.push_back({texture, index++, value});
    };
    const auto add_moments = [&add](T texture, filter::SlopeMoments<float>& of) {
        add(texture, {&of.s, &of.ss, &of.st, &of.t, &of.tt});
    };
    const auto add_color = [&add](T texture, Rgbf& color) {
        add(texture, {&color[0], &color[1], &color[2]});
    };
    add_moments(T::slope, set.slope);
    add_moments(T::sobel, data.sobel);
    add(T::normal, {&data.normal.x, &data.normal.y, &data.normal.z});
    add(T::tail, {&set.tau});
    add(T::height, {&set.h, &set.hh});
    add_color(T::color, set.color);
    add_color(T::colorheight, set.color_height);
    add_color(T::colorslope, set.color_s);
    add_color(T::colorslope, set.color_t);
    for (auto& a : set.rank)
        add_color(T::rank, a);
    add_color(T::exponent, set.exponent);
    const auto add_table = [&add](T texture, float* table, size_t size) {
        for (size_t i = 0; i < size; ++i)
            add(texture, {table + i});
    };
    add_table(T::visible_2x1, data.visible_2x1.data(), data.visible_2x1.size());
    add_table(T::visible_4x1, data.visible_4x1.data(), data.visible_4x1.size());
    add_table(T::visible_4x3, data.visible_4x3.data(), data.visible_4x3.size());
    add_table(T::visible_4x5, data.set.visible.data(), 80);
    add_table(T::visible_axes, data.visible_axes.data(), data.visible_axes.size());
    return all;
}

bool is_read(const Method& method, const Channel& channel)
{
    return std::any_of(method.reads.begin(), method.reads.end(), [&](const Reading& reading) {
        return reading.texture == channel.texture && channel.index < reading.channels;
    });
}

// So bytes per texel are counted right: no more is read than said, and no less. From all sides:
// of a table of visibility a view reads the nodes about it, and one side of an axis.
TEST(Methods, ReadWhatTheySay)
{
    const MapTable table = straight_table({0, 0.1, 0.2}, {0.9, 0.8, 1});
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    std::vector<Vec3f> views;
    for (const double theta : {0.9, 1.3, 1.42, 1.51})
        for (const double phi : {0.5, 2.0, 3.6, 5.2})
            views.emplace_back(toward(theta, phi));
    const Vec3f wi(toward(0.7, 2.5));
    const size_t count = [] {
        FootprintData data;
        return channels_of(data).size();
    }();
    ASSERT_EQ(count, 5U + 5 + 3 + 1 + 2 + 3 + 3 + 6 + 24 + 3 + 8 + 16 + 48 + 80 + 80);
    for (const Method& method : methods())
        for (size_t i = 0; i < count; ++i) {
            const FootprintData data = some_footprint(7);
            FootprintData changed = data;
            const Channel channel = channels_of(changed)[i];
            const bool read = is_read(method, channel);
            *channel.value =
                read ? *channel.value * 1.125F : std::numeric_limits<float>::quiet_NaN();
            bool radiance_changes = false, color_changes = false;
            for (const Vec3f& wo : views) {
                radiance_changes =
                    radiance_changes || method.radiance(data, setting, wo, wi) !=
                                            method.radiance(changed, setting, wo, wi);
                color_changes = color_changes || method.color(data, setting, wo) !=
                                                     method.color(changed, setting, wo);
            }
            EXPECT_EQ(radiance_changes, read)
                << method.name << ", texture " << static_cast<int>(channel.texture) << ", channel "
                << channel.index;
            if (!read) {
                EXPECT_FALSE(color_changes) << method.name;
            }
        }
}

TEST(Methods, NaiveKnowsOfNoSpread)
{
    const MapTable table = straight_table({0, 0, 0}, {1, 1, 1});
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    const Vec3f wo(toward(1.2, 0.4)), wi(toward(0.5, 2.5));
    FootprintData smooth = some_footprint(3), rough = smooth;
    rough.set.slope.ss += 0.5F;
    rough.set.slope.tt += 0.5F;
    rough.normal *= 0.5F; // shorter, but in the same direction
    const auto shows_the_same = [&](const char* name) {
        const Method& method = method_named(name);
        return method.radiance(smooth, setting, wo, wi) == method.radiance(rough, setting, wo, wi);
    };
    EXPECT_TRUE(shows_the_same("naive MIP"));
    EXPECT_FALSE(shows_the_same("Toksvig"));
    EXPECT_FALSE(shows_the_same("LEAN"));
    EXPECT_FALSE(shows_the_same("LEADR"));
}

// LEADR is the kernel on the mean color, here in double; LEAN the same lobe over Lambert.
TEST(Methods, LeadrIsTheKernelAndLeanItsLobe)
{
    const MapTable table = straight_table({0, 0, 0}, {1, 1, 1});
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const double theta : {0.2, 0.9, 1.3}) {
            const FootprintData data = some_footprint(seed);
            const Vec3 wo = toward(theta, 0.4), wi = toward(0.7, 2.5);
            const auto& [s, ss, st, t, tt] = data.set.slope;
            const auto slopes = filter::slopes<double>({s, ss, st, t, tt});
            const double specular = 0.04 * filter::specular(wo, wi, slopes, 0.3);
            const double diffuse = filter::diffuse(wo, wi, slopes) / kPi;
            const double lambert = std::max(0.0, filter::normal(slopes.mean).dot(wi)) / kPi;
            const Rgbf leadr = method_named("LEADR").radiance(data, setting, Vec3f(wo), Vec3f(wi));
            const Rgbf lean = method_named("LEAN").radiance(data, setting, Vec3f(wo), Vec3f(wi));
            for (size_t c = 0; c < 3; ++c) {
                const auto color = static_cast<double>(data.set.color[c]);
                // Single precision: 1e-4 is the kernel's bound.
                EXPECT_NEAR(leadr[c] / (color * diffuse + specular), 1, 1e-4) << seed;
                EXPECT_NEAR(lean[c] / (color * lambert + specular), 1, 1e-4) << seed;
            }
        }
}

// What preview and validate show of a set (shading.h) is what the chart says of it: the visible
// color of the view's Lambda, the radiance with the color of view and light together.
TEST(Methods, ShowWhatASetShows)
{
    struct Twin {
        const char* name;
        ColorModel model;
        bool by_slope, has_tails;
    };
    SetColors colors;
    colors.map_by = "height";
    colors.table = straight_table({0, 0.1, 0.2}, {0.9, 0.8, 1});
    const MethodSetting setting{{0.3F, 0.04F}, &colors.table, some_nodes()};
    const Vec3f wo(toward(1.2, 0.4)), wi(toward(1.35, 2.5));
    for (const Twin& twin : {Twin{"LEADR", ColorModel::mean, false, false},
                             Twin{"visible height", ColorModel::map, false, false},
                             Twin{"linear", ColorModel::height, false, false},
                             Twin{"linear + slope", ColorModel::height, true, false},
                             Twin{"rank 8", ColorModel::rank, false, false},
                             Twin{"rank 4 + slope", ColorModel::rank, true, false},
                             Twin{"rank 4 + slope + tails", ColorModel::rank, true, true}})
        for (unsigned seed = 0; seed < 10; ++seed) {
            FootprintData data = some_footprint(seed);
            if (twin.by_slope)
                std::fill(data.set.rank.begin() + 4, data.set.rank.end(), Rgbf{});
            SetTexel texel = data.set;
            texel.tau = twin.has_tails ? texel.tau : 0;
            const auto slopes = slopes_of(texel);
            const float from = filter::masking(wo, slopes).lambda;
            const float both = from + filter::masking(wi, slopes).lambda;
            ASSERT_GT(both, from);
            const auto seen = [&](float exponent) {
                return color_of_exponent(texel, colors, twin.model, twin.by_slope, wo, exponent);
            };
            const Method& method = method_named(twin.name);
            EXPECT_EQ(method.color(data, setting, wo), seen(from)) << twin.name;
            EXPECT_EQ(method.radiance(data, setting, wo, wi),
                      radiance(slopes, seen(both), setting.material, wo, wi))
                << twin.name;
        }
}

// Where color is a straight line in height and heights are normal, the published model and the
// linear one are the same, and both are E[c] + slope of the line times the visible height's shift.
TEST(Methods, VisibleHeightOfAStraightMapIsLinear)
{
    const Rgb low = {0.1, 0.3, 0.2}, high = {0.9, 0.4, 0.8};
    const MapTable table = straight_table(low, high);
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    for (unsigned seed = 0; seed < 20; ++seed) {
        FootprintData data = some_footprint(seed);
        SetTexel& set = data.set;
        for (size_t c = 0; c < 3; ++c) {
            const double rise = (high[c] - low[c]) / 20, middle = (high[c] + low[c]) / 2;
            set.color[c] = static_cast<float>(middle + rise * static_cast<double>(set.h));
            set.color_height[c] = static_cast<float>(middle * static_cast<double>(set.h) +
                                                     rise * static_cast<double>(set.hh));
        }
        const Vec3f wo(toward(1.45, 0.4));
        const Rgbf published = method_named("visible height").color(data, setting, wo);
        const Rgbf linear = method_named("linear").color(data, setting, wo);
        const auto slopes = filter::slopes(set.slope);
        const double shift =
            static_cast<double>(filter::visible_height(filter::masking(wo, slopes).lambda).mean);
        const double sigma =
            std::sqrt(static_cast<double>(set.hh) - std::pow(static_cast<double>(set.h), 2));
        EXPECT_GT(shift, 0.02) << "the view sees no difference";
        for (size_t c = 0; c < 3; ++c) {
            const double truth =
                static_cast<double>(set.color[c]) + (high[c] - low[c]) / 20 * sigma * shift;
            EXPECT_NEAR(published[c], truth, 1e-5);
            EXPECT_NEAR(linear[c], truth, 1e-4); // E[c h] loses digits, and its fading 1e-5
        }
    }
}

// A color that is a straight line in the rank q has one term; E[q] under the weight q^L is
// (1 + L) / (2 + L).
TEST(Methods, RankTermsBeyondTheFirstAddNothingToALine)
{
    const MapTable table = straight_table({0, 0, 0}, {1, 1, 1});
    const MethodSetting setting{{0.3F, 0.04F}, &table, some_nodes()};
    FootprintData data = some_footprint(5);
    for (size_t n = 1; n < 8; ++n)
        data.set.rank[n] = {0, 0, 0};
    const Vec3f wo(toward(1.3, 0.4));
    const auto L = static_cast<double>(filter::masking(wo, filter::slopes(data.set.slope)).lambda);
    for (const char* name : {"rank 1", "rank 2", "rank 4", "rank 8"}) {
        const Rgbf seen = method_named(name).color(data, setting, wo);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c],
                        static_cast<double>(data.set.color[c]) +
                            static_cast<double>(data.set.rank[0][c]) * (2 * (1 + L) / (2 + L) - 1),
                        1e-6)
                << name;
    }
}

} // namespace
} // namespace scree::test
