#include <stdexcept>
#include <string>

#include "covariance.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/surrogate/gaussian_process.hpp"
#include "triangular.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {

PosteriorSamples::PosteriorSamples(const GaussianProcess& process, const Eigen::MatrixXd& at,
                                   int n_samples, std::uint64_t seed)
    : process_(process), at_(at) {
  if (n_samples < 1) {
    throw std::invalid_argument("posterior samples: n_samples is " + std::to_string(n_samples) +
                                ", but there must be at least 1");
  }
  if (at_.rows() == 0) at_.resize(0, process.data_.inputs.cols());
  const JointPrediction joint = process.joint(at_);
  factor_ = safe_cholesky(joint.covariance);
  whitened_ = process.whitened(at_, 0);
  const auto p = static_cast<int>(at_.rows());
  weights_ = unit_points(n_samples, p, seed)
                 .unaryExpr([](double u) { return math::normal_quantile(u); })
                 .transpose();
  values_ = (factor_ * weights_).transpose();
  values_.rowwise() += joint.mean.transpose();
  // C^-1 (values - mean) = L'^-1 normals.
  solve_lower_transposed(factor_, weights_);
}

void PosteriorSamples::predict(const Eigen::MatrixXd& inputs, Eigen::MatrixXd& mean,
                               Eigen::VectorXd& variance) const {
  const Prediction prior = process_.predict(inputs);
  const std::vector<int> levels(static_cast<std::size_t>(at_.rows()), 0);
  // Posterior covariance [p, m] between the draws' inputs and these.
  Eigen::MatrixXd c =
      prior_covariance(process_.layout_, process_.parameters_.levels, at_, levels, inputs, 0) -
      whitened_.transpose() * process_.whitened(inputs, 0);
  mean = weights_.transpose() * c;
  mean.rowwise() += prior.mean.transpose();
  solve_lower(factor_, c);
  variance = (prior.variance - c.colwise().squaredNorm().transpose()).cwiseMax(0.0);
}

}  // namespace parapet::surrogate
