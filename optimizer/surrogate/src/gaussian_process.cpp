#include "parapet/surrogate/gaussian_process.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "covariance.hpp"
#include "fit.hpp"
#include "fit_constants.hpp"
#include "marginal_likelihood.hpp"
#include "triangular.hpp"

namespace parapet::surrogate {
namespace {

constexpr double quantile_975 = 1.9599639845400542355;

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("Gaussian process: " + message);
}

void check_layout(const Layout& layout) {
  require(layout.n_levels >= 1, "n_levels is " + std::to_string(layout.n_levels) +
                                    ", but there must be at least 1 level");
  for (const int group : layout.group) {
    require(group >= 0, "group " + std::to_string(group) + " of a column is negative");
  }
}

void check_data(const Layout& layout, const Data& data) {
  const auto n = static_cast<std::size_t>(data.values.size());
  require(
      static_cast<std::size_t>(data.inputs.rows()) == n,
      std::to_string(data.inputs.rows()) + " rows of inputs for " + std::to_string(n) + " values");
  require(static_cast<std::size_t>(data.inputs.cols()) == layout.group.size(),
          std::to_string(data.inputs.cols()) + " columns of inputs for a layout of " +
              std::to_string(layout.group.size()));
  require(data.levels.empty() || data.levels.size() == n,
          std::to_string(data.levels.size()) + " levels for " + std::to_string(n) + " values");
  for (const int level : data.levels) {
    require(level >= 0 && level < layout.n_levels, "level " + std::to_string(level) +
                                                       " is outside 0 .. " +
                                                       std::to_string(layout.n_levels - 1));
  }
  require(data.inputs.allFinite(), "an input is not finite");
  require(data.values.allFinite(), "a value is not finite");
}

void check_warm_start(const Layout& layout, const Parameters& warm) {
  require(warm.levels.size() == static_cast<std::size_t>(layout.n_levels),
          "warm_start has " + std::to_string(warm.levels.size()) + " levels, the layout " +
              std::to_string(layout.n_levels));
  for (const LevelParameters& level : warm.levels) {
    require(level.length_scales.size() == layout.n_groups(),
            "warm_start has " + std::to_string(level.length_scales.size()) +
                " length scales, the layout " + std::to_string(layout.n_groups()) + " groups");
    const bool positive =
        (level.length_scales.array() > 0.0).all() && level.amplitude > 0.0 && level.noise > 0.0;
    require(positive && level.length_scales.allFinite() &&
                std::isfinite(level.amplitude + level.noise + level.mean + level.coupling),
            "a parameter of warm_start is not finite, or not positive where it must be");
  }
}

void check_options(const Layout& layout, const FitOptions& options) {
  require(options.starts >= 1,
          "starts is " + std::to_string(options.starts) + ", but there must be at least 1");
  require(options.known_noise.empty() ||
              options.known_noise.size() == static_cast<std::size_t>(layout.n_levels),
          "known_noise has " + std::to_string(options.known_noise.size()) + " entries for " +
              std::to_string(layout.n_levels) + " levels");
  for (const double noise : options.known_noise) {
    require(noise >= 0.0 && std::isfinite(noise), "known_noise must be finite and at least 0");
  }
  require(options.warm_start || !options.keep_parameters,
          "keep_parameters asks for a warm_start, and there is none");
  if (options.warm_start) check_warm_start(layout, *options.warm_start);
}

/// Covariance of f_0(x) and f_level(x) before any data.
double prior_cross(const std::vector<LevelParameters>& levels, int level) {
  const Eigen::MatrixXd shares = process_shares(levels);
  double sum = 0.0;
  for (auto k = static_cast<std::size_t>(level); k < levels.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    sum += shares(0, column) * shares(level, column) * levels[k].amplitude * levels[k].amplitude;
  }
  return sum;
}

OutputTransform choose_transform(const Layout& layout, const Data& data,
                                 const FitOptions& options) {
  if (options.keep_parameters) return options.warm_start->transform;
  TransformKind kind = options.transform;
  if (kind == TransformKind::automatic) {
    kind = options.warm_start ? options.warm_start->transform.kind
                              : likeliest_transform(layout, data, options.known_noise);
  }
  return OutputTransform::standardizing(kind, data.values);
}

Eigen::VectorXd model_values(const OutputTransform& transform, const Eigen::VectorXd& values) {
  return values.unaryExpr([&](double y) { return transform.to_model(y); });
}

}  // namespace

