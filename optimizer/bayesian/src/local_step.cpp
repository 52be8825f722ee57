#include "local_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "candidates.hpp"
#include "composed.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::bayesian {
namespace {

constexpr double first_width = 0.2, most_width = 0.4, least_width = 1e-6;
constexpr double most_worse = 10.0;      // of what a model of the neighbourhood is to resolve
constexpr double share_of_noise = 0.25;  // a step that promises less is not worth an evaluation

double distance(const std::vector<double>& u, const std::vector<double>& v) {
  double largest = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  return largest;
}

/// The variables that a step may change.
std::vector<std::size_t> free_variables(const Space& space, const Point& x) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool moves = space.variables()[i].kind == VariableKind::continuous;
    if (moves && space.active(x, i)) free.push_back(i);
  }
  return free;
}

/// Whether two designs differ in free variables only.
bool same_kind(const Space& space, const Point& a, const Point& b) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return false;
    const bool moves = space.variables()[i].kind == VariableKind::continuous;
    if (!moves && !std::isnan(a[i]) && a[i] != b[i]) return false;
  }
  return true;
}

/// Surrogates of one neighbourhood. Inputs are the free variables, scaled to its size.
class Neighbourhood {
 public:
  Neighbourhood(const Problem& problem, const std::vector<Told>& told, const TrustRegion& region,
                std::uint64_t seed)
      : problem_(problem),
        best_(told[region.best]),
        center_(problem.space.to_unit(best_.x)),
        free_(free_variables(problem.space, best_.x)),
        half_width_(region.half_width),
        objective_inputs_(modelled_inputs(problem, problem.objectives.front().metric)) {
    choose_designs(told);
    if (enough()) fit(seed);
  }

  bool enough() const { return !free_.empty() && designs_.size() >= free_.size() + 2; }
  bool modelled() const {
    return !objective_inputs_.empty() &&
           std::all_of(objective_inputs_.begin(), objective_inputs_.end(),
                       [&](std::size_t metric) { return processes_[metric].has_value(); });
  }
  std::size_t n_free() const { return free_.size(); }

