#include "gain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parapet/math/pareto.hpp"

namespace parapet::bayesian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_front_designs = 40;

Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

/// A linear scale for an exact metric: that of the designs seen.
surrogate::OutputTransform exact_transform(std::size_t metric, const std::vector<Told>& told) {
  std::vector<double> values;
  for (const Told& t : told) {
    if (t.values[metric]) values.push_back(*t.values[metric]);
  }
  if (values.empty()) return {};
  return surrogate::OutputTransform::standardizing(
      surrogate::TransformKind::identity,
      Eigen::Map<Eigen::VectorXd>(values.data(), index(values.size())));
}

/// A reference of 0 or less has no place on a logarithmic scale: the box would be some hundred
/// standard deviations long. It is moved to a tenth of the observed range below the least value, on
/// that scale.
double reference_in_reach(const ObjectiveView& view, double reference) {
  if (view.process == nullptr || view.transform.kind != surrogate::TransformKind::log) {
    return reference;
  }
  const Eigen::VectorXd& values = view.process->data().values;
  const double least = values.minCoeff(), greatest = values.maxCoeff();
  if (!(least > 0.0)) return reference;  // the fit takes another transform then
  return std::max(reference, least * std::pow(least / greatest, 0.1));
}

}  // namespace

Gain::Gain(const Input& input)
    : problem_(input.problem), models_(input.models), n_samples_(input.n_samples) {
  view_objectives(input);
  view_limits(input);
  choose_front_designs(input);
  draw(input);
}

double Gain::exact(std::size_t metric, const Point& x) const {
  return problem_.metrics[metric].exact(x);
}

void Gain::view_objectives(const Input& input) {
  const std::size_t n = problem_.objectives.size();
  reference_.resize(index(n));
  ideal_.resize(index(n));
  for (std::size_t j = 0; j < n; ++j) {
    const Objective& objective = problem_.objectives[j];
    const Metric& metric = problem_.metrics[objective.metric];
    ObjectiveView view{.metric = objective.metric,
                       .sign = objective.maximize ? -1.0 : 1.0,
                       .transform = {},
                       .process = models_.process(objective.metric)};
    view.transform = view.process != nullptr ? view.process->parameters().transform
                                             : exact_transform(objective.metric, input.told);
    const double in_unit =
        objective.maximize ? -input.reference[index(j)] : input.reference[index(j)];
    reference_[index(j)] = view.to_view(reference_in_reach(view, in_unit));
    const double best = objective.maximize ? metric.greatest : metric.least;
    ideal_[index(j)] = std::isfinite(best) ? view.to_view(best) : -infinity;
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
                   .in_reference = false};
    for (std::size_t j = 0; j < objectives_.size(); ++j) {
      if (objectives_[j].metric != limit.metric) continue;
      // "At least 0.9 of what is maximised" is a nearer reference point, exactly.
      const bool maximized = objectives_[j].sign < 0.0;
      const double bad_end = maximized ? limit.lower : limit.upper;
      const double other_end = maximized ? limit.upper : limit.lower;
      if (!std::isfinite(bad_end)) continue;
      reference_[index(j)] = std::min(reference_[index(j)], objectives_[j].to_view(bad_end));
      view.in_reference = !std::isfinite(other_end);
    }
    limits_.push_back(view);
  }
}

