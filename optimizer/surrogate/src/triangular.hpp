/// Solving with a Cholesky factor.
#pragma once

#include <Eigen/Dense>

namespace parapet::surrogate {

/// m = L^-1 m. Eigen's own reads the first element even of an empty matrix.
template <typename Matrix>
void solve_lower(const Eigen::MatrixXd& factor, Matrix& m) {
  if (m.size() > 0) factor.triangularView<Eigen::Lower>().solveInPlace(m);
}

/// m = L^-T m.
template <typename Matrix>
void solve_lower_transposed(const Eigen::MatrixXd& factor, Matrix& m) {
  if (m.size() > 0) factor.transpose().triangularView<Eigen::Upper>().solveInPlace(m);
}

}  // namespace parapet::surrogate
