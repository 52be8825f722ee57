#include "gain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "as_index.hpp"
#include "composed.hpp"
#include "level_choice.hpp"

namespace parapet::bayesian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A reference of 0 or less has no place on a logarithmic scale: the box would be some hundred
/// standard deviations long. It is moved to a tenth of the observed range below the least value, on
/// that scale.
double reference_in_reach(const ObjectiveView& view, double reference) {
  if (!view.in_model_units ||
      view.process->parameters().transform.kind != surrogate::TransformKind::log) {
    return reference;
  }
  const Eigen::VectorXd& values = view.process->data().values;
  const double least = values.minCoeff(), greatest = values.maxCoeff();
  if (!(least > 0.0)) return reference;  // the fit takes another transform then
  return std::max(reference, least * std::pow(least / greatest, 0.1));
}

}  // namespace

Gain::Gain(const Input& input)
    : problem_(input.problem),
      models_(input.models),
      level_cost_(input.level_cost),
      n_samples_(input.n_samples) {
  view_objectives(input);
  view_limits(input);
  choose_front_designs(input);
  draw(input.seed);
}

double Gain::exact(std::size_t metric, const Point& x) const {
  return problem_.metrics[metric].exact(x);
}

void Gain::view_objectives(const Input& input) {
  const std::size_t n = problem_.objectives.size();
  reference_.resize(as_index(n));
  ideal_.resize(as_index(n));
  for (std::size_t j = 0; j < n; ++j) {
    const Objective& objective = problem_.objectives[j];
    const Metric& metric = problem_.metrics[objective.metric];
    const ObjectiveView view = view_of(problem_, models_, input.told, j);
    const double in_unit =
        objective.maximize ? -input.reference[as_index(j)] : input.reference[as_index(j)];
    reference_[as_index(j)] = view.to_view(reference_in_reach(view, in_unit));
    const double best = objective.maximize ? metric.greatest : metric.least;
    ideal_[as_index(j)] = std::isfinite(best) ? view.to_view(best) : -infinity;
    objectives_.push_back(view);
  }
}

void Gain::view_limits(const Input& /*input*/) {
  for (const Limit& limit : problem_.limits) {
    const auto* process = models_.process(limit.metric);
    const auto to_model = [&](double value) {
      return process == nullptr || !std::isfinite(value) ? value : process->to_model(value);
    };
    LimitView view{.metric = limit.metric,
                   .lower = to_model(limit.lower),
                   .upper = to_model(limit.upper),
                   .satisfied_when_absent = limit.satisfied_when_absent,
                   .in_reference = false,
                   .composed = problem_.metrics[limit.metric].is_composed() &&
                               can_predict(problem_, models_, limit.metric)};
    for (std::size_t j = 0; j < objectives_.size(); ++j) {
      if (objectives_[j].metric != limit.metric) continue;
      // "At least 0.9 of what is maximised" is a nearer reference point, exactly.
      const bool maximized = objectives_[j].sign < 0.0;
      const double bad_end = maximized ? limit.lower : limit.upper;
      const double other_end = maximized ? limit.upper : limit.lower;
      if (!std::isfinite(bad_end)) continue;
      reference_[as_index(j)] = std::min(reference_[as_index(j)], objectives_[j].to_view(bad_end));
      view.in_reference = !std::isfinite(other_end);
    }
    limits_.push_back(view);
  }
}

double Gain::noise_volume() const {
  double volume = 1.0;
  for (const ObjectiveView& view : objectives_) {
    // The slope at the middle of the data, in model units.
    if (view.process != nullptr) volume *= view.deviation(0.0, view.process->noise());
    if (!problem_.metrics[view.metric].is_composed() || designs_.empty()) continue;
    const auto& inputs = problem_.metrics[view.metric].composition.inputs;
    const Eigen::VectorXd middle = Eigen::VectorXd::Zero(as_index(inputs.size()));
    Eigen::VectorXd noise = middle;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      noise[as_index(i)] = models_.process(inputs[i])->noise();
    }
    const OfInputs f = of_inputs(problem_, models_, view.metric, designs_.front());
    volume *= split(f, middle, noise).deviation / view.scale;
  }
  return volume;
}