  /// The design at v [n_free], 0 .. 1 across the trust region.
  Point design(const std::vector<double>& v) const {
    std::vector<double> u = center_;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const double lower = std::max(0.0, center_[free_[k]] - half_width_);
      const double upper = std::min(1.0, center_[free_[k]] + half_width_);
      u[free_[k]] = lower + v[k] * (upper - lower);
    }
    Point x = best_.x;
    const Point moved = problem_.space.from_unit(u);
    for (const std::size_t i : free_) x[i] = moved[i];
    return problem_.space.canonical(x);
  }

  /// v of the best design.
  std::vector<double> middle() const {
    std::vector<double> v;
    for (const std::size_t i : free_) {
      const double lower = std::max(0.0, center_[i] - half_width_);
      const double upper = std::min(1.0, center_[i] + half_width_);
      v.push_back((center_[i] - lower) / (upper - lower));
    }
    return v;
  }

  /// Objective, minimised, in model units (a composed one: over its spread), and violations of the
  /// limits over their deviation there.
  optimizer::Evaluation predict(const std::vector<double>& v) const {
    const Point x = design(v);
    const Eigen::MatrixXd at = inputs_of(x);
    optimizer::Evaluation answer{.ok = true, .reason = {}, .objective = 0.0, .constraints = {}};
    answer.objective = sign() * mean_of(objective_metric(), x, at) / scale_;
    for (const Limit& limit : problem_.limits) {
      const Metric& metric = problem_.metrics[limit.metric];
      double value = 0.0, margin = 0.0, lower = limit.lower, upper = limit.upper;
      if (metric.exact) {
        value = metric.exact(x);
      } else if (metric.is_composed()) {
        if (!predictable(limit.metric)) continue;
        const double unit = spread_of(limit.metric);
        value = mean_of(limit.metric, x, at) / unit;
        if (std::isnan(value)) value = std::numeric_limits<double>::max();
        margin = 0.5 * deviation_of(limit.metric, x, at) / unit;
        lower /= unit;
        upper /= unit;
      } else if (const auto& process = processes_[limit.metric]) {
        const surrogate::Prediction prediction = process->predict(at);
        value = prediction.mean[0];
        // On the safe side of a limit by half of what is uncertain.
        margin = 0.5 * std::sqrt(prediction.variance[0]);
        if (std::isfinite(lower)) lower = process->to_model(lower);
        if (std::isfinite(upper)) upper = process->to_model(upper);
      } else {
        continue;
      }
      if (std::isfinite(lower)) answer.constraints.push_back(lower - value + margin);
      if (std::isfinite(upper)) answer.constraints.push_back(value - upper + margin);
    }
    return answer;
  }

  std::size_t n_constraints() const { return predict(middle()).constraints.size(); }

  double deviation(const std::vector<double>& v) const {
    const Point x = design(v);
    return deviation_of(objective_metric(), x, inputs_of(x)) / scale_;
  }

  /// Of the best design as observed, in the unit of predict().
  double best_objective() const {
    const std::size_t metric = objective_metric();
    const double value = *best_.values[metric];
    return sign() * (processes_[metric] ? processes_[metric]->to_model(value) : value / scale_);
  }
  double noise() const {
    const std::size_t metric = objective_metric();
    if (processes_[metric]) return processes_[metric]->noise();
    const auto& inputs = objective_inputs_;
    Eigen::VectorXd middle(static_cast<Eigen::Index>(inputs.size())), sd = middle;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      middle[row] = processes_[inputs[i]]->to_model(*best_.values[inputs[i]]);
      sd[row] = processes_[inputs[i]]->noise();
    }
    return split(local_inputs(metric, best_.x), middle, sd).deviation / scale_;
  }

 private:
  double sign() const { return problem_.objectives.front().maximize ? -1.0 : 1.0; }
  std::size_t objective_metric() const { return problem_.objectives.front().metric; }

  bool predictable(std::size_t metric) const {
    const auto inputs = modelled_inputs(problem_, metric);
    return std::all_of(inputs.begin(), inputs.end(),
                       [&](std::size_t input) { return processes_[input].has_value(); });
  }

  /// A composed metric of its inputs in the local models' units.
  OfInputs local_inputs(std::size_t metric, const Point& x) const {
    return [this, metric, &x](const Eigen::VectorXd& z) {
      const Composition& composition = problem_.metrics[metric].composition;
      std::vector<double> values;
      for (std::size_t i = 0; i < composition.inputs.size(); ++i) {
        const Metric& input = problem_.metrics[composition.inputs[i]];
        values.push_back(std::clamp(
            processes_[composition.inputs[i]]->from_model(z[static_cast<Eigen::Index>(i)]),
            input.least, input.greatest));
      }
      return composition.value(x, values);
    };
  }

  /// Predictions of a metric's inputs: mean and deviation [n_inputs].
  std::pair<Eigen::VectorXd, Eigen::VectorXd> predict_inputs(std::size_t metric,
                                                             const Eigen::MatrixXd& at) const {
    const auto& inputs = problem_.metrics[metric].composition.inputs;
    Eigen::VectorXd mean(static_cast<Eigen::Index>(inputs.size())), sd = mean;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const surrogate::Prediction one = processes_[inputs[i]]->predict(at);
      mean[static_cast<Eigen::Index>(i)] = one.mean[0];
      sd[static_cast<Eigen::Index>(i)] = std::sqrt(std::max(0.0, one.variance[0]));
    }
    return {mean, sd};
  }

  /// Model units, of a composed metric its own.
  double mean_of(std::size_t metric, const Point& x, const Eigen::MatrixXd& at) const {
    if (processes_[metric]) return processes_[metric]->predict(at).mean[0];
    const double value = local_inputs(metric, x)(predict_inputs(metric, at).first);
    // What has no value is as bad as can be.
    return std::isfinite(value) ? value
                                : sign() * 1e3 * scale_ + best_.values[metric].value_or(0.0);
  }
  double deviation_of(std::size_t metric, const Point& x, const Eigen::MatrixXd& at) const {
    if (processes_[metric]) return std::sqrt(processes_[metric]->predict(at).variance[0]);
    const auto [mean, sd] = predict_inputs(metric, at);
    return split(local_inputs(metric, x), mean, sd).deviation;
  }

  /// Standard deviation of a composed metric over the designs taken.
  double spread_of(std::size_t metric) const {
    double n = 0.0, sum = 0.0, squares = 0.0;
    for (const Told* t : designs_) {
      if (!t->values[metric]) continue;
      n += 1.0;
      sum += *t->values[metric];
      squares += *t->values[metric] * *t->values[metric];
    }
    const double variance = n > 1.0 ? (squares - sum * sum / n) / (n - 1.0) : 0.0;
    return variance > 0.0 ? std::sqrt(variance) : 1.0;
  }

  void choose_designs(const std::vector<Told>& told) {
    processes_.resize(problem_.metrics.size());
    std::vector<std::pair<double, const Told*>> by_distance;
    for (const Told& t : told) {
      if (!t.ok || t.level != 0 || !same_kind(problem_.space, t.x, best_.x)) continue;
      by_distance.emplace_back(distance(problem_.space.to_unit(t.x), center_), &t);
    }
    std::stable_sort(by_distance.begin(), by_distance.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t most = 6 * free_.size() + 12;
    if (by_distance.size() > most) by_distance.resize(most);
    for (const auto& [d, t] : by_distance) designs_.push_back(t);
    if (!by_distance.empty()) reach_ = std::max(by_distance.back().first, 1e-12);
  }

  Eigen::RowVectorXd inputs_of(const Point& x) const {
    const std::vector<double> u = problem_.space.to_unit(x);
    Eigen::RowVectorXd row(static_cast<Eigen::Index>(free_.size()));
    for (std::size_t k = 0; k < free_.size(); ++k) {
      row[static_cast<Eigen::Index>(k)] = 0.5 + 0.5 * (u[free_[k]] - center_[free_[k]]) / reach_;
    }
    return row;
  }

  /// Objectives far worse than the best few are as bad as they need to be: a cliff, or a steep wall
  /// of a valley, would else decide the scales of the model.
  void limit_the_worst(Eigen::VectorXd& values) const {
    std::vector<double> sorted;
    for (const double value : values) sorted.push_back(sign() * value);
    std::sort(sorted.begin(), sorted.end());
    const std::size_t few = std::min(free_.size() + 1, sorted.size() - 1);
    const double worst = sorted.front() + most_worse * (sorted[few] - sorted.front());
    for (double& value : values) value = sign() * std::min(sign() * value, worst);
  }

  void fit(std::uint64_t seed) {
    surrogate::Layout layout;
    layout.group.resize(free_.size());
    std::iota(layout.group.begin(), layout.group.end(), 0);
    const auto fit_metric = [&](std::size_t metric) {
      if (processes_[metric]) return;
      std::vector<const Told*> rows;
      for (const Told* t : designs_) {
        if (t->values[metric]) rows.push_back(t);
      }
      if (rows.size() < free_.size() + 2) return;
      surrogate::Data data;
      data.inputs.resize(static_cast<Eigen::Index>(rows.size()),
                         static_cast<Eigen::Index>(free_.size()));
      data.values.resize(static_cast<Eigen::Index>(rows.size()));
      for (std::size_t k = 0; k < rows.size(); ++k) {
        data.inputs.row(static_cast<Eigen::Index>(k)) = inputs_of(rows[k]->x);
        data.values[static_cast<Eigen::Index>(k)] = *rows[k]->values[metric];
      }
      if (metric == problem_.objectives.front().metric) limit_the_worst(data.values);
      surrogate::FitOptions options;
      options.starts = 2;
      options.seed = seed + 7919 * metric;
      options.transform = problem_.metrics[metric].transform;
      if (!problem_.metrics[metric].known_noise.empty()) {
        options.known_noise = {problem_.metrics[metric].known_noise.front()};
      }
      processes_[metric] = surrogate::GaussianProcess::fit(layout, data, options);
    };
    for (const std::size_t input : objective_inputs_) fit_metric(input);
    for (const Limit& limit : problem_.limits) {
      for (const std::size_t input : modelled_inputs(problem_, limit.metric)) fit_metric(input);
    }
    if (problem_.metrics[objective_metric()].is_composed()) scale_ = spread_of(objective_metric());
  }

  const Problem& problem_;
  const Told& best_;
  std::vector<double> center_;
  std::vector<std::size_t> free_;
  double half_width_;
  std::vector<std::size_t> objective_inputs_;  // metrics with surrogates that it hangs on
  double scale_ = 1.0;                         // of a composed objective, else 1
  double reach_ = 1.0;                         // of the designs taken, share of each range
  std::vector<const Told*> designs_;           // nearest first
  std::vector<std::optional<surrogate::GaussianProcess>> processes_;  // [n_metrics]
};

