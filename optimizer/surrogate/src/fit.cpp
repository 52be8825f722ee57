#include "fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit_constants.hpp"
#include "marginal_likelihood.hpp"
#include "parameter_vector.hpp"
#include "parapet/math/normal.hpp"
#include "quasi_newton.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {
namespace {

constexpr double transform_margin_nats = 2.0;
constexpr Eigen::Index transform_sample = 120;  // observations that a transform is judged by
constexpr int transform_evaluations = 20;

/// Calls of the likelihood that each start and the best of them get: a call costs n^3. With many
/// observations the parameters of the last fit are nearly right.
struct Budget {
  int each, best;
};
Budget budget(Eigen::Index n, bool warm) {
  if (n <= 60) return {40, 150};
  if (n <= 150) return {20, 80};
  return warm ? Budget{4, 10} : Budget{12, 60};
}

SmoothFunction negative(const MarginalLikelihood& likelihood) {
  return [&likelihood](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double value = -likelihood.evaluate(x, gradient);
    gradient = -gradient;
    return value;
  };
}

/// [starts][size]: the warm start or the priors' centre, then points spread as the priors are.
std::vector<Eigen::VectorXd> starting_points(const ParameterVector& vector, const Priors& priors,
                                             const FitOptions& options) {
  std::vector<Eigen::VectorXd> points;
  points.push_back(options.warm_start ? vector.pack(options.warm_start->levels) : priors.centre);
  const Eigen::MatrixXd u =
      unit_points(options.starts, static_cast<int>(vector.size()), options.seed);
  for (int s = 1; s < options.starts; ++s) {
    const Eigen::VectorXd t = u.row(s).unaryExpr([](double p) { return math::normal_quantile(p); });
    points.push_back(priors.centre + priors.deviation.cwiseProduct(t));
  }
  return points;
}

/// No more than `most` observations, evenly spaced in their order.
Data thinned(const Data& data, Eigen::Index most) {
  const Eigen::Index n = data.values.size();
  const Eigen::Index count = std::min(n, most);
  Data part;
  part.inputs.resize(count, data.inputs.cols());
  part.values.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = i * n / count;
    part.inputs.row(i) = data.inputs.row(from);
    part.values(i) = data.values(from);
    part.levels.push_back(data.levels[static_cast<std::size_t>(from)]);
  }
  return part;
}

double log_evidence(const Layout& layout, const Data& data, TransformKind kind,
                    const std::vector<double>& known_noise) {
  const OutputTransform transform = OutputTransform::standardizing(kind, data.values);
  Eigen::VectorXd z(data.values.size());
  double log_jacobian = 0.0;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    z(i) = transform.to_model(data.values(i));
    log_jacobian += transform.log_slope(data.values(i));
  }
  const ParameterVector vector(layout.n_groups(), layout.n_levels);
  const Priors priors =
      make_priors(vector, noise_in_model_units(data, layout.n_levels, transform, known_noise));
  const MarginalLikelihood likelihood(layout, data.inputs, z, data.levels, priors);
  const SmoothFunction function = negative(likelihood);
  Descent at = begin_descent(function, priors.centre, priors.bounds);
  continue_descent(function, priors.bounds, transform_evaluations, tolerance_nats, at);
  return log_jacobian - at.value;
}

}  // namespace

Eigen::MatrixXd mean_precision(int n_levels) {
  return make_priors(ParameterVector(0, n_levels), {}).mean_precision;
}

std::vector<double> noise_in_model_units(const Data& data, int n_levels,
                                         const OutputTransform& transform,
                                         const std::vector<double>& known_noise) {
  std::vector<double> noise;
  for (std::size_t l = 0; l < known_noise.size(); ++l) {
    double at_level = 0.0, anywhere = 0.0;
    int count = 0;
    for (Eigen::Index i = 0; i < data.values.size(); ++i) {
      const double log_slope = transform.log_slope(data.values(i));
      anywhere += log_slope / static_cast<double>(data.values.size());
      if (data.levels[static_cast<std::size_t>(i)] != static_cast<int>(l)) continue;
      at_level += log_slope;
      ++count;
    }
    noise.push_back(known_noise[l] * std::exp(count > 0 ? at_level / count : anywhere));
  }
  noise.resize(known_noise.empty() ? 0 : static_cast<std::size_t>(n_levels));
  return noise;
}

TransformKind likeliest_transform(const Layout& layout, const Data& data,
                                  const std::vector<double>& known_noise) {
  constexpr Eigen::Index least_observations = 6;
  if (data.values.size() < least_observations) return TransformKind::identity;
  const Data part = thinned(data, transform_sample);
  const double least = data.values.minCoeff(), greatest = data.values.maxCoeff();
  if (!(greatest > least)) return TransformKind::identity;
  TransformKind best = TransformKind::identity;
  double best_evidence =
      log_evidence(layout, part, TransformKind::identity, known_noise) + transform_margin_nats;
  for (const TransformKind kind : {TransformKind::log, TransformKind::bilog}) {
    if (kind == TransformKind::log && !(least > 0.0 && greatest > 10.0 * least)) continue;
    const double evidence = log_evidence(layout, part, kind, known_noise);
    if (!(evidence > best_evidence)) continue;
    best = kind;
    best_evidence = evidence;
  }
  return best;
}

std::vector<LevelParameters> likeliest_parameters(const Layout& layout, const Data& data,
                                                  const Eigen::VectorXd& z,
                                                  const std::vector<double>& model_noise,
                                                  const FitOptions& options) {
  const ParameterVector vector(layout.n_groups(), layout.n_levels);
  const Priors priors = make_priors(vector, model_noise);
  if (z.size() == 0 || !(z.maxCoeff() > z.minCoeff())) return vector.unpack(priors.centre);
  const Data part = thinned({data.inputs, z, data.levels}, most_for_parameters);
  const MarginalLikelihood likelihood(layout, part.inputs, part.values, part.levels, priors);
  const SmoothFunction function = negative(likelihood);
  const Budget calls = budget(z.size(), options.warm_start.has_value());
  Descent best;
  best.value = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& start : starting_points(vector, priors, options)) {
    Descent at = begin_descent(function, start, priors.bounds);
    continue_descent(function, priors.bounds, calls.each, tolerance_nats, at);
    if (at.value < best.value) best = at;
  }
  if (!std::isfinite(best.value)) return vector.unpack(priors.centre);
  continue_descent(function, priors.bounds, calls.best, tolerance_nats, best);
  return vector.unpack(best.x);
}

}  // namespace parapet::surrogate
