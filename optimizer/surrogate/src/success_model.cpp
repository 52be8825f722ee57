#include "parapet/surrogate/success_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "covariance.hpp"
#include "fit_constants.hpp"
#include "parapet/math/normal.hpp"
#include "probit_laplace.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {
namespace {

void check(const Layout& layout, const Eigen::MatrixXd& inputs,
           const std::vector<bool>& succeeded) {
  const auto require = [](bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument("success model: " + message);
  };
  require(static_cast<std::size_t>(inputs.rows()) == succeeded.size(),
          std::to_string(inputs.rows()) + " rows of inputs for " +
              std::to_string(succeeded.size()) + " outcomes");
  require(static_cast<std::size_t>(inputs.cols()) == layout.group.size(),
          std::to_string(inputs.cols()) + " columns of inputs for a layout of " +
              std::to_string(layout.group.size()));
  require(layout.group.empty() || *std::min_element(layout.group.begin(), layout.group.end()) >= 0,
          "a group of the layout is negative");
  require(inputs.allFinite(), "an input is not finite");
}

/// The parameters that maximise the evidence of every k-th outcome, no more than
/// most_outcomes_for_parameters of them: from the priors' centre and from points drawn from the
/// priors.
Eigen::VectorXd likeliest(const Layout& layout, const Eigen::MatrixXd& inputs,
                          const Eigen::VectorXd& signs, std::uint64_t seed) {
  const Eigen::Index step =
      (signs.size() + most_outcomes_for_parameters - 1) / most_outcomes_for_parameters;
  const auto part = Eigen::seq(0, signs.size() - 1, step);
  const ProbitEvidence evidence(layout, inputs(part, Eigen::all), signs(part));
  const Eigen::Index n = (signs.size() + step - 1) / step;
  const SmoothFunction function = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double value = -evidence.evaluate(x, gradient);
    gradient = -gradient;
    return value;
  };
  // A call costs several times n^3.
  const int n_starts = n <= 150 ? 3 : 2;
  const Eigen::MatrixXd u = unit_points(n_starts, static_cast<int>(evidence.size()), seed);
  const int calls = n <= 150 ? 30 : 12;
  Descent best;
  best.x = evidence.centre();
  best.value = std::numeric_limits<double>::infinity();
  for (int s = 0; s < n_starts; ++s) {
    Eigen::VectorXd start = evidence.centre();
    for (Eigen::Index i = 0; s > 0 && i < start.size(); ++i) {
      start(i) += evidence.deviation()(i) * math::normal_quantile(u(s, i));
    }
    Descent at = begin_descent(function, start, evidence.bounds());
    continue_descent(function, evidence.bounds(), calls, tolerance_nats, at);
    if (at.value < best.value) best = at;
  }
  return best.x;
}

}  // namespace

SuccessModel SuccessModel::fit(const Layout& layout, const Eigen::MatrixXd& inputs,
                               const std::vector<bool>& succeeded, std::uint64_t seed) {
  check(layout, inputs, succeeded);
  SuccessModel model;
  model.layout_ = layout;
  model.inputs_ = inputs;
  model.any_failure_ = std::find(succeeded.begin(), succeeded.end(), false) != succeeded.end();
  if (!model.any_failure_) return model;
  Eigen::VectorXd signs(inputs.rows());
  for (Eigen::Index i = 0; i < signs.size(); ++i) {
    signs(i) = succeeded[static_cast<std::size_t>(i)] ? 1.0 : -1.0;
  }
  const Eigen::VectorXd x = likeliest(layout, inputs, signs, seed);
  const ProbitEvidence evidence(layout, inputs, signs);
  model.length_scales_ = x.head(x.size() - 1).array().exp();
  model.amplitude_ = std::exp(x(x.size() - 1));
  model.mean_ = evidence.mean();
  LaplaceMode mode = evidence.mode(x);
  model.gradient_ = std::move(mode.gradient);
  return model;
}

Eigen::VectorXd SuccessModel::log_probability(const Eigen::MatrixXd& inputs) const {
  if (static_cast<std::size_t>(inputs.cols()) != layout_.group.size()) {
    throw std::invalid_argument("success model: " + std::to_string(inputs.cols()) +
                                " columns asked of a model of " +
                                std::to_string(layout_.group.size()));
  }
  if (!any_failure_) return Eigen::VectorXd::Zero(inputs.rows());
  const Eigen::MatrixXd k =
      amplitude_ * amplitude_ * matern(layout_.group, length_scales_, inputs_, inputs);
  const Eigen::VectorXd mean = (k.transpose() * gradient_).array() + mean_;
  Eigen::VectorXd result(inputs.rows());
  for (Eigen::Index j = 0; j < result.size(); ++j) {
    result(j) = std::min(math::log_normal_cdf(mean(j)), 0.0);
  }
  return result;
}

}  // namespace parapet::surrogate