/// NLopt's COBYLA on the surrogates, from the best design.
std::optional<std::vector<double>> least_mean(const Problem& problem, const Neighbourhood& near,
                                              double tolerance, std::uint64_t seed) {
  optimizer::Problem scalar;
  scalar.lower.assign(near.n_free(), 0.0);
  scalar.upper.assign(near.n_free(), 1.0);
  for (std::size_t k = 0; k < near.n_free(); ++k) scalar.names.push_back("v" + std::to_string(k));
  scalar.n_constraints = static_cast<int>(near.n_constraints());
  scalar.evaluate = [&](const std::vector<double>& v) { return near.predict(v); };
  if (problem.cheap_constraints) {
    scalar.cheap_constraints = [&](const std::vector<double>& v) {
      return problem.cheap_constraints(near.design(v));
    };
    scalar.n_cheap_constraints =
        static_cast<int>(problem.cheap_constraints(near.design(near.middle())).size());
  }
  optimizer::Options options;
  options.algorithm = "COBYLA";
  options.max_evaluations = 60 * static_cast<int>(near.n_free()) + 40;
  options.relative_tolerance = 1e-5;
  options.initial_step = 0.25;
  options.seed = seed;
  options.feasibility_tolerance = tolerance;
  options.starts = {near.middle()};
  for (double& v : options.starts.front()) v = std::clamp(v, 0.0, 1.0);
  const optimizer::OptimizeResult result = optimizer::optimize(scalar, options);
  if (result.best) return result.best->x;
  // The best design lies outside the surrogate's limits by its margin: the least violation then.
  if (result.best_infeasible) return result.best_infeasible->x;
  return std::nullopt;
}

}  // namespace