void Gain::choose_front_designs(const Input& input) {
  std::vector<const Told*> fine;
  for (const Told& t : input.told) {
    if (t.ok && t.level == 0) fine.push_back(&t);
  }
  std::vector<Point> xs;
  for (const Told* t : fine) xs.push_back(t->x);
  const Eigen::MatrixXd inputs = problem_.space.features(xs);
  Eigen::MatrixXd means(index(xs.size()), index(objectives_.size()));
  for (std::size_t j = 0; j < objectives_.size() && !xs.empty(); ++j) {
    const ObjectiveView& view = objectives_[j];
    if (view.process != nullptr) {
      means.col(index(j)) = view.sign * view.process->predict(inputs).mean;
    } else {
      for (std::size_t k = 0; k < xs.size(); ++k) {
        means(index(k), index(j)) = view.to_view(exact(view.metric, xs[k]));
      }
    }
  }
  // Layer after layer of the front of the predicted values, likely feasible designs first.
  std::vector<std::size_t> chosen;
  for (const bool want_feasible : {true, false}) {
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < fine.size(); ++k) {
      if (meets_limits(problem_, fine[k]->values, input.tolerance) == want_feasible)
        left.push_back(k);
    }
    while (!left.empty() && chosen.size() < most_front_designs) {
      std::vector<math::Objectives> points;
      for (const std::size_t k : left) points.emplace_back(means.row(index(k)).transpose());
      const auto layer = math::non_dominated(points);
      std::vector<std::size_t> rest;
      for (std::size_t k = 0; k < left.size(); ++k) {
        const bool in_layer = std::find(layer.begin(), layer.end(), k) != layer.end();
        if (in_layer && chosen.size() < most_front_designs) {
          chosen.push_back(left[k]);
        } else if (!in_layer) {
          rest.push_back(left[k]);
        }
      }
      left = std::move(rest);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  for (const std::size_t k : chosen) {
    designs_.push_back(fine[k]->x);
    observed_.push_back(fine[k]->values);
  }
  for (const Suggestion& suggestion : input.pending) {
    if (suggestion.level != 0) continue;
    designs_.push_back(suggestion.x);
    observed_.emplace_back();
  }
}

bool Gain::limits_met(std::size_t design, int sample) const {
  return std::all_of(limits_.begin(), limits_.end(), [&](const LimitView& limit) {
    const bool known = !observed_[design].empty();
    if (known && !observed_[design][limit.metric]) return limit.satisfied_when_absent;
    double value = 0.0;
    if (samples(limit.metric) != nullptr) {
      value = samples(limit.metric)->values()(sample, index(design));
    } else if (problem_.metrics[limit.metric].exact) {
      value = exact(limit.metric, designs_[design]);
    } else {
      return limit.satisfied_when_absent;  // never had a value so far
    }
    return limit.lower <= value && value <= limit.upper;
  });
}

void Gain::draw(const Input& input) {
  const Eigen::MatrixXd inputs = problem_.space.features(designs_);
  samples_.resize(problem_.metrics.size());
  for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
    const auto* process = models_.process(metric);
    if (process == nullptr) continue;
    samples_[metric] = std::make_unique<surrogate::PosteriorSamples>(*process, inputs, n_samples_,
                                                                     input.seed + 104729 * metric);
  }
  std::vector<Eigen::MatrixXd> objectives;
  std::vector<Eigen::VectorXi> feasible;
  for (int s = 0; s < n_samples_; ++s) {
    Eigen::MatrixXd y(index(designs_.size()), index(objectives_.size()));
    Eigen::VectorXi meets(index(designs_.size()));
    std::vector<math::Objectives> good;
    for (std::size_t k = 0; k < designs_.size(); ++k) {
      for (std::size_t j = 0; j < objectives_.size(); ++j) {
        const ObjectiveView& view = objectives_[j];
        y(index(k), index(j)) = view.process != nullptr
                                    ? view.sign * samples(view.metric)->values()(s, index(k))
                                    : view.to_view(exact(view.metric, designs_[k]));
        // A draw beyond what is possible would leave no room for an improvement there.
        y(index(k), index(j)) = std::max(y(index(k), index(j)), ideal_[index(j)]);
      }
      meets[index(k)] = limits_met(k, s) ? 1 : 0;
      if (meets[index(k)] == 1) good.emplace_back(y.row(index(k)).transpose());
    }
    mean_hypervolume_ += math::hypervolume(good, reference_) / n_samples_;
    objectives.push_back(std::move(y));
    feasible.push_back(std::move(meets));
  }
  front_.emplace(objectives, feasible, reference_, ideal_);
}

