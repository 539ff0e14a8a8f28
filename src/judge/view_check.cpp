#include "judge/view_check.h"

#include <algorithm>
#include <cmath>

#include "judge/picked_texels.h"

namespace scree {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

/// Half the difference of two halves, the standard error of their mean; 0 where one of them saw
/// nothing (its weight is 0): that tells nothing, and an error it were taken off would look
/// smaller.
double half_difference(double weight0, double weight1, double value0, double value1)
{
    return weight0 > 0 && weight1 > 0 ? (value0 - value1) / 2 : 0;
}

/// Weighted squares of errors and of what they are relative to.
struct Squares {
    double set = 0, plain = 0, noise = 0, truth = 0;

    void add(double weight, double of_set, double of_plain, double of_noise, double of_truth)
    {
        set += weight * of_set * of_set;
        plain += weight * of_plain * of_plain;
        noise += weight * of_noise * of_noise;
        truth += weight * of_truth * of_truth;
    }
    void add(const Squares& other)
    {
        set += other.set;
        plain += other.plain;
        noise += other.noise;
        truth += other.truth;
    }
    [[nodiscard]] ViewError relative_to(double square) const
    {
        auto root = [square](double sum) { return square > 0 ? std::sqrt(sum / square) : 0; };
        return {root(set), root(plain), root(noise)};
    }
    [[nodiscard]] ViewError relative() const { return relative_to(truth); }
};

/// Sums over the footprints of one level under one angle.
struct Sums {
    int footprints = 0;
    double area = 0, facing = 0; ///< weights
    Squares color, radiance, masking, slope, covariance;
    std::vector<double> models; ///< squares of the color's errors

    void add(const Sums& other)
    {
        footprints += other.footprints;
        area += other.area;
        facing += other.facing;
        color.add(other.color);
        radiance.add(other.radiance);
        masking.add(other.masking);
        slope.add(other.slope);
        covariance.add(other.covariance);
        models.resize(other.models.size());
        for (size_t i = 0; i < models.size(); ++i)
            models[i] += other.models[i];
    }
};

/// Adds what one view sees of one footprint.
class ViewComparison {
public:
    ViewComparison(const SetColors& colors, const Material& material,
                   const std::vector<Vec3>& lights)
        : colors_(colors), material_(material), lights_(lights)
    {}

    void add(const SetTexel& texel, const PlannedView& view, size_t view_index,
             const reference::Estimate& truth, Sums& sums) const
    {
        const reference::Seen& seen = truth.all.seen[view_index];
        const auto half = [&truth, view_index](size_t i) -> const reference::Seen& {
            return truth.halves[i].seen[view_index];
        };
        const Vec3f wo(view.wo);
        const auto slopes = slopes_of(texel);
        const auto masking = filter::masking(wo, slopes);
        sums.area += seen.area;
        sums.facing += seen.facing;
        sums.masking.add(
            seen.facing, static_cast<double>(masking.g1) - seen.g1(), 1 - seen.g1(),
            half_difference(half(0).facing, half(1).facing, half(0).g1(), half(1).g1()), 1);
        add_colors(texel, wo, seen, half(0), half(1), sums);
        add_slopes(slopes, filter::visible_slopes(wo, slopes), seen, half(0), half(1), sums);
        for (size_t i = 0; i < lights_.size(); ++i)
            add_light(texel, wo, lights_[i], view_index * lights_.size() + i, truth, seen.area,
                      sums);
    }

private:
    void add_colors(const SetTexel& texel, const Vec3f& wo, const reference::Seen& seen,
                    const reference::Seen& half0, const reference::Seen& half1, Sums& sums) const
    {
        sums.models.resize(colors_.models.size());
        for (size_t m = 0; m < colors_.models.size(); ++m) {
            const Rgbf shown = visible_color(texel, colors_, colors_.models[m], wo);
            const bool is_best = m + 1 == colors_.models.size();
            for (size_t i = 0; i < 3; ++i) {
                const double error = static_cast<double>(shown[i]) - seen.color[i];
                sums.models[m] += seen.area * error * error;
                if (is_best)
                    sums.color.add(
                        seen.area, error, static_cast<double>(texel.color[i]) - seen.color[i],
                        half_difference(half0.area, half1.area, half0.color[i], half1.color[i]),
                        seen.color[i]);
            }
        }
    }

    static void add_slopes(const filter::Slopes<float>& baked,
                           const filter::VisibleSlopes<float>& shown, const reference::Seen& seen,
                           const reference::Seen& half0, const reference::Seen& half1, Sums& sums)
    {
        for (int i = 0; i < 2; ++i)
            sums.slope.add(seen.area, static_cast<double>(shown.mean[i]) - seen.slope[i],
                           static_cast<double>(baked.mean[i]) - seen.slope[i],
                           half_difference(half0.area, half1.area, half0.slope[i], half1.slope[i]),
                           0);
        auto entry = [](const filter::Covariance<float>& c, size_t i) {
            return static_cast<double>(i == 0 ? c.ss : i == 1 ? c.st : c.tt);
        };
        for (size_t i = 0; i < 3; ++i) {
            const double truth = seen.covariance[i];
            // st stands for two entries of the matrix.
            sums.covariance.add(
                seen.area * (i == 1 ? 2 : 1), entry(shown.covariance, i) - truth,
                entry(baked.covariance, i) - truth,
                half_difference(half0.area, half1.area, half0.covariance[i], half1.covariance[i]),
                0);
        }
    }