std::optional<TrustRegion> trust_region(const Problem& problem, const std::vector<Told>& told,
                                        double tolerance) {
  std::optional<TrustRegion> region;
  double best = 0.0;
  int failures = 0;
  const int most_failures = std::max(2, static_cast<int>(problem.space.size()) / 2);
  for (std::size_t k = 0; k < told.size(); ++k) {
    const Told& t = told[k];
    if (t.level != 0) continue;
    const bool feasible =
        t.ok && meets_limits(problem, t.values, tolerance) && allowed(problem, t.x, tolerance);
    const auto y = feasible ? minimized(problem, t.values) : std::nullopt;
    const bool improves = y && (!region || (*y)[0] < best);
    if (!region) {
      if (improves) region = TrustRegion{k, first_width};
      if (improves) best = (*y)[0];
      continue;
    }
    const double step =
        distance(problem.space.to_unit(t.x), problem.space.to_unit(told[region->best].x));
    if (improves) {
      best = (*y)[0];
      region->best = k;
      failures = 0;
      if (step > region->half_width * (1.0 + 1e-9)) {
        region->half_width = first_width;  // another hill
      } else if (step > 0.5 * region->half_width) {
        region->half_width = std::min(most_width, 2.0 * region->half_width);
      }
    } else if (step <= region->half_width * (1.0 + 1e-9) && ++failures >= most_failures) {
      failures = 0;
      region->half_width = std::max(least_width, 0.5 * region->half_width);
    }
  }
  return region;
}

