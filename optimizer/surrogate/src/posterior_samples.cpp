#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "covariance.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/surrogate/gaussian_process.hpp"
#include "triangular.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {

namespace {

/// [n_samples] standard normal numbers.
Eigen::MatrixXd normals(int n_samples, int p, std::uint64_t seed) {
  return unit_points(n_samples, p, seed)
      .unaryExpr([](double u) { return math::normal_quantile(u); })
      .transpose();
}

/// Below this share of the prior variance an input is known but for rounding.
constexpr double least_share = 1e-12;

}  // namespace

PosteriorSamples::PosteriorSamples(const GaussianProcess& process, const Eigen::MatrixXd& at,
                                   int n_samples, std::uint64_t seed)
    : process_(process), seed_(seed), at_(at) {
  if (n_samples < 1) {
    throw std::invalid_argument("posterior samples: n_samples is " + std::to_string(n_samples) +
                                ", but there must be at least 1");
  }
  if (at_.rows() == 0) at_.resize(0, process.data_.inputs.cols());
  const JointPrediction joint = process.joint(at_);
  factor_ = safe_cholesky(joint.covariance);
  whitened_ = process.whitened(at_, 0);
  normals_ = normals(n_samples, static_cast<int>(at_.rows()), seed);
  values_ = (factor_ * normals_).transpose();
  values_.rowwise() += joint.mean.transpose();
  // C^-1 (values - mean) = L'^-1 normals.
  weights_ = normals_;
  solve_lower_transposed(factor_, weights_);
}

void PosteriorSamples::append(const Eigen::RowVectorXd& input) {
  const PreparedInputs one = prepare(input);
  const Eigen::Index p = at_.rows();
  const std::vector<int> levels(static_cast<std::size_t>(p), 0);
  Eigen::MatrixXd row =
      prior_covariance(process_.layout_, process_.parameters_.levels, at_, levels, input, 0) -
      whitened_.transpose() * one.whitened;
  solve_lower(factor_, row);
  const double prior = prior_variance(process_.parameters_.levels, 0);
  const double left = std::max(one.variance[0] - row.squaredNorm(), least_share * prior);
  const auto draws = static_cast<int>(values_.rows());
  factor_.conservativeResize(p + 1, p + 1);
  factor_.col(p).setZero();
  factor_.row(p).head(p) = row.transpose();
  factor_(p, p) = std::sqrt(left);
  normals_.conservativeResize(p + 1, draws);
  normals_.row(p) = normals(draws, 1, seed_ + 15485863ULL * static_cast<std::uint64_t>(p + 1));
  values_.conservativeResize(draws, p + 1);
  values_.col(p) = (factor_.row(p) * normals_).transpose();
  values_.col(p).array() += one.mean[0];
  weights_ = normals_;
  solve_lower_transposed(factor_, weights_);
  at_.conservativeResize(p + 1, input.size());
  at_.row(p) = input;
  whitened_.conservativeResize(one.whitened.rows(), p + 1);
  whitened_.col(p) = one.whitened;
}

PreparedInputs PosteriorSamples::prepare(const Eigen::MatrixXd& inputs) const {
  PreparedInputs prepared;
  prepared.inputs = inputs;
  Eigen::MatrixXd& k = prepared.whitened;
  k = prior_covariance(process_.layout_, process_.parameters_.levels, process_.data_.inputs,
                       process_.data_.levels, inputs, 0);
  prepared.mean = (k.transpose() * process_.weights_).array() + process_.parameters_.levels[0].mean;
  solve_lower(process_.factor_, k);
  prepared.variance = (prior_variance(process_.parameters_.levels, 0) -
                       k.colwise().squaredNorm().transpose().array())
                          .max(0.0);
  return prepared;
}

void PosteriorSamples::predict(const PreparedInputs& prepared, Eigen::MatrixXd& mean,
                               Eigen::VectorXd& variance) const {
  const std::vector<int> levels(static_cast<std::size_t>(at_.rows()), 0);
  // Posterior covariance [p, m] between the draws' inputs and these.
  Eigen::MatrixXd c = prior_covariance(process_.layout_, process_.parameters_.levels, at_, levels,
                                       prepared.inputs, 0) -
                      whitened_.transpose() * prepared.whitened;
  mean = weights_.transpose() * c;
  mean.rowwise() += prepared.mean.transpose();
  solve_lower(factor_, c);
  variance = (prepared.variance - c.colwise().squaredNorm().transpose()).cwiseMax(0.0);
}

void PosteriorSamples::predict(const Eigen::MatrixXd& inputs, Eigen::MatrixXd& mean,
                               Eigen::VectorXd& variance) const {
  process_.require_features(inputs, 0);
  predict(prepare(inputs), mean, variance);
}

}  // namespace parapet::surrogate
