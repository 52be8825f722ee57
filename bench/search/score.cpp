#include "score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "median.hpp"
#include "parapet/math/pareto.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::vector<Eigen::VectorXd> non_dominated_of(const std::vector<Eigen::VectorXd>& points) {
  std::vector<Eigen::VectorXd> front;
  for (const std::size_t i : math::non_dominated(points)) front.push_back(points[i]);
  return front;
}

// Index of the first step with that share; the number of steps if there is none.
std::size_t steps_to(const Curve& curve, double share) {
  const auto found = std::find_if(curve.share.begin(), curve.share.end(),
                                  [share](double s) { return s >= share; });
  return static_cast<std::size_t>(found - curve.share.begin());
}

// Median of values of which some may be infinite: their mean would be, where one is.
double median_or_never(const std::vector<double>& values) {
  return values.empty() ? never : median(values);
}

}  // namespace

Yardstick make_yardstick(const BenchProblem& problem, std::vector<Eigen::VectorXd> front) {
  ScrambledSobol points(static_cast<int>(problem.dimension()), 12345);
  std::vector<std::vector<double>> values(problem.objectives.size());
  for (int k = 0; k < 4096; ++k) {
    const Design x = problem.from_unit(points.next());
    if (!problem.allows(x)) continue;
    const Verdict verdict = judge(problem, problem.truth(x));
    if (!verdict.feasible) continue;
    for (std::size_t j = 0; j < values.size(); ++j) {
      values[j].push_back(verdict.objectives[static_cast<Eigen::Index>(j)]);
    }
  }
  if (values.front().empty() || front.empty()) {
    throw std::invalid_argument(problem.name + ": none of 4096 designs is feasible");
  }
  Yardstick yardstick;
  yardstick.reference.resize(static_cast<Eigen::Index>(values.size()));
  for (std::size_t j = 0; j < values.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    double best = never, worst = -never;
    for (const Eigen::VectorXd& y : front) {
      best = std::min(best, y[column]);
      worst = std::max(worst, y[column]);
    }
    yardstick.reference[column] = std::max(median(values[j]), worst + 0.1 * (worst - best));
  }
  yardstick.front = std::move(front);
  yardstick.volume = math::hypervolume(yardstick.front, yardstick.reference);
  if (!(yardstick.volume > 0.0)) {
    throw std::invalid_argument(problem.name + ": no design is better than the median one in " +
                                "every objective");
  }
  return yardstick;
}

void extend(Yardstick& yardstick, const BenchProblem& problem, const std::vector<MethodRuns>& all) {
  std::vector<Eigen::VectorXd> points = yardstick.front;
  for (const MethodRuns& method : all) {
    for (const Run& run : method.runs) {
      for (const Step& step : run.steps) {
        if (step.level != 0) continue;
        const Verdict verdict = judge(problem, problem.truth(step.x));
        if (verdict.feasible) points.push_back(verdict.objectives);
      }
      points = non_dominated_of(points);
    }
  }
  yardstick.front = points;
  yardstick.volume = math::hypervolume(points, yardstick.reference);
}

Curve score(const BenchProblem& problem, const Yardstick& yardstick, const Run& run) {
  Curve curve;
  std::vector<Eigen::VectorXd> front;
  double share = 0.0, seconds = 0.0;
  for (const Step& step : run.steps) {
    seconds += step.seconds;
    if (step.level == 0) {
      const Verdict verdict = judge(problem, problem.truth(step.x));
      if (verdict.feasible) {
        front.push_back(verdict.objectives);
        front = non_dominated_of(front);
        share = math::hypervolume(front, yardstick.reference) / yardstick.volume;
      }
    }
    curve.share.push_back(share);
    curve.seconds.push_back(seconds);
  }
  return curve;
}

double quantile(std::vector<double> values, double p) {
  if (values.empty()) throw std::invalid_argument("a quantile of nothing");
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  const double weight = place - static_cast<double>(low);
  return values[low] + (weight > 0.0 ? weight * (values[high] - values[low]) : 0.0);
}

MethodScore score(const BenchProblem& problem, const Yardstick& yardstick, const MethodRuns& runs) {
  MethodScore result;
  result.method = runs.method;
  result.label = runs.label;
  result.family = runs.family;
  std::vector<double> own;
  std::size_t longest = 0;
  for (const Run& run : runs.runs) {
    result.curves.push_back(score(problem, yardstick, run));
    longest = std::max(longest, run.steps.size());
    own.push_back(run.own_seconds);
  }
  result.budget = static_cast<int>(longest);
  if (!own.empty()) result.own_seconds = median(own);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    std::vector<double> evaluations, seconds;
    for (const Curve& curve : result.curves) {
      const std::size_t steps = steps_to(curve, targets[t]);
      const bool reached = steps < curve.share.size();
      result.reached[t] += reached ? 1 : 0;
      evaluations.push_back(reached ? static_cast<double>(steps + 1) : never);
      seconds.push_back(reached ? curve.seconds[steps] : never);
    }
    result.evaluations[t] = median_or_never(evaluations);
    result.worst_evaluations[t] =
        evaluations.empty() ? never : *std::max_element(evaluations.begin(), evaluations.end());
    result.seconds[t] = median_or_never(seconds);
  }
  result.worst_share = result.curves.empty() ? 0.0 : 1.0;
  for (const Curve& curve : result.curves) {
    result.worst_share =
        std::min(result.worst_share, curve.share.empty() ? 0.0 : curve.share.back());
  }
  for (std::size_t k = 0; k < longest; ++k) {
    std::vector<double> shares;
    for (const Curve& curve : result.curves) {
      // a run that ended keeps what it has
      if (!curve.share.empty()) shares.push_back(curve.share[std::min(k, curve.share.size() - 1)]);
    }
    result.median_share.push_back(quantile(shares, 0.5));
    result.lower_share.push_back(quantile(shares, 0.25));
    result.upper_share.push_back(quantile(shares, 0.75));
  }
  return result;
}

bool better(const MethodScore& a, const MethodScore& b) {
  for (const std::size_t t : {std::size_t{1}, std::size_t{0}}) {
    if (a.evaluations[t] != b.evaluations[t]) return a.evaluations[t] < b.evaluations[t];
  }
  if (a.median_share.empty() || b.median_share.empty()) return !a.median_share.empty();
  const std::size_t end = std::min(a.median_share.size(), b.median_share.size()) - 1;
  return a.median_share[end] > b.median_share[end];
}

}  // namespace parapet::bench::search
