#include "parapet/bayesian/space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace parapet::bayesian {
namespace {

constexpr double inactive = std::numeric_limits<double>::quiet_NaN();

double n_values(const Variable& variable) {
  return std::floor(variable.upper) - std::ceil(variable.lower) + 1.0;
}

void check(const std::vector<Variable>& variables, std::size_t i) {
  const Variable& v = variables[i];
  const bool one_value_is_enough = v.kind != VariableKind::continuous;
  const bool ordered = one_value_is_enough ? n_values(v) >= 1.0 : v.lower < v.upper;
  if (!std::isfinite(v.lower) || !std::isfinite(v.upper) || !ordered) {
    throw std::invalid_argument("the bounds of " + v.name +
                                " are not in order; allowed: lower < upper");
  }
  if (v.kind == VariableKind::choice && v.lower != 0.0) {
    throw std::invalid_argument("the options of " + v.name + " do not start at 0");
  }
  if (!v.active_when) return;
  const std::size_t k = v.active_when->choice;
  if (k >= i || variables[k].kind != VariableKind::choice) {
    throw std::invalid_argument("the condition of " + v.name + " is not on an earlier choice");
  }
}

double rounded_in_bounds(const Variable& v, double value) {
  if (v.kind == VariableKind::continuous) return std::clamp(value, v.lower, v.upper) + 0.0;
  return std::clamp(std::round(value), std::ceil(v.lower), std::floor(v.upper)) + 0.0;
}

}  // namespace

bool same_design(const Point& a, const Point& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    if (a[i] != b[i]) return false;
  }
  return true;
}

Space::Space(std::vector<Variable> variables) : variables_(std::move(variables)) {
  for (std::size_t i = 0; i < variables_.size(); ++i) check(variables_, i);
}

bool Space::active(const Point& x, std::size_t variable) const {
  const auto& condition = variables_[variable].active_when;
  if (!condition) return true;
  if (!active(x, condition->choice)) return false;
  const double taken = x[condition->choice];
  return std::any_of(condition->options.begin(), condition->options.end(),
                     [&](int option) { return taken == static_cast<double>(option); });
}

Point Space::canonical(const Point& x) const {
  if (x.size() != variables_.size()) throw std::invalid_argument("a point of a wrong length");
  Point result(x.size(), inactive);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!active(result, i)) continue;
    if (std::isnan(x[i])) throw std::invalid_argument(variables_[i].name + " has no value");
    result[i] = rounded_in_bounds(variables_[i], x[i]);
  }
  return result;
}

Point Space::from_unit(const std::vector<double>& u) const {
  Point x(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Variable& v = variables_[i];
    const double share = std::clamp(u[i], 0.0, 1.0);
    if (v.kind == VariableKind::continuous) {
      x[i] = v.lower + share * (v.upper - v.lower);
    } else {
      x[i] = std::ceil(v.lower) + std::min(std::floor(share * n_values(v)), n_values(v) - 1.0);
    }
  }
  return canonical(x);
}

std::vector<double> Space::to_unit(const Point& x) const {
  std::vector<double> u(x.size(), 0.5);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = variables_[i];
    if (!active(x, i)) continue;
    if (v.kind == VariableKind::continuous) {
      u[i] = std::clamp((x[i] - v.lower) / (v.upper - v.lower), 0.0, 1.0);
    } else {
      u[i] = (x[i] - std::ceil(v.lower) + 0.5) / n_values(v);
    }
  }
  return u;
}

surrogate::Layout Space::layout(int n_levels) const {
  surrogate::Layout layout;
  layout.n_levels = n_levels;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const bool choice = variables_[i].kind == VariableKind::choice;
    const auto columns = choice ? static_cast<std::size_t>(n_values(variables_[i])) : 1U;
    layout.group.insert(layout.group.end(), columns, static_cast<int>(i));
  }
  return layout;
}

Eigen::RowVectorXd Space::features(const Point& x) const {
  const std::vector<double> u = to_unit(x);
  std::vector<double> row;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Variable& v = variables_[i];
    if (v.kind != VariableKind::choice) {
      row.push_back(u[i]);
      continue;
    }
    // An inactive choice has taken none of its options.
    for (double option = 0.0; option < n_values(v); option += 1.0) {
      row.push_back(active(x, i) && x[i] == option ? std::sqrt(0.5) : 0.0);
    }
  }
  return Eigen::Map<Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

Eigen::MatrixXd Space::features(const std::vector<Point>& xs) const {
  const auto n_features = static_cast<Eigen::Index>(layout().group.size());
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(xs.size()), n_features);
  for (std::size_t k = 0; k < xs.size(); ++k) {
    matrix.row(static_cast<Eigen::Index>(k)) = features(xs[k]);
  }
  return matrix;
}

std::vector<Point> Space::choice_combinations(std::size_t limit) const {
  std::vector<Point> combinations{Point(variables_.size(), inactive)};
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (variables_[i].kind != VariableKind::choice) continue;
    std::vector<Point> extended;
    for (const Point& partial : combinations) {
      if (!active(partial, i)) {
        extended.push_back(partial);
        continue;
      }
      for (double option = 0.0; option < n_values(variables_[i]); option += 1.0) {
        extended.push_back(partial);
        extended.back()[i] = option;
      }
    }
    if (extended.size() > limit) extended.resize(limit);
    combinations = std::move(extended);
  }
  return combinations;
}

}  // namespace parapet::bayesian
