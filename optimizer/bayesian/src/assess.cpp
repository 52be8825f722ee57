#include <algorithm>
#include <cmath>
#include <limits>

#include "candidates.hpp"
#include "composed.hpp"
#include "confirmation.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/pareto.hpp"
#include "search_state.hpp"

namespace parapet::bayesian {
namespace {

constexpr double normal_975 = 1.959963984540054;  // 97.5 % of the standard normal
constexpr double without_limit = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Fills in what the surrogate of one metric says about all designs.
void estimate(std::vector<Assessed>& designs, std::size_t metric, const Metric& spec,
              const surrogate::GaussianProcess* process, const Eigen::MatrixXd& inputs) {
  surrogate::Prediction prediction;
  if (process != nullptr) prediction = process->predict(inputs);
  for (std::size_t k = 0; k < designs.size(); ++k) {
    Assessed& design = designs[k];
    double middle = nan, lower = nan, upper = nan;
    if (spec.exact) {
      middle = lower = upper = spec.exact(design.x);
    } else if (process != nullptr) {
      const auto row = static_cast<Eigen::Index>(k);
      const double deviation = std::sqrt(std::max(0.0, prediction.variance[row]));
      const auto value = [&](double z) {
        return std::clamp(process->from_model(z), spec.least, spec.greatest);
      };
      middle = value(prediction.mean[row]);
      lower = value(prediction.mean[row] - normal_975 * deviation);
      upper = value(prediction.mean[row] + normal_975 * deviation);
    }
    design.estimate[metric] = middle;
    design.lower[metric] = lower;
    design.upper[metric] = upper;
  }
}

/// The inputs of a composed metric, as their surrogates see them at all designs.
struct Inputs {
  Eigen::MatrixXd mean, deviation;  ///< [n_designs, n_inputs], model units

  Inputs(const Models& models, const Metric& spec, const Eigen::MatrixXd& at) {
    const auto& metrics = spec.composition.inputs;
    mean.resize(at.rows(), static_cast<Eigen::Index>(metrics.size()));
    deviation.resize(at.rows(), mean.cols());
    for (Eigen::Index i = 0; i < mean.cols(); ++i) {
      const auto prediction = models.process(metrics[static_cast<std::size_t>(i)])->predict(at);
      mean.col(i) = prediction.mean;
      deviation.col(i) = prediction.variance.cwiseMax(0.0).cwiseSqrt();
    }
  }
};

/// Fills in what the surrogates of its inputs say about a composed metric.
void estimate_from_inputs(std::vector<Assessed>& designs, const Problem& problem,
                          const Models& models, std::size_t metric, const Eigen::MatrixXd& inputs) {
  const Inputs at(models, problem.metrics[metric], inputs);
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const ComposedEstimate found = estimate_composed(
        of_inputs(problem, models, metric, designs[k].x), at.mean.row(row).transpose(),
        at.deviation.row(row).transpose(), -without_limit, without_limit);
    designs[k].estimate[metric] = found.median;
    designs[k].lower[metric] = found.lower;
    designs[k].upper[metric] = found.upper;
  }
}

/// The same for a limit on a composed metric: the share of draws of its inputs that meet it.
void add_log_share(Eigen::VectorXd& sum, const std::vector<Assessed>& designs,
                   const Problem& problem, const Models& models, const Limit& limit,
                   const Eigen::MatrixXd& inputs) {
  const Inputs at(models, problem.metrics[limit.metric], inputs);
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    sum[row] +=
        std::log(estimate_composed(of_inputs(problem, models, limit.metric, designs[k].x),
                                   at.mean.row(row).transpose(), at.deviation.row(row).transpose(),
                                   limit.lower, limit.upper)
                     .share_within);
  }
}

