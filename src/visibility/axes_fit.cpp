#include "visibility/axes_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace scree {

namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

/// Added to the diagonal of A^T A, whose largest numbers are about as many as there are samples.
/// Measured on whole maps: 0.001 and 0.1 leave more [docs/visibility.md].
constexpr double kRidge = 0.01;

/// The angle before the first node that the first sampled one lies halfway to, of that node.
constexpr double kBeforeFirst = 0.6;

/// Inverts a symmetric positive definite matrix, row by row, by its Cholesky factor.
std::vector<double> inverse_of(std::vector<double> m, size_t n)
{
    for (size_t i = 0; i < n; ++i) // m becomes L, below the diagonal
        for (size_t j = 0; j <= i; ++j) {
            double sum = m[i * n + j];
            for (size_t k = 0; k < j; ++k)
                sum -= m[i * n + k] * m[j * n + k];
            m[i * n + j] = i == j ? std::sqrt(sum) : sum / m[j * n + j];
        }
    std::vector<double> inverse(n * n);
    for (size_t column = 0; column < n; ++column) {
        std::vector<double> x(n);
        x[column] = 1;
        for (size_t i = 0; i < n; ++i) {
            for (size_t k = 0; k < i; ++k)
                x[i] -= m[i * n + k] * x[k];
            x[i] /= m[i * n + i];
        }
        for (size_t i = n; i-- > 0;) {
            for (size_t k = i + 1; k < n; ++k)
                x[i] -= m[k * n + i] * x[k];
            x[i] /= m[i * n + i];
        }
        for (size_t i = 0; i < n; ++i)
            inverse[i * n + column] = x[i];
    }
    return inverse;
}

} // namespace

AxesFit::AxesFit(const VisibilityPlan& plan) : plan_(plan)
{
    assert(plan.axes && !plan.node_angles_deg.empty());
    double before = kBeforeFirst * plan.node_angles_deg.front();
    for (const double node : plan.node_angles_deg) {
        tangents_.push_back(std::tan(node * kRadian));
        angles_deg_.push_back((before + node) / 2);
        angles_deg_.push_back(node);
        before = node;
    }
    const auto n = static_cast<size_t>(plan.components());
    std::vector<double> normal(n * n);
    for (const double angle : angles_deg_)
        for (int j = 0; j < plan.azimuths; ++j) {
            const auto view = shares({angle, swept_azimuth_deg(plan, j)});
            for (const TableShare& a : view)
                for (const TableShare& b : view)
                    normal[static_cast<size_t>(a.component) * n +
                           static_cast<size_t>(b.component)] += a.weight * b.weight;
        }
    for (size_t i = 0; i < n; ++i)
        normal[i * n + i] += kRidge;
    for (const double number : inverse_of(std::move(normal), n))
        inverse_.push_back(static_cast<float>(number));
}

std::vector<TableShare> AxesFit::shares(const ViewAngles& view) const
{
    const double tangent = std::tan(view.angle_deg * kRadian);
    const double turned = (view.azimuth_deg - plan_.axis_deg) * kRadian;
    const double x = tangent * std::cos(turned), y = tangent * std::sin(turned);
    std::vector<TableShare> shares;
    add_shares(tangent, 0, shares);
    add_shares(std::abs(x), x < 0 ? 1 : 2, shares);
    add_shares(std::abs(y), y < 0 ? 3 : 4, shares);
    return shares;
}

/// Of the nodes on both sides of a tangent >= 0.
void AxesFit::add_shares(double tangent, int term, std::vector<TableShare>& shares) const
{
    const int outer = static_cast<int>(
        std::lower_bound(tangents_.begin(), tangents_.end() - 1, tangent) - tangents_.begin());
    const double far = tangents_[static_cast<size_t>(outer)];
    const double near = outer > 0 ? tangents_[static_cast<size_t>(outer) - 1] : 0;
    const double share = std::min((tangent - near) / (far - near), 1.0);
    const int terms = plan_.terms();
    if (outer > 0)
        shares.push_back({terms * (outer - 1) + term, 1 - share});
    shares.push_back({terms * outer + term, share});
}

} // namespace scree
