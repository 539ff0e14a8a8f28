#pragma once

#include <cstddef>
#include <vector>

namespace scree::test {

/// Weighted least squares of a few unknowns, by the normal equations.
class LeastSquares {
public:
    explicit LeastSquares(size_t unknowns);

    /// One equation: row . x = right.
    void add(const std::vector<double>& row, double right, double weight);

    /// The x closest to all. A hair of a penalty on its size, a millionth of the equations' own,
    /// stands in for equations that are missing; 0 when there are none.
    [[nodiscard]] std::vector<double> solution() const;

private:
    size_t size_;
    std::vector<double> matrix_, right_; ///< size x size, its lower half; size
};

} // namespace scree::test
