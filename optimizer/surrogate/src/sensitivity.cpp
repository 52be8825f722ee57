#include "parapet/surrogate/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "parapet/optimizer/sobol.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {
namespace {

void refuse_unless(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("sensitivity: " + message);
}

/// Sobol' points while the table has enough coordinates; beyond it all coordinates are independent,
/// since estimators that compare two halves of a point need both of one kind.
Eigen::MatrixXd sample(int n, int dimension, std::uint64_t seed) {
  if (dimension <= optimizer::SobolSequence::max_dimension) return unit_points(n, dimension, seed);
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd points(n, dimension);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index d = 0; d < dimension; ++d) points(i, d) = uniform(generator);
  }
  return points;
}

/// Quantile of sorted values, linear between order statistics.
double quantile(const std::vector<double>& sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// The middle 95 % of the values, widened to hold the estimate.
Interval interval(double estimate, std::vector<double> values) {
  if (values.empty()) return {estimate, estimate, estimate};
  std::sort(values.begin(), values.end());
  return {estimate, std::min(estimate, quantile(values, 0.025)),
          std::max(estimate, quantile(values, 0.975))};
}

/// The model's answers at the base points and at A with one column from B, [N, n_realisations]
/// each.
struct Answers {
  Eigen::MatrixXd a, b;
  std::vector<Eigen::MatrixXd> mixed;  // [n_variables]
};

Eigen::MatrixXd ask(const Realisations& model, const Eigen::MatrixXd& u, Eigen::Index columns) {
  Eigen::MatrixXd y = model(u);
  refuse_unless(y.rows() == u.rows() && y.cols() >= 1 && (columns == 0 || y.cols() == columns),
                "the model answered " + std::to_string(y.rows()) + " x " +
                    std::to_string(y.cols()) + " values to " + std::to_string(u.rows()) +
                    " points");
  refuse_unless(y.allFinite(), "the model answered a value that is not finite");
  return y;
}

Answers ask_all(const Realisations& model, int n_variables, const SensitivityOptions& options) {
  const Eigen::MatrixXd points = sample(options.base_points, 2 * n_variables, options.seed);
  const Eigen::MatrixXd a = points.leftCols(n_variables), b = points.rightCols(n_variables);
  Answers answers;
  answers.a = ask(model, a, 0);
  answers.b = ask(model, b, answers.a.cols());
  for (int i = 0; i < n_variables; ++i) {
    Eigen::MatrixXd mixed = a;
    mixed.col(i) = b.col(i);
    answers.mixed.push_back(ask(model, mixed, answers.a.cols()));
  }
  return answers;
}

/// Estimates from the rows with their weights [N] (how often a bootstrap drew them), realisation c.
struct Estimate {
  Eigen::VectorXd first, total;  // [n_variables]
};
Estimate estimate(const Answers& answers, const Eigen::VectorXd& weight, Eigen::Index c) {
  const double n = weight.sum();
  // Centred: the estimator of the first-order part is then less noisy, and no less correct.
  const double mean = 0.5 * (weight.dot(answers.a.col(c)) + weight.dot(answers.b.col(c))) / n;
  const Eigen::ArrayXd a = answers.a.col(c).array() - mean;
  const Eigen::ArrayXd b = answers.b.col(c).array() - mean;
  const Eigen::ArrayXd w = weight.array() / n;
  const double variance = 0.5 * ((w * a.square()).sum() + (w * b.square()).sum());
  const auto d = static_cast<Eigen::Index>(answers.mixed.size());
  Estimate result{Eigen::VectorXd::Zero(d), Eigen::VectorXd::Zero(d)};
  if (!(variance > 1e-24 * (mean * mean) && variance > 0.0)) return result;
  for (Eigen::Index i = 0; i < d; ++i) {
    const Eigen::ArrayXd mixed = answers.mixed[static_cast<std::size_t>(i)].col(c).array() - mean;
    result.first(i) = (w * b * (mixed - a)).sum() / variance;  // Saltelli 2010, table 2 (b)
    result.total(i) = 0.5 * (w * (a - mixed).square()).sum() / variance;  // Jansen, table 2 (f)
  }
  return result;
}

Eigen::VectorXd resampled(Eigen::Index n, std::mt19937_64& generator) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    weight(static_cast<Eigen::Index>(uniform(generator) * static_cast<double>(n))) += 1.0;
  }
  return weight;
}

}  // namespace

std::vector<SobolIndices> sobol_indices(const Realisations& model, int n_variables,
                                        const SensitivityOptions& options) {
  refuse_unless(n_variables >= 1,
                "n_variables is " + std::to_string(n_variables) + ", at least 1 needed");
  refuse_unless(options.base_points >= 2,
                "base_points is " + std::to_string(options.base_points) + ", at least 2 needed");
  refuse_unless(options.bootstrap >= 0, "bootstrap must be at least 0");
  const Answers answers = ask_all(model, n_variables, options);
  const Eigen::Index n = answers.a.rows(), n_realisations = answers.a.cols();
  const auto d = static_cast<std::size_t>(n_variables);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(n_variables), total = first;
  std::vector<std::vector<double>> firsts(d), totals(d);
  std::mt19937_64 generator(options.seed ^ 0x9e3779b97f4a7c15ULL);
  const auto record = [&](const Estimate& e) {
    for (std::size_t i = 0; i < d; ++i) {
      firsts[i].push_back(e.first(static_cast<Eigen::Index>(i)));
      totals[i].push_back(e.total(static_cast<Eigen::Index>(i)));
    }
  };
  const Eigen::VectorXd once = Eigen::VectorXd::Ones(n);
  for (Eigen::Index c = 0; c < n_realisations; ++c) {
    const Estimate e = estimate(answers, once, c);
    first += e.first / static_cast<double>(n_realisations);
    total += e.total / static_cast<double>(n_realisations);
    if (options.bootstrap == 0) record(e);
  }
  for (int r = 0; r < options.bootstrap; ++r) {
    const Eigen::VectorXd weight = resampled(n, generator);
    for (Eigen::Index c = 0; c < n_realisations; ++c) record(estimate(answers, weight, c));
  }
  std::vector<SobolIndices> indices;
  for (std::size_t i = 0; i < d; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    indices.push_back({interval(first(k), firsts[i]), interval(total(k), totals[i])});
  }
  return indices;
}

std::vector<MainEffect> main_effects(const Realisations& model, int n_variables, int n_grid,
                                     int n_points, std::uint64_t seed) {
  refuse_unless(n_variables >= 1,
                "n_variables is " + std::to_string(n_variables) + ", at least 1 needed");
  refuse_unless(n_grid >= 1 && n_points >= 1, "n_grid and n_points must be at least 1");
  const Eigen::MatrixXd points = sample(n_points, n_variables, seed);
  std::vector<MainEffect> effects(static_cast<std::size_t>(n_variables));
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (int g = 0; g < n_grid; ++g) {
      const double place = n_grid == 1 ? 0.5 : static_cast<double>(g) / (n_grid - 1);
      Eigen::MatrixXd u = points;
      u.col(static_cast<Eigen::Index>(i)).setConstant(place);
      const Eigen::VectorXd means = ask(model, u, 0).colwise().mean().transpose();
      effects[i].u.push_back(place);
      effects[i].effect.push_back(interval(means.mean(), {means.begin(), means.end()}));
    }
  }
  return effects;
}

}  // namespace parapet::surrogate