/// Whether a goal hangs on a metric.
bool Gain::wanted(std::size_t metric) const {
  const auto hangs = [&](std::size_t goal) {
    const auto inputs = modelled_inputs(problem_, goal);
    return std::find(inputs.begin(), inputs.end(), metric) != inputs.end();
  };
  const auto of_limit = [&](const LimitView& l) { return hangs(l.metric); };
  const auto of_objective = [&](const ObjectiveView& o) { return hangs(o.metric); };
  return samples_[metric] != nullptr &&
         (std::any_of(limits_.begin(), limits_.end(), of_limit) ||
          std::any_of(objectives_.begin(), objectives_.end(), of_objective));
}

Gain::Prepared Gain::prepare(std::vector<Point> xs) const {
  Prepared prepared;
  prepared.inputs.resize(samples_.size());
  const Eigen::MatrixXd inputs = problem_.space.features(xs);
  prepared.xs = std::move(xs);
  for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
    if (wanted(metric)) prepared.inputs[metric] = samples_[metric]->prepare(inputs);
  }
  prepared.log_success = models_.log_success(inputs);
  if (level_cost_.size() == 1) return prepared;
  for (std::size_t level = 0; level < level_cost_.size(); ++level) {
    auto& shares = prepared.shares.emplace_back(samples_.size());
    for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
      if (!wanted(metric)) continue;
      shares[metric] = informative_share(*models_.process(metric), inputs, static_cast<int>(level));
    }
  }
  return prepared;
}

Gain::Given Gain::predict(const Prepared& prepared) const {
  Given given{.means = std::vector<Eigen::MatrixXd>(samples_.size()),
              .deviations = std::vector<Eigen::VectorXd>(samples_.size())};
  for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
    if (!wanted(metric)) continue;
    samples_[metric]->predict(prepared.inputs[metric], given.means[metric],
                              given.deviations[metric]);
    given.deviations[metric] = given.deviations[metric].cwiseMax(0.0).cwiseSqrt();
  }
  return given;
}

Gain::Composed Gain::composed(std::size_t metric, const Prepared& prepared, const Given& given,
                              Eigen::Index k, std::size_t level, int draws) const {
  const auto& inputs = problem_.metrics[metric].composition.inputs;
  const Eigen::Index n = as_index(inputs.size());
  Eigen::MatrixXd means(draws, n), normals(draws, n);
  Eigen::VectorXd sd(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t input = inputs[static_cast<std::size_t>(i)];
    means.col(i) = given.means[input].col(k).head(draws);
    normals.col(i) = normals_[input].head(draws);
    sd[i] = given.deviations[input][k] * prepared.shown(level, input, k);
  }
  const OfInputs f = of_inputs(problem_, models_, metric, prepared.xs[static_cast<std::size_t>(k)]);
  const NormalSplit parts = split(f, means.colwise().mean().transpose(), sd);
  Composed result{.values = Eigen::VectorXd(draws), .deviation = parts.deviation};
  Eigen::VectorXd z(n);
  for (Eigen::Index s = 0; s < draws; ++s) {
    z = means.row(s).transpose();
    if (parts.sampled > 0.0) z += parts.sampled * normals.row(s).transpose().cwiseProduct(sd);
    result.values[s] = f(z);
  }
  return result;
}

Eigen::VectorXd Gain::log_feasible(const Prepared& prepared, const Given& given, Eigen::Index k,
                                   bool all_limits, std::size_t level, int draws) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(draws);
  for (const LimitView& limit : limits_) {
    if (limit.in_reference && !all_limits) continue;
    if (limit.composed) {
      const Composed value = composed(limit.metric, prepared, given, k, level, draws);
      for (Eigen::Index s = 0; s < draws; ++s) {
        result[s] += std::isnan(value.values[s])
                         ? -infinity
                         : acquisition::log_probability_within(value.values[s], value.deviation,
                                                               limit.lower, limit.upper);
      }
      continue;
    }
    const Eigen::MatrixXd& mean = given.means[limit.metric];
    if (mean.size() == 0) {
      if (!problem_.metrics[limit.metric].exact) continue;  // never had a value so far
      const double value = exact(limit.metric, prepared.xs[static_cast<std::size_t>(k)]);
      if (value < limit.lower || value > limit.upper) result.setConstant(-infinity);
      continue;
    }
    const double deviation = given.deviations[limit.metric][k];
    const double shown = prepared.shown(level, limit.metric, k);
    for (Eigen::Index s = 0; s < draws; ++s) {
      const bool met = limit.lower <= mean(s, k) && mean(s, k) <= limit.upper;
      result[s] += acquisition::log_probability_within(
          mean(s, k), met ? deviation : deviation * shown, limit.lower, limit.upper);
    }
  }
  return result;
}

