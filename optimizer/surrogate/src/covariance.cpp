#include "covariance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace parapet::surrogate {

Eigen::MatrixXd matern(const std::vector<int>& group, const Eigen::VectorXd& length_scales,
                       const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::ArrayXXd r = Eigen::ArrayXXd::Zero(a.rows(), b.rows());
  for (Eigen::Index j = 0; j < b.rows(); ++j) {
    for (Eigen::Index f = 0; f < a.cols(); ++f) {
      const double inverse = 1.0 / length_scales(group[static_cast<std::size_t>(f)]);
      r.col(j) += ((a.col(f).array() - b(j, f)) * inverse).square();
    }
  }
  r = (5.0 * r).sqrt();
  return ((1.0 + r + r.square() / 3.0) * (-r).exp()).matrix();
}

Eigen::MatrixXd process_shares(const std::vector<LevelParameters>& levels) {
  const auto n = static_cast<Eigen::Index>(levels.size());
  Eigen::MatrixXd shares = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index l = 0; l < n; ++l) {
    for (Eigen::Index k = l + 1; k < n; ++k) {
      shares(l, k) = shares(l, k - 1) * levels[static_cast<std::size_t>(k - 1)].coupling;
    }
  }
  return shares;
}

Eigen::MatrixXd prior_covariance(const Layout& layout, const std::vector<LevelParameters>& levels,
                                 const Eigen::MatrixXd& inputs, const std::vector<int>& input_level,
                                 const Eigen::MatrixXd& b, int level) {
  const Eigen::MatrixXd shares = process_shares(levels);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(inputs.rows(), b.rows());
  for (int k = level; k < layout.n_levels; ++k) {
    const LevelParameters& process = levels[static_cast<std::size_t>(k)];
    Eigen::VectorXd weight(inputs.rows());
    for (Eigen::Index i = 0; i < inputs.rows(); ++i) {
      weight(i) = shares(input_level[static_cast<std::size_t>(i)], k);  // 0 for levels beyond k
    }
    weight *= shares(level, k) * process.amplitude * process.amplitude;
    sum += weight.asDiagonal() * matern(layout.group, process.length_scales, inputs, b);
  }
  return sum;
}

double prior_variance(const std::vector<LevelParameters>& levels, int level) {
  const Eigen::MatrixXd shares = process_shares(levels);
  double sum = 0.0;
  for (std::size_t k = static_cast<std::size_t>(level); k < levels.size(); ++k) {
    const double term = shares(level, static_cast<Eigen::Index>(k)) * levels[k].amplitude;
    sum += term * term;
  }
  return sum;
}

Eigen::MatrixXd safe_cholesky(const Eigen::MatrixXd& matrix) {
  const Eigen::Index n = matrix.rows();
  if (n == 0 || !matrix.allFinite()) return Eigen::MatrixXd::Identity(n, n);
  const double mean_diagonal = std::max(matrix.diagonal().mean(), 1e-300);
  double jitter = 0.0;
  for (;;) {
    Eigen::MatrixXd sum = matrix;
    sum.diagonal().array() += jitter;
    const Eigen::LLT<Eigen::MatrixXd> factor(sum);
    if (factor.info() == Eigen::Success) return factor.matrixL();
    // At 1e3 times the mean the diagonal outweighs the rest of any covariance's rounding.
    if (jitter > 1e3 * mean_diagonal) return std::sqrt(jitter) * Eigen::MatrixXd::Identity(n, n);
    jitter = std::max(10.0 * jitter, 1e-12 * mean_diagonal);
  }
}

}  // namespace parapet::surrogate
