#include "kernel/linear_cases.h"

#include <cmath>

#include "kernel/linear_light_oracle.h"
#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_filter.h"
// after it
#include "kernel/scree_linear_light.h"
// after both
#include "kernel/linear_outputs.h"
} // namespace scree::kernel

namespace scree::test {

namespace {

using Imath::V3d;

LinearCase case_of(const std::string& name, const LinearScene& scene)
{
    LinearCase row;
    row.name = name;
    size_t i = 0;
    for (const V3d& v : {scene.from, scene.to, scene.light_normal, scene.normal, scene.viewer})
        for (int axis = 0; axis < 3; ++axis)
            row.in[i++] = static_cast<float>(v[axis]);
    row.in[i++] = static_cast<float>(0.6 * scene.sigma2);
    row.in[i++] = static_cast<float>(0.3 * scene.sigma2);
    row.in[i++] = static_cast<float>(std::sqrt(0.1 * scene.sigma2));
    return row;
}

LinearScene above(const V3d& from, const V3d& to, const V3d& viewer)
{
    LinearScene scene;
    scene.from = from;
    scene.to = to;
    scene.light_normal = V3d(0, 0, -1);
    scene.normal = V3d(0, 0, 1);
    scene.viewer = viewer.normalized();
    return scene;
}

} // namespace

std::vector<LinearCase> linear_cases()
{
    std::vector<LinearCase> rows;
    std::mt19937 random(7);
    for (const double sigma2 : {0.002, 0.02, 0.3})
        for (int i = 0; i < 150; ++i)
            rows.push_back(
                case_of("random " + std::to_string(i), random_scene(random, sigma2, 0.1)));
    const V3d left(-2, 0.3, 1), right(2, 0.3, 1);
    rows.push_back(case_of("below", above(-left, -right, V3d(0.1, 0.2, 1))));
    rows.push_back(case_of("no length", above(left, left, V3d(0.1, 0.2, 1))));
    rows.push_back(
        case_of("across the horizon", above(V3d(-2, 0.5, -1), V3d(2, 0.6, 1), V3d(0.3, 0.2, 1))));
    rows.push_back(case_of("far and short",
                           above(V3d(0.1, 300, 200), V3d(0.3, 300, 200), V3d(0.1, -0.9, 0.7))));
    return rows;
}

template <typename Real>
std::array<Real, kLinearOutputs> evaluate_linear(const LinearCase& row)
{
    const auto in = [&](size_t i) { return static_cast<Real>(row.in[i]); };
    std::array<Real, kLinearOutputs> o{};
    kernel::linear_outputs(in(0), in(1), in(2), in(3), in(4), in(5), in(6), in(7), in(8), in(9),
                           in(10), in(11), in(12), in(13), in(14), in(15), in(16), in(17), o[0],
                           o[1], o[2], o[3], o[4], o[5], o[6], o[7], o[8], o[9], o[10], o[11],
                           o[12], o[13], o[14], o[15], o[16], o[17], o[18], o[19]);
    return o;
}

template std::array<float, kLinearOutputs> evaluate_linear<float>(const LinearCase&);
template std::array<double, kLinearOutputs> evaluate_linear<double>(const LinearCase&);

} // namespace scree::test
