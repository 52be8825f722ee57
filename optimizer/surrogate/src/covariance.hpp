/// Covariances of the autoregressive process between inputs and levels.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::surrogate {

/// Matern 5/2 correlation [n, m] between the rows of a [n, n_features] and b [m, n_features]:
///   M = (1 + r + r^2 / 3) exp(-r),  r^2 = 5 sum_f (a_f - b_f)^2 / l_group(f)^2
/// (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, eq. 4.17).
Eigen::MatrixXd matern(const std::vector<int>& group, const Eigen::VectorXd& length_scales,
                       const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Shares [n_levels, n_levels] of process k (column) in level l (row): f_l = sum_k share(l, k)
/// delta_k, share(l, k) = rho_l ... rho_(k-1) for k >= l and 0 otherwise.
Eigen::MatrixXd process_shares(const std::vector<LevelParameters>& levels);

/// Prior covariance [n, m] between the observations' noise-free values, rows of `inputs`
/// [n, n_features] at `levels` [n], and f_level at the rows of b [m, n_features].
Eigen::MatrixXd prior_covariance(const Layout& layout, const std::vector<LevelParameters>& levels,
                                 const Eigen::MatrixXd& inputs, const std::vector<int>& input_level,
                                 const Eigen::MatrixXd& b, int level);

/// Prior variance of f_level, the same everywhere.
double prior_variance(const std::vector<LevelParameters>& levels, int level);

/// Lower Cholesky factor of a symmetric matrix [n, n] that is positive definite but for rounding:
/// what must be added to the diagonal is tried from 0 on, then from 1e-12 of its mean in steps of
/// 10. A matrix that is not finite gives the identity.
Eigen::MatrixXd safe_cholesky(const Eigen::MatrixXd& matrix);

}  // namespace parapet::surrogate
