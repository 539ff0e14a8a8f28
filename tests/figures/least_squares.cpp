#include "figures/least_squares.h"

#include <cmath>

namespace scree::test {

LeastSquares::LeastSquares(size_t unknowns)
    : size_(unknowns), matrix_(unknowns * unknowns), right_(unknowns)
{}

void LeastSquares::add(const std::vector<double>& row, double right, double weight)
{
    for (size_t i = 0; i < size_; ++i) {
        right_[i] += weight * row[i] * right;
        for (size_t j = 0; j <= i; ++j)
            matrix_[i * size_ + j] += weight * row[i] * row[j];
    }
}

std::vector<double> LeastSquares::solution() const
{
    constexpr double kPenalty = 1e-6;
    double trace = 0;
    for (size_t i = 0; i < size_; ++i)
        trace += matrix_[i * size_ + i];
    std::vector<double> x(size_);
    if (!(trace > 0))
        return x;
    // Cholesky: matrix = L L^T, forwards by L, backwards by its transpose.
    std::vector<double> l = matrix_;
    for (size_t i = 0; i < size_; ++i) {
        l[i * size_ + i] += kPenalty * trace / static_cast<double>(size_);
        for (size_t j = 0; j <= i; ++j) {
            for (size_t k = 0; k < j; ++k)
                l[i * size_ + j] -= l[i * size_ + k] * l[j * size_ + k];
            l[i * size_ + j] =
                i == j ? std::sqrt(l[i * size_ + i]) : l[i * size_ + j] / l[j * size_ + j];
        }
    }
    for (size_t i = 0; i < size_; ++i) {
        x[i] = right_[i];
        for (size_t k = 0; k < i; ++k)
            x[i] -= l[i * size_ + k] * x[k];
        x[i] /= l[i * size_ + i];
    }
    for (size_t i = size_; i-- > 0;) {
        for (size_t k = i + 1; k < size_; ++k)
            x[i] -= l[k * size_ + i] * x[k];
        x[i] /= l[i * size_ + i];
    }
    return x;
}

} // namespace scree::test