/// log of the probability that a limit is met at each design, added to a sum.
void add_log_feasible(Eigen::VectorXd& sum, const std::vector<Assessed>& designs,
                      const Limit& limit, const Metric& spec,
                      const surrogate::GaussianProcess* process, const Eigen::MatrixXd& inputs) {
  constexpr double impossible = -without_limit;
  surrogate::Prediction prediction;
  if (process != nullptr) prediction = process->predict(inputs);
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const auto& observed = designs[k].values[limit.metric];
    if (spec.exact) {
      const double value = spec.exact(designs[k].x);
      if (value < limit.lower || value > limit.upper) sum[row] = impossible;
    } else if (designs[k].ok && !observed) {
      if (!limit.satisfied_when_absent) sum[row] = impossible;
    } else if (process != nullptr) {
      const auto model = [&](double value) {
        return std::isfinite(value) ? process->to_model(value) : value;
      };
      sum[row] += acquisition::log_probability_within(
          prediction.mean[row], std::sqrt(std::max(0.0, prediction.variance[row])),
          model(limit.lower), model(limit.upper));
    }
  }
}

}  // namespace

std::vector<Assessed> Search::assessed() const {
  State& state = *state_;
  const Models& models = state.up_to_date();
  const Problem& problem = state.problem;
  std::vector<Assessed> designs;
  std::vector<Point> xs;
  for (const Told& t : state.told) {
    Assessed design{.id = t.id,
                    .x = t.x,
                    .level = t.level,
                    .ok = t.ok,
                    .values = t.values,
                    .feasible = false,
                    .estimate = {},
                    .lower = {},
                    .upper = {},
                    .probability_feasible = 0.0};
    design.feasible = t.ok &&
                      meets_limits(problem, t.values, state.options.feasibility_tolerance) &&
                      allowed(problem, t.x, state.options.feasibility_tolerance);
    for (auto* list : {&design.estimate, &design.lower, &design.upper}) {
      list->assign(problem.metrics.size(), nan);
    }
    xs.push_back(t.x);
    designs.push_back(std::move(design));
  }
  if (designs.empty()) return designs;
  const Eigen::MatrixXd inputs = problem.space.features(xs);
  for (std::size_t m = 0; m < problem.metrics.size(); ++m) {
    if (problem.metrics[m].is_composed()) {
      if (can_predict(problem, models, m)) {
        estimate_from_inputs(designs, problem, models, m, inputs);
      }
      continue;
    }
    estimate(designs, m, problem.metrics[m], models.process(m), inputs);
  }
  Eigen::VectorXd log_feasible = Eigen::VectorXd::Zero(inputs.rows());
  for (const Limit& limit : problem.limits) {
    if (problem.metrics[limit.metric].is_composed()) {
      if (can_predict(problem, models, limit.metric)) {
        add_log_share(log_feasible, designs, problem, models, limit, inputs);
      }
      continue;
    }
    add_log_feasible(log_feasible, designs, limit, problem.metrics[limit.metric],
                     models.process(limit.metric), inputs);
  }
  for (std::size_t k = 0; k < designs.size(); ++k) {
    designs[k].probability_feasible = std::exp(log_feasible[static_cast<Eigen::Index>(k)]);
    if (!allowed(problem, designs[k].x, state.options.feasibility_tolerance)) {
      designs[k].probability_feasible = 0.0;
    }
  }
  return designs;
}

std::vector<std::size_t> Search::estimated_front() const {
  State& state = *state_;
  return bayesian::estimated_front(state.problem, state.up_to_date(), state.told,
                                   state.options.feasibility_tolerance)
      .told;
}

std::vector<std::size_t> Search::pareto() const {
  std::vector<std::size_t> indices;
  std::vector<math::Objectives> points;
  for (std::size_t k = 0; k < state_->told.size(); ++k) {
    const Told& t = state_->told[k];
    const double tolerance = state_->options.feasibility_tolerance;
    if (!t.ok || t.level != 0 || !meets_limits(state_->problem, t.values, tolerance) ||
        !allowed(state_->problem, t.x, tolerance)) {
      continue;
    }
    if (auto y = minimized(state_->problem, t.values)) {
      indices.push_back(k);
      points.push_back(std::move(*y));
    }
  }
  std::vector<std::size_t> front;
  for (const std::size_t k : math::non_dominated(points)) front.push_back(indices[k]);
  return front;
}

}  // namespace parapet::bayesian