Eigen::VectorXd Gain::log_gain(const Prepared& prepared, const Given& given, std::size_t level,
                               int draws) const {
  const bool only_feasibility = !front_->any_feasible() && !limits_.empty();
  const Eigen::Index n_objectives = as_index(objectives_.size());
  Eigen::VectorXd result = prepared.log_success;
  Eigen::MatrixXd y(draws, n_objectives), deviation(draws, n_objectives);
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    const Point& x = prepared.xs[static_cast<std::size_t>(k)];
    const Eigen::VectorXd feasible =
        log_feasible(prepared, given, k, only_feasibility, level, draws);
    if (only_feasibility) {
      result[k] += acquisition::log_mean(feasible);
      continue;
    }
    for (Eigen::Index j = 0; j < n_objectives; ++j) {
      const ObjectiveView& view = objectives_[static_cast<std::size_t>(j)];
      if (view.process != nullptr) {
        const double sd = given.deviations[view.metric][k] * prepared.shown(level, view.metric, k);
        for (Eigen::Index s = 0; s < draws; ++s) {
          const double z = given.means[view.metric](s, k);
          y(s, j) = view.from_model(z);
          deviation(s, j) = view.deviation(z, sd);
        }
      } else if (problem_.metrics[view.metric].is_composed()) {
        const Composed value = composed(view.metric, prepared, given, k, level, draws);
        for (Eigen::Index s = 0; s < draws; ++s) y(s, j) = view.of_composed(value.values[s]);
        deviation.col(j).setConstant(value.deviation / view.scale);
      } else {
        y.col(j).setConstant(view.to_view(exact(view.metric, x)));
        deviation.col(j).setZero();
      }
    }
    result[k] += front_->log_improvement_by_draw(y, deviation, feasible);
  }
  return result;
}

Gain::Value Gain::screen(const std::vector<Point>& xs) const {
  constexpr int few_draws = 8;
  return value(prepare(xs), std::min(few_draws, n_samples_));
}

Gain::Value Gain::value(const Prepared& prepared, int draws) const {
  const Given given = predict(prepared);
  Value best{.log_gain_per_cost = {}, .level = std::vector<int>(prepared.xs.size(), 0)};
  for (std::size_t level = 0; level < level_cost_.size(); ++level) {
    const Eigen::VectorXd here =
        log_gain(prepared, given, level, draws).array() - std::log(level_cost_[level]);
    if (level == 0) {
      best.log_gain_per_cost = here;
      continue;
    }
    for (Eigen::Index k = 0; k < here.size(); ++k) {
      if (!(here[k] > best.log_gain_per_cost[k])) continue;
      best.log_gain_per_cost[k] = here[k];
      best.level[static_cast<std::size_t>(k)] = static_cast<int>(level);
    }
  }
  return best;
}

Eigen::VectorXd Gain::log_ignorance(const std::vector<Point>& xs) const {
  const Prepared prepared = prepare(xs);
  const Given given = predict(prepared);
  Eigen::VectorXd result = prepared.log_success;
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    double largest = 0.0;
    for (const ObjectiveView& view : objectives_) {
      for (const std::size_t input : modelled_inputs(problem_, view.metric)) {
        largest = std::max(largest, given.deviations[input][k]);
      }
    }
    result[k] += 2.0 * std::log(largest) +
                 acquisition::log_mean(log_feasible(prepared, given, k, true, 0, n_samples_));
  }
  return result;
}

}  // namespace parapet::bayesian