double Gain::noise_volume() const {
  double volume = 1.0;
  for (const ObjectiveView& view : objectives_) {
    if (view.process != nullptr) volume *= view.process->noise();
  }
  return volume;
}

Gain::Given Gain::predict(const std::vector<Point>& xs) const {
  Given given{.means = std::vector<Eigen::MatrixXd>(samples_.size()),
              .deviations = std::vector<Eigen::VectorXd>(samples_.size()),
              .log_success = {}};
  const Eigen::MatrixXd inputs = problem_.space.features(xs);
  const auto wanted = [&](std::size_t metric) {
    const auto of_limit = [&](const LimitView& l) { return l.metric == metric; };
    const auto of_objective = [&](const ObjectiveView& o) { return o.metric == metric; };
    return std::any_of(limits_.begin(), limits_.end(), of_limit) ||
           std::any_of(objectives_.begin(), objectives_.end(), of_objective);
  };
  for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
    if (!samples_[metric] || !wanted(metric)) continue;
    samples_[metric]->predict(inputs, given.means[metric], given.deviations[metric]);
    given.deviations[metric] = given.deviations[metric].cwiseMax(0.0).cwiseSqrt();
  }
  given.log_success = models_.log_success(inputs);
  return given;
}

Eigen::VectorXd Gain::log_feasible(const Given& given, Eigen::Index k, const Point& x,
                                   bool all_limits) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n_samples_);
  for (const LimitView& limit : limits_) {
    if (limit.in_reference && !all_limits) continue;
    const Eigen::MatrixXd& mean = given.means[limit.metric];
    if (mean.size() == 0) {
      if (!problem_.metrics[limit.metric].exact) continue;  // never had a value so far
      const double value = exact(limit.metric, x);
      if (value < limit.lower || value > limit.upper) result.setConstant(-infinity);
      continue;
    }
    for (Eigen::Index s = 0; s < n_samples_; ++s) {
      result[s] += acquisition::log_probability_within(
          mean(s, k), given.deviations[limit.metric][k], limit.lower, limit.upper);
    }
  }
  return result;
}

Eigen::VectorXd Gain::log_gain(const std::vector<Point>& xs) const {
  const Given given = predict(xs);
  const bool only_feasibility = !front_->any_feasible() && !limits_.empty();
  const Eigen::Index n_objectives = index(objectives_.size());
  Eigen::VectorXd result = given.log_success;
  Eigen::MatrixXd y(n_samples_, n_objectives);
  Eigen::VectorXd deviation(n_objectives);
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    const Point& x = xs[static_cast<std::size_t>(k)];
    const Eigen::VectorXd feasible = log_feasible(given, k, x, only_feasibility);
    if (only_feasibility) {
      result[k] += acquisition::log_mean(feasible);
      continue;
    }
    for (Eigen::Index j = 0; j < n_objectives; ++j) {
      const ObjectiveView& view = objectives_[static_cast<std::size_t>(j)];
      if (view.process != nullptr) {
        y.col(j) = view.sign * given.means[view.metric].col(k);
        deviation[j] = given.deviations[view.metric][k];
      } else {
        y.col(j).setConstant(view.to_view(exact(view.metric, x)));
        deviation[j] = 0.0;
      }
    }
    result[k] += front_->log_improvement(y, deviation, feasible);
  }
  return result;
}

Eigen::VectorXd Gain::log_ignorance(const std::vector<Point>& xs) const {
  const Given given = predict(xs);
  Eigen::VectorXd result = given.log_success;
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    const Point& x = xs[static_cast<std::size_t>(k)];
    double largest = 0.0;
    for (const ObjectiveView& view : objectives_) {
      if (view.process != nullptr) largest = std::max(largest, given.deviations[view.metric][k]);
    }
    result[k] += 2.0 * std::log(largest) + acquisition::log_mean(log_feasible(given, k, x, true));
  }
  return result;
}

}  // namespace parapet::bayesian