int Layout::n_groups() const {
  return group.empty() ? 0 : 1 + *std::max_element(group.begin(), group.end());
}

GaussianProcess GaussianProcess::fit(const Layout& layout, const Data& data,
                                     const FitOptions& options) {
  check_layout(layout);
  check_data(layout, data);
  check_options(layout, options);
  GaussianProcess process;
  process.layout_ = layout;
  process.data_ = data;
  if (data.levels.empty()) {
    process.data_.levels.assign(static_cast<std::size_t>(data.values.size()), 0);
  }
  process.parameters_.transform = choose_transform(layout, process.data_, options);
  if (options.keep_parameters) {
    process.parameters_.levels = options.warm_start->levels;
  } else {
    const OutputTransform& transform = process.parameters_.transform;
    process.parameters_.levels = likeliest_parameters(
        layout, process.data_, model_values(transform, data.values),
        noise_in_model_units(process.data_, layout.n_levels, transform, options.known_noise),
        options);
  }
  process.condition(options.keep_parameters);
  return process;
}

void GaussianProcess::condition(bool keep_means) {
  const Eigen::Index n = data_.values.size();
  Eigen::MatrixXd covariance(n, n);
  for (int level = 0; level < layout_.n_levels; ++level) {
    // One block of columns per level.
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (data_.levels[static_cast<std::size_t>(i)] == level) columns.push_back(i);
    }
    covariance(Eigen::all, columns) =
        prior_covariance(layout_, parameters_.levels, data_.inputs, data_.levels,
                         data_.inputs(columns, Eigen::all), level);
    for (const Eigen::Index i : columns) covariance(i, i) += noise(level) * noise(level);
  }
  factor_ = safe_cholesky(covariance);
  const Eigen::VectorXd z = model_values(parameters_.transform, data_.values);
  if (!keep_means) {
    const Eigen::VectorXd means =
        best_means(inverse_from_factor(factor_), z, data_.levels, mean_precision(layout_.n_levels));
    for (Eigen::Index l = 0; l < means.size(); ++l) {
      parameters_.levels[static_cast<std::size_t>(l)].mean = means(l);
    }
  }
  Eigen::VectorXd residual = z;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto level = static_cast<std::size_t>(data_.levels[static_cast<std::size_t>(i)]);
    residual(i) -= parameters_.levels[level].mean;
  }
  weights_ = residual;
  solve_lower(factor_, weights_);
  solve_lower_transposed(factor_, weights_);
  log_likelihood_ = -0.5 * residual.dot(weights_) - factor_.diagonal().array().log().sum() -
                    0.5 * static_cast<double>(n) * log_two_pi;
}

void GaussianProcess::require_features(const Eigen::MatrixXd& inputs, int level) const {
  require(static_cast<std::size_t>(inputs.cols()) == layout_.group.size(),
          std::to_string(inputs.cols()) + " columns asked of a process of " +
              std::to_string(layout_.group.size()));
  require(level >= 0 && level < layout_.n_levels, "level " + std::to_string(level) +
                                                      " is outside 0 .. " +
                                                      std::to_string(layout_.n_levels - 1));
}

Eigen::MatrixXd GaussianProcess::whitened(const Eigen::MatrixXd& inputs, int level) const {
  Eigen::MatrixXd k =
      prior_covariance(layout_, parameters_.levels, data_.inputs, data_.levels, inputs, level);
  solve_lower(factor_, k);
  return k;
}

Prediction GaussianProcess::predict(const Eigen::MatrixXd& inputs, int level) const {
  require_features(inputs, level);
  Eigen::MatrixXd k =
      prior_covariance(layout_, parameters_.levels, data_.inputs, data_.levels, inputs, level);
  Prediction prediction;
  prediction.mean =
      (k.transpose() * weights_).array() + parameters_.levels[static_cast<std::size_t>(level)].mean;
  solve_lower(factor_, k);
  prediction.variance =
      (prior_variance(parameters_.levels, level) - k.colwise().squaredNorm().transpose().array())
          .max(0.0);
  return prediction;
}

