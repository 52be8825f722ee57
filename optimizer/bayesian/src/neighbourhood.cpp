#include "neighbourhood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace parapet::bayesian {
namespace {

constexpr double most_worse = 10.0;  // of what a model of the neighbourhood is to resolve

/// The variables that a step may change.
std::vector<std::size_t> free_variables(const Space& space, const Point& x) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool moves = space.variables()[i].kind == VariableKind::continuous;
    if (moves && space.active(x, i)) free.push_back(i);
  }
  return free;
}

}  // namespace

double distance(const std::vector<double>& u, const std::vector<double>& v) {
  double largest = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  return largest;
}

bool same_kind(const Space& space, const Point& a, const Point& b) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return false;
    const bool moves = space.variables()[i].kind == VariableKind::continuous;
    if (!moves && !std::isnan(a[i]) && a[i] != b[i]) return false;
  }
  return true;
}

Neighbourhood::Neighbourhood(const Problem& problem, const std::vector<Told>& told,
                             const TrustRegion& region, std::uint64_t seed)

    : problem_(problem),
      best_(told[region.best]),
      center_(problem.space.to_unit(best_.x)),
      free_(free_variables(problem.space, best_.x)),
      half_width_(region.half_width),
      objective_inputs_(modelled_inputs(problem, problem.objectives.front().metric)) {
  choose_designs(told);
  if (enough()) fit(seed);
}

bool Neighbourhood::modelled() const {
  return !objective_inputs_.empty() &&
         std::all_of(objective_inputs_.begin(), objective_inputs_.end(),
                     [&](std::size_t metric) { return processes_[metric].has_value(); });
}

Point Neighbourhood::design(const std::vector<double>& v) const {
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

std::vector<double> Neighbourhood::middle() const {
  std::vector<double> v;
  for (const std::size_t i : free_) {
    const double lower = std::max(0.0, center_[i] - half_width_);
    const double upper = std::min(1.0, center_[i] + half_width_);
    v.push_back((center_[i] - lower) / (upper - lower));
  }
  return v;
}

optimizer::Evaluation Neighbourhood::predict(const std::vector<double>& v) const {
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

double Neighbourhood::deviation(const std::vector<double>& v) const {
  const Point x = design(v);
  return deviation_of(objective_metric(), x, inputs_of(x)) / scale_;
}

double Neighbourhood::best_objective() const {
  const std::size_t metric = objective_metric();
  const double value = *best_.values[metric];
  return sign() * (processes_[metric] ? processes_[metric]->to_model(value) : value / scale_);
}

double Neighbourhood::noise() const {
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

bool Neighbourhood::predictable(std::size_t metric) const {
  const auto inputs = modelled_inputs(problem_, metric);
  return std::all_of(inputs.begin(), inputs.end(),
                     [&](std::size_t input) { return processes_[input].has_value(); });
}

OfInputs Neighbourhood::local_inputs(std::size_t metric, const Point& x) const {
  return [this, metric, &x](const Eigen::VectorXd& z) {
    const Composition& composition = problem_.metrics[metric].composition;
    std::vector<double> values;
    for (std::size_t i = 0; i < composition.inputs.size(); ++i) {
      const Metric& input = problem_.metrics[composition.inputs[i]];
      values.push_back(
          std::clamp(processes_[composition.inputs[i]]->from_model(z[static_cast<Eigen::Index>(i)]),
                     input.least, input.greatest));
    }
    return composition.value(x, values);
  };
}

std::pair<Eigen::VectorXd, Eigen::VectorXd> Neighbourhood::predict_inputs(
    std::size_t metric, const Eigen::MatrixXd& at) const {
  const auto& inputs = problem_.metrics[metric].composition.inputs;
  Eigen::VectorXd mean(static_cast<Eigen::Index>(inputs.size())), sd = mean;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const surrogate::Prediction one = processes_[inputs[i]]->predict(at);
    mean[static_cast<Eigen::Index>(i)] = one.mean[0];
    sd[static_cast<Eigen::Index>(i)] = std::sqrt(std::max(0.0, one.variance[0]));
  }
  return {mean, sd};
}

double Neighbourhood::mean_of(std::size_t metric, const Point& x, const Eigen::MatrixXd& at) const {
  if (processes_[metric]) return processes_[metric]->predict(at).mean[0];
  const double value = local_inputs(metric, x)(predict_inputs(metric, at).first);
  // What has no value is as bad as can be.
  return std::isfinite(value) ? value : sign() * 1e3 * scale_ + best_.values[metric].value_or(0.0);
}

double Neighbourhood::deviation_of(std::size_t metric, const Point& x,
                                   const Eigen::MatrixXd& at) const {
  if (processes_[metric]) return std::sqrt(processes_[metric]->predict(at).variance[0]);
  const auto [mean, sd] = predict_inputs(metric, at);
  return split(local_inputs(metric, x), mean, sd).deviation;
}

double Neighbourhood::spread_of(std::size_t metric) const {
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

void Neighbourhood::choose_designs(const std::vector<Told>& told) {
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

Eigen::RowVectorXd Neighbourhood::inputs_of(const Point& x) const {
  const std::vector<double> u = problem_.space.to_unit(x);
  Eigen::RowVectorXd row(static_cast<Eigen::Index>(free_.size()));
  for (std::size_t k = 0; k < free_.size(); ++k) {
    row[static_cast<Eigen::Index>(k)] = 0.5 + 0.5 * (u[free_[k]] - center_[free_[k]]) / reach_;
  }
  return row;
}

void Neighbourhood::limit_the_worst(Eigen::VectorXd& values) const {
  std::vector<double> sorted;
  for (const double value : values) sorted.push_back(sign() * value);
  std::sort(sorted.begin(), sorted.end());
  const std::size_t few = std::min(free_.size() + 1, sorted.size() - 1);
  const double worst = sorted.front() + most_worse * (sorted[few] - sorted.front());
  for (double& value : values) value = sign() * std::min(sign() * value, worst);
}

void Neighbourhood::fit(std::uint64_t seed) {
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

}  // namespace parapet::bayesian