    void add_light(const SetTexel& texel, const Vec3f& wo, const Vec3& light, size_t index,
                   const reference::Estimate& truth, double area, Sums& sums) const
    {
        const size_t view = index / lights_.size();
        const auto f0 = static_cast<double>(material_.f0);
        const Vec3f wi(light);
        const Rgbf shown = set_radiance(texel, colors_, material_, wo, wi);
        const Rgbf plain = plain_radiance(texel, material_, wo, wi);
        const reference::Rgb seen = radiance_of(truth.all.lit[index], f0);
        const reference::Rgb half0 = radiance_of(truth.halves[0].lit[index], f0);
        const reference::Rgb half1 = radiance_of(truth.halves[1].lit[index], f0);
        for (size_t i = 0; i < 3; ++i)
            sums.radiance.add(area, static_cast<double>(shown[i]) - seen[i],
                              static_cast<double>(plain[i]) - seen[i],
                              half_difference(truth.halves[0].seen[view].area,
                                              truth.halves[1].seen[view].area, half0[i], half1[i]),
                              seen[i]);
    }

    const SetColors& colors_;
    const Material& material_;
    const std::vector<Vec3>& lights_;
};

ViewErrors errors_of(const Sums& sums, int level, double angle_deg, double rms_slope)
{
    ViewErrors errors;
    errors.level = level;
    errors.angle_deg = angle_deg;
    errors.footprints = sums.footprints;
    errors.color = sums.color.relative();
    errors.radiance = sums.radiance.relative();
    errors.masking = sums.masking.relative_to(sums.facing);
    const double square = rms_slope * rms_slope;
    errors.slope = sums.slope.relative_to(sums.area * square);
    errors.covariance = sums.covariance.relative_to(sums.area * square * square);
    for (const double model : sums.models)
        errors.models.push_back(sums.color.truth > 0 ? std::sqrt(model / sums.color.truth) : 0);
    return errors;
}

double rms_slope_of(const Manifest& manifest)
{
    return manifest.levels.front().rms_slope.value_or(0);
}

} // namespace

Vec3 direction(double angle_deg, double azimuth_deg)
{
    const double angle = angle_deg * kRadPerDegree, azimuth = azimuth_deg * kRadPerDegree;
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
            std::cos(angle)};
}

std::vector<PlannedView> views_of(const ViewPlan& plan)
{
    std::vector<PlannedView> views;
    for (size_t angle = 0; angle < plan.angles_deg.size(); ++angle) {
        const int azimuths = plan.angles_deg[angle] > 0 ? plan.azimuths : 1;
        for (int i = 0; i < azimuths; ++i)
            views.push_back({direction(plan.angles_deg[angle], 360.0 * i / azimuths), angle});
    }
    return views;
}

std::vector<Vec3> lights_of(const ViewPlan& plan)
{
    std::vector<Vec3> lights;
    for (const auto& [angle, azimuth] : plan.lights_deg)
        lights.push_back(direction(angle, azimuth));
    return lights;
}

ViewCheck check_views(SetReader& set, const reference::DisplacedSurface& surface,
                      const ViewPlan& plan, const std::function<void(double)>& progress)
{
    const std::vector<PickedTexel> picked = pick_texels(set, 0, plan.footprints, plan.seed);
    const std::vector<PlannedView> views = views_of(plan);
    reference::GatherPlan gathering;
    for (const PlannedView& view : views)
        gathering.views.push_back(view.wo);
    gathering.lights = lights_of(plan);
    gathering.base_alpha = static_cast<double>(plan.material.base_alpha);
    gathering.grid = plan.grid;
    gathering.seed = plan.seed;
    const GatheredTexels gathered = gather_texels(surface, picked, gathering, progress);
    const auto& truths = gathered.truths;
    ViewCheck check;
    check.samples = gathered.samples;
    check.rays = gathered.rays;
    check.seconds = gathered.seconds;

    const auto levels = set.manifest().levels.size();
    std::vector<std::vector<Sums>> sums(levels, std::vector<Sums>(plan.angles_deg.size()));
    const ViewComparison comparison(set.colors(), plan.material, gathering.lights);
    for (size_t i = 0; i < picked.size(); ++i) {
        auto& of_level = sums[static_cast<size_t>(picked[i].level)];
        for (Sums& of_angle : of_level)
            ++of_angle.footprints;
        for (size_t v = 0; v < views.size(); ++v)
            comparison.add(picked[i].texel, views[v], v, truths[i], of_level[views[v].angle]);
    }

    check.rms_slope = rms_slope_of(set.manifest());
    for (const ColorModel model : set.colors().models)
        check.models.push_back(color_model_name(model));
    Sums of_all;
    for (size_t angle = 0; angle < plan.angles_deg.size(); ++angle) {
        Sums of_angle;
        for (size_t level = 0; level < levels; ++level) {
            of_angle.add(sums[level][angle]);
            check.levels.push_back(errors_of(sums[level][angle], static_cast<int>(level),
                                             plan.angles_deg[angle], check.rms_slope));
        }
        of_all.add(of_angle);
        check.all.push_back(errors_of(of_angle, -1, plan.angles_deg[angle], check.rms_slope));
    }
    of_all.footprints = static_cast<int>(picked.size());
    check.all.push_back(errors_of(of_all, -1, -1, check.rms_slope));
    return check;
}

} // namespace scree