Eigen::VectorXd GaussianProcess::predict_mean(const Eigen::MatrixXd& inputs, int level) const {
  require_features(inputs, level);
  const Eigen::MatrixXd k =
      prior_covariance(layout_, parameters_.levels, data_.inputs, data_.levels, inputs, level);
  return (k.transpose() * weights_).array() +
         parameters_.levels[static_cast<std::size_t>(level)].mean;
}

JointPrediction GaussianProcess::joint(const Eigen::MatrixXd& inputs, int level) const {
  JointPrediction prediction;
  prediction.mean = predict(inputs, level).mean;
  const Eigen::MatrixXd c = covariance(inputs, level, inputs, level);
  prediction.covariance = 0.5 * (c + c.transpose());
  prediction.covariance.diagonal() = prediction.covariance.diagonal().cwiseMax(0.0);
  return prediction;
}

Eigen::MatrixXd GaussianProcess::covariance(const Eigen::MatrixXd& a, int level,
                                            const Eigen::MatrixXd& b, int other) const {
  require_features(a, level);
  require_features(b, other);
  const std::vector<int> levels(static_cast<std::size_t>(a.rows()), level);
  return prior_covariance(layout_, parameters_.levels, a, levels, b, other) -
         whitened(a, level).transpose() * whitened(b, other);
}

Eigen::VectorXd GaussianProcess::correlation_squared(const Eigen::MatrixXd& inputs,
                                                     int level) const {
  require_features(inputs, level);
  if (level == 0) return Eigen::VectorXd::Ones(inputs.rows());
  const Eigen::MatrixXd fine = whitened(inputs, 0), coarse = whitened(inputs, level);
  const double cross_prior = prior_cross(parameters_.levels, level);
  const double fine_prior = prior_variance(parameters_.levels, 0);
  const double coarse_prior = prior_variance(parameters_.levels, level);
  Eigen::VectorXd squared(inputs.rows());
  for (Eigen::Index j = 0; j < inputs.rows(); ++j) {
    const double cross = cross_prior - fine.col(j).dot(coarse.col(j));
    const double product =
        (fine_prior - fine.col(j).squaredNorm()) * (coarse_prior - coarse.col(j).squaredNorm());
    // Where either is known but for rounding, the coarse level has nothing left to tell.
    const bool known = !(product > 1e-20 * fine_prior * coarse_prior);
    squared(j) = known ? 0.0 : std::min(1.0, cross * cross / product);
  }
  return squared;
}

double GaussianProcess::level_correlation(int level) const {
  require(level >= 0 && level < layout_.n_levels, "no level " + std::to_string(level));
  const double product =
      prior_variance(parameters_.levels, 0) * prior_variance(parameters_.levels, level);
  return product > 0.0 ? prior_cross(parameters_.levels, level) / std::sqrt(product) : 0.0;
}

LeaveOneOut GaussianProcess::leave_one_out() const {
  const Eigen::Index n = data_.values.size();
  const Eigen::MatrixXd inverse = inverse_from_factor(factor_);
  const Eigen::VectorXd z = model_values(parameters_.transform, data_.values);
  LeaveOneOut result;
  result.mean.resize(n);
  result.lower.resize(n);
  result.upper.resize(n);
  result.residual.resize(n);
  double squared_errors = 0.0;
  int covered = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    // Rasmussen and Williams, 2006, equations (5.10) to (5.12).
    const double error = weights_(i) / inverse(i, i);
    const double deviation = std::sqrt(1.0 / inverse(i, i));
    result.mean(i) = from_model(z(i) - error);
    result.lower(i) = from_model(z(i) - error - quantile_975 * deviation);
    result.upper(i) = from_model(z(i) - error + quantile_975 * deviation);
    result.residual(i) = error / deviation;
    squared_errors += error * error;
    if (std::abs(result.residual(i)) <= quantile_975) ++covered;
  }
  if (n == 0) return result;
  const double spread = (z.array() - z.mean()).square().sum();
  if (spread > 0.0) result.q_squared = 1.0 - squared_errors / spread;
  result.coverage_95 = static_cast<double>(covered) / static_cast<double>(n);
  return result;
}

}  // namespace parapet::surrogate
