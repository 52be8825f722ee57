#include "composed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parapet/math/normal.hpp"
#include "random.hpp"

namespace parapet::bayesian {
namespace {

/// Half the change of f from one standard deviation below the middle to one above, by input
/// [n_inputs]; `bend` adds up how far the middle is from halfway.
Eigen::VectorXd half_changes(const OfInputs& f, const Eigen::VectorXd& middle,
                             const Eigen::VectorXd& sd, double* bend) {
  const double at_middle = bend == nullptr ? 0.0 : f(middle);
  Eigen::VectorXd changes = Eigen::VectorXd::Zero(middle.size());
  Eigen::VectorXd z = middle;
  for (Eigen::Index i = 0; i < middle.size(); ++i) {
    if (!(sd[i] > 0.0)) continue;
    z[i] = middle[i] + sd[i];
    const double above = f(z);
    z[i] = middle[i] - sd[i];
    const double below = f(z);
    z[i] = middle[i];
    if (!std::isfinite(above) || !std::isfinite(below)) continue;
    changes[i] = 0.5 * std::abs(above - below);
    if (bend != nullptr && std::isfinite(at_middle)) {
      *bend += 0.5 * std::abs(above + below - 2.0 * at_middle);
    }
  }
  return changes;
}

}  // namespace

std::vector<std::size_t> modelled_inputs(const Problem& problem, std::size_t metric) {
  const Metric& spec = problem.metrics[metric];
  if (spec.exact) return {};
  return spec.is_composed() ? spec.composition.inputs : std::vector<std::size_t>{metric};
}

bool can_predict(const Problem& problem, const Models& models, std::size_t metric) {
  const auto inputs = modelled_inputs(problem, metric);
  return std::all_of(inputs.begin(), inputs.end(),
                     [&](std::size_t input) { return models.process(input) != nullptr; });
}

OfInputs of_inputs(const Problem& problem, const Models& models, std::size_t metric,
                   const Point& x) {
  return [&problem, &models, metric, &x,
          values = std::vector<double>()](const Eigen::VectorXd& z) mutable {
    const Composition& composition = problem.metrics[metric].composition;
    values.resize(composition.inputs.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Metric& input = problem.metrics[composition.inputs[i]];
      values[i] = std::clamp(
          models.process(composition.inputs[i])->from_model(z[static_cast<Eigen::Index>(i)]),
          input.least, input.greatest);
    }
    return composition.value(x, values);
  };
}

NormalSplit split(const OfInputs& f, const Eigen::VectorXd& mean, const Eigen::VectorXd& sd) {
  constexpr double most_sampled = 0.75;  // of the inputs' variance
  double bend = 0.0;
  const double slope = half_changes(f, mean, sd, &bend).sum();
  NormalSplit result;
  // A function without any change along the axes may still bend between them.
  const bool flat = !(slope + bend > 0.0) && sd.maxCoeff() > 0.0;
  const double sampled = flat ? most_sampled : std::min(most_sampled, bend / (slope + bend));
  if (slope + bend > 0.0 || flat) result.sampled = std::sqrt(sampled);
  const Eigen::VectorXd left = std::sqrt(1.0 - sampled) * sd;
  // The remainder is what is seen from one deviation above and below.
  if (slope + bend > 0.0) {
    result.deviation = half_changes(f, mean, left, nullptr).norm();
    if (bend > slope) {  // near the bottom of a valley the slope is that of its sides
      Eigen::VectorXd aside = mean + result.sampled * sd;
      result.deviation = std::max(result.deviation, half_changes(f, aside, left, nullptr).norm());
    }
  }
  return result;
}

ComposedEstimate estimate_composed(const OfInputs& f, const Eigen::VectorXd& mean,
                                   const Eigen::VectorXd& sd, double lower_limit,
                                   double upper_limit) {
  constexpr int draws = 1000;
  ComposedEstimate result;
  result.median = f(mean);
  std::vector<double> values;
  int within = 0;
  // Roberts' additive recurrence, which fills the cube evenly: powers of the root of
  // g^(n + 1) = g + 1.
  double g = 1.5;
  for (int k = 0; k < 60; ++k)
    g = std::pow(1.0 + g, 1.0 / (static_cast<double>(mean.size()) + 1.0));
  for (int k = 0; k < draws; ++k) {
    Eigen::VectorXd z = mean;
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      const double turn = std::pow(g, -static_cast<double>(i + 1));
      const double u = std::fmod(0.5 + k * turn, 1.0);
      z[i] += sd[i] * math::normal_quantile(std::clamp(u, 1e-6, 1.0 - 1e-6));
    }
    const double value = f(z);
    if (!std::isfinite(value)) continue;
    values.push_back(value);
    if (lower_limit <= value && value <= upper_limit) ++within;
  }
  result.share_within = static_cast<double>(within) / draws;
  if (values.empty() || !std::isfinite(result.median)) {
    result.median = result.lower = result.upper = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  };
  result.lower = std::min(result.median, at(0.025));
  result.upper = std::max(result.median, at(0.975));
  return result;
}

Eigen::VectorXd standard_normals(int n, std::uint64_t seed, std::uint64_t stream) {
  Random random(seed, stream);
  Eigen::VectorXd normals(n);
  for (double& one : normals) {
    one = math::normal_quantile(std::clamp(random.uniform(), 1e-12, 1.0 - 1e-12));
  }
  return normals;
}

}  // namespace parapet::bayesian