namespace {

/// Calls f(evaluation, improvement) for all that was told, in order: by how much each made the best
/// feasible design better, 0 for those that did not.
template <typename F>
void for_each_improvement(const Problem& problem, const std::vector<Told>& told, double tolerance,
                          const F& f) {
  std::optional<double> best;
  for (const Told& t : told) {
    const bool feasible = t.ok && meets_limits(problem, t.values, tolerance);
    const auto y = feasible ? minimized(problem, t.values) : std::nullopt;
    f(t, y && best ? std::max(0.0, *best - (*y)[0]) : 0.0);
    if (y && (!best || (*y)[0] < *best)) best = (*y)[0];
  }
}

}  // namespace

int idle_evaluations(const Problem& problem, const std::vector<Told>& told, double tolerance) {
  int idle = 0;
  for_each_improvement(problem, told, tolerance, [&](const Told& t, double improvement) {
    if (!t.local) idle = improvement > 0.0 ? 0 : idle + 1;
  });
  return idle;
}

bool local_turn(const Problem& problem, const std::vector<Told>& told, double tolerance) {
  constexpr int most_running = 3;
  double gain_local = 0.0, gain_global = 0.0;
  int running = 0;  // evaluations of the last one's kind
  bool last_local = false;
  for_each_improvement(problem, told, tolerance, [&](const Told& t, double improvement) {
    double& gain = t.local ? gain_local : gain_global;
    gain = 0.5 * (gain + improvement);
    running = t.local == last_local ? running + 1 : 1;
    last_local = t.local;
  });
  if (gain_local == gain_global) return !last_local;
  const bool better_local = gain_local > gain_global;
  return running >= most_running && last_local == better_local ? !better_local : better_local;
}

std::optional<Point> local_step(const Problem& problem, const std::vector<Told>& told,
                                const TrustRegion& region, double tolerance, std::uint64_t seed) {
  const Neighbourhood near(problem, told, region, seed);
  if (!near.enough() || !near.modelled()) return std::nullopt;
  const auto known = [&](const Point& x) {
    const std::vector<double> u = problem.space.to_unit(x);
    return std::any_of(told.begin(), told.end(), [&](const Told& t) {
      return t.level == 0 && same_kind(problem.space, t.x, x) &&
             distance(problem.space.to_unit(t.x), u) < 1e-3 * region.half_width;
    });
  };
  if (auto v = least_mean(problem, near, tolerance, seed)) {
    const double promised = near.best_objective() - near.predict(*v).objective;
    Point x = near.design(*v);
    if (promised > share_of_noise * near.noise() && !known(x)) return x;
  }
  if (near.noise() > 0.1) return std::nullopt;  // no digits to be had
  // The surrogate's least design is known: learn where it knows least.
  Random random(seed, 17);
  std::optional<Point> most_unknown;
  double most = 0.0;
  for (std::size_t k = 0; k < 32 * near.n_free(); ++k) {
    std::vector<double> v;
    for (std::size_t i = 0; i < near.n_free(); ++i) v.push_back(random.uniform());
    const Point x = near.design(v);
    const double unknown = near.deviation(v);
    if (unknown <= most || known(x) || !allowed(problem, x, tolerance)) continue;
    most = unknown;
    most_unknown = x;
  }
  return most_unknown;
}

}  // namespace parapet::bayesian
