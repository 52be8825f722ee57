#include "confirmation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "candidates.hpp"
#include "composed.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/pareto.hpp"

namespace parapet::bayesian {
namespace {

constexpr double log_even_odds = -0.6931471805599453;
constexpr double never = std::numeric_limits<double>::infinity();

/// Of each design the evaluation at the finest level that ended well.
std::vector<std::size_t> different_designs(const Problem& problem, const std::vector<Told>& told,
                                           double tolerance) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < told.size(); ++k) {
    if (!told[k].ok || !allowed(problem, told[k].x, tolerance)) continue;
    const auto same = std::find_if(found.begin(), found.end(), [&](std::size_t other) {
      return same_design(told[other].x, told[k].x);
    });
    if (same == found.end()) {
      found.push_back(k);
    } else if (told[k].level < told[*same].level) {
      *same = k;
    }
  }
  return found;
}

/// The inputs of a composed metric at one design, from the predictions of all.
struct InputsAt {
  Eigen::VectorXd mean, deviation;

  InputsAt(const Metric& metric, const std::vector<surrogate::Prediction>& predictions,
           Eigen::Index row) {
    const auto& inputs = metric.composition.inputs;
    mean.resize(static_cast<Eigen::Index>(inputs.size()));
    deviation = mean;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto place = static_cast<Eigen::Index>(i);
      mean[place] = predictions[inputs[i]].mean[row];
      deviation[place] = std::sqrt(std::max(0.0, predictions[inputs[i]].variance[row]));
    }
  }
};

/// log of the probability that design k meets the limits, from the surrogates' predictions of all.
double log_feasible(const Problem& problem, const Models& models,
                    const std::vector<surrogate::Prediction>& predictions, const Told& design,
                    Eigen::Index row) {
  double sum = 0.0;
  for (const Limit& limit : problem.limits) {
    const auto& value = design.values[limit.metric];
    const Metric& metric = problem.metrics[limit.metric];
    if (value && metric.is_composed() && can_predict(problem, models, limit.metric)) {
      const InputsAt at(metric, predictions, row);
      sum += std::log(estimate_composed(of_inputs(problem, models, limit.metric, design.x), at.mean,
                                        at.deviation, limit.lower, limit.upper)
                          .share_within);
      continue;
    }
    const surrogate::GaussianProcess* process = models.process(limit.metric);
    if (!value) {
      if (!limit.satisfied_when_absent) return -never;
    } else if (process == nullptr) {
      if (*value < limit.lower || *value > limit.upper) return -never;
    } else {
      const auto model = [&](double v) { return std::isfinite(v) ? process->to_model(v) : v; };
      const surrogate::Prediction& prediction = predictions[limit.metric];
      sum += acquisition::log_probability_within(prediction.mean[row],
                                                 std::sqrt(prediction.variance[row]),
                                                 model(limit.lower), model(limit.upper));
    }
  }
  return sum;
}

/// Objectives scaled to 0 .. 1 over the front.
std::vector<std::vector<double>> normalised(const std::vector<std::vector<double>>& front) {
  auto result = front;
  for (std::size_t j = 0; j < front.front().size(); ++j) {
    double least = never, greatest = -never;
    for (const auto& y : front) {
      least = std::min(least, y[j]);
      greatest = std::max(greatest, y[j]);
    }
    for (auto& y : result) y[j] = greatest > least ? (y[j] - least) / (greatest - least) : 0.0;
  }
  return result;
}

std::size_t least_of_the_largest(const std::vector<std::vector<double>>& scaled) {
  const auto largest = [](const std::vector<double>& y) {
    return *std::max_element(y.begin(), y.end());
  };
  const auto best =
      std::min_element(scaled.begin(), scaled.end(),
                       [&](const auto& a, const auto& b) { return largest(a) < largest(b); });
  return static_cast<std::size_t>(best - scaled.begin());
}

}  // namespace

EstimatedFront estimated_front(const Problem& problem, const Models& models,
                               const std::vector<Told>& told, double tolerance) {
  EstimatedFront front;
  const std::vector<std::size_t> designs = different_designs(problem, told, tolerance);
  if (designs.empty()) return front;
  std::vector<Point> xs;
  for (const std::size_t k : designs) xs.push_back(told[k].x);
  const Eigen::MatrixXd inputs = problem.space.features(xs);
  std::vector<surrogate::Prediction> predictions(problem.metrics.size());
  for (std::size_t metric = 0; metric < predictions.size(); ++metric) {
    const auto* process = models.process(metric);
    if (process != nullptr) predictions[metric] = process->predict(inputs);
  }
  std::vector<math::Objectives> points;
  std::vector<std::size_t> known;
  std::vector<double> chance;
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const Told& design = told[designs[k]];
    const auto row = static_cast<Eigen::Index>(k);
    auto values = design.values;
    for (const Objective& objective : problem.objectives) {
      const auto* process = models.process(objective.metric);
      const Metric& metric = problem.metrics[objective.metric];
      if (metric.is_composed() && values[objective.metric] &&
          can_predict(problem, models, objective.metric)) {
        const double value = of_inputs(problem, models, objective.metric,
                                       design.x)(InputsAt(metric, predictions, row).mean);
        if (std::isfinite(value)) values[objective.metric] = value;
      }
      if (process == nullptr || !values[objective.metric]) continue;
      values[objective.metric] =
          std::clamp(process->from_model(predictions[objective.metric].mean[row]), metric.least,
                     metric.greatest);
    }
    auto y = minimized(problem, values);
    if (!y) continue;
    points.push_back(*std::move(y));
    known.push_back(designs[k]);
    chance.push_back(log_feasible(problem, models, predictions, design, row));
  }
  if (points.empty()) return front;
  std::vector<std::size_t> candidates;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (chance[k] >= log_even_odds) candidates.push_back(k);
  }
  if (candidates.empty()) {
    const auto best = std::max_element(chance.begin(), chance.end());
    candidates.push_back(static_cast<std::size_t>(best - chance.begin()));
  }
  std::vector<math::Objectives> feasible;
  for (const std::size_t k : candidates) feasible.push_back(points[k]);
  for (const std::size_t c : math::non_dominated(feasible)) {
    front.told.push_back(known[candidates[c]]);
    front.objectives.emplace_back(feasible[c].begin(), feasible[c].end());
  }
  return front;
}

std::vector<Point> by_nearness_to_recommended(const EstimatedFront& front,
                                              const std::vector<Told>& told,
                                              const Recommend& recommend) {
  if (front.told.empty()) return {};
  const auto scaled = normalised(front.objectives);
  const std::size_t first = recommend ? recommend(front.objectives) : least_of_the_largest(scaled);
  std::vector<std::size_t> order(front.told.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto distance = [&](std::size_t k) {
    double sum = 0.0;
    for (std::size_t j = 0; j < scaled[k].size(); ++j) {
      sum += (scaled[k][j] - scaled[first][j]) * (scaled[k][j] - scaled[first][j]);
    }
    return k == first ? -1.0 : sum;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  std::vector<Point> designs;
  for (const std::size_t k : order) designs.push_back(told[front.told[k]].x);
  return designs;
}

}  // namespace parapet::bayesian
