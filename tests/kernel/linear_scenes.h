#pragma once

#include <cmath>

#include "kernel/linear_light.h"
#include "kernel/linear_light_oracle.h"

namespace scree::test {

/// Root mean square of errors over that of the values they are of.
class RelativeRms {
public:
    void add(double got, double want)
    {
        error_ += (got - want) * (got - want);
        value_ += want * want;
    }
    [[nodiscard]] double value() const { return std::sqrt(error_ / value_); }
    [[nodiscard]] double percent() const { return 100 * value(); }

private:
    double error_ = 0, value_ = 0;
};

/// Cosine of the lowest viewers where nothing else is said; nearer to grazing every step costs
/// more.
constexpr double kLowestView = 0.3;

/// Calls look(scene, angles) for those of `count` scenes at random in which something of the light
/// is seen: the same scenes each time.
/// lowest_view  cosine of the lowest viewers
template <class Look>
void look_at_scenes(int count, double sigma2, const Look& look, double lowest_view = kLowestView)
{
    std::mt19937 random(20);
    for (int i = 0; i < count; ++i) {
        const LinearScene scene = random_scene(random, sigma2, lowest_view);
        const LinearAngles angles = angles_of(scene);
        if (angles.last > angles.first)
            look(scene, angles);
    }
}

/// A light in the plane z = 0, parallel to the surface and facing it, at a distance of 1 on the
/// side of the normal: all of it is above the horizon, whatever the normal, and all but 0.06
/// degrees of the half circle.
inline LinearScene endless_light(const Imath::V3d& viewer, const Imath::V3d& normal, double sigma2)
{
    constexpr double kHalfLength = 1000;
    const Imath::V3d towards = Imath::V3d(normal.x, normal.y, 0).normalized();
    const Imath::V3d along(-towards.y, towards.x, 0);
    LinearScene scene;
    scene.from = towards - along * kHalfLength;
    scene.to = towards + along * kHalfLength;
    scene.light_normal = -towards;
    scene.normal = normal;
    scene.viewer = viewer;
    scene.sigma2 = sigma2;
    return scene;
}

/// A scene as the kernel takes it.
template <typename Real>
filter::LinearLight<Real> light_of(const LinearScene& scene)
{
    using V3 = Imath::Vec3<Real>;
    return {V3(scene.from), V3(scene.to), V3(scene.light_normal)};
}

template <typename Real>
filter::LinearView<Real> view_of(const LinearScene& scene)
{
    using V3 = Imath::Vec3<Real>;
    return filter::linear_view(light_of<Real>(scene), V3(scene.normal), V3(scene.viewer));
}

/// The kernel's Gaussian for lobe_integral(), with k in place of the peak's own.
template <typename Real>
double lobe_of(const filter::LinearView<Real>& view, const filter::LinearPeak<Real>& peak, Real k,
               double sigma2)
{
    Real centre = 0;
    return static_cast<double>(kernel::scree_linear_integral(
        view.first, view.last, peak.phi, k, peak.tan2, static_cast<Real>(sigma2), centre));
}

/// k of a peak with the bend.
inline double curved_k(const filter::LinearView<double>& view,
                       const filter::LinearPeak<double>& peak)
{
    const double ln = view.normal.x * std::cos(peak.phi) + view.normal.y * std::sin(peak.phi);
    return kernel::scree_linear_curved_k(peak.k, peak.tan2, view.viewer.dot(view.normal), ln);
}

} // namespace scree::test
