#include "parapet/study/repeat.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/math/student.hpp"

namespace parapet::study {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Sum of squares about the mean; 0 of values that differ by rounding alone.
double squares_of(const std::vector<double>& values) {
  constexpr double rounding = 1e-12;
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) {
    const double apart = std::abs(value - mean);
    if (apart > rounding * std::abs(mean)) sum += apart * apart;
  }
  return sum;
}

/// The runs of the design at its spacing, the study's own first.
std::vector<double> all_runs(const RepeatEvidence& evidence) {
  std::vector<double> runs = evidence.again;
  if (evidence.own) runs.insert(runs.begin(), *evidence.own);
  return runs;
}

/// Mean and scatter by the surrogate and the runs made since.
void pool(const SurrogateBelief& belief, const RepeatEvidence& evidence, RepeatEstimate& estimate,
          double& freedom) {
  const std::vector<double> runs = all_runs(evidence);
  double squares = belief.noise_freedom * belief.noise * belief.noise;
  freedom = belief.noise_freedom;
  if (runs.size() > 1) {
    squares += squares_of(runs);
    freedom += static_cast<double>(runs.size() - 1);
  }
  const double variance = squares / freedom;
  estimate.scatter = std::sqrt(variance);
  estimate.mean = belief.mean;
  // A surrogate that took scatter for shape knows its values worse than it says.
  const double doubt = belief.noise > 0.0 ? std::max(1.0, *estimate.scatter / belief.noise) : 1.0;
  estimate.mean_uncertainty = doubt * belief.deviation;
  const double prior = estimate.mean_uncertainty * estimate.mean_uncertainty;
  if (evidence.again.empty() || !(prior > 0.0)) return;
  const double of_runs = variance / static_cast<double>(evidence.again.size());
  const double share = prior / (prior + of_runs);
  estimate.mean += share * (mean_of(evidence.again) - belief.mean);
  estimate.mean_uncertainty = std::sqrt((1.0 - share) * prior);
}

void add_grid(const RepeatEvidence& evidence, RepeatEstimate& estimate) {
  if (evidence.finer) {
    estimate.grid = std::abs(*evidence.finer - estimate.mean);
    estimate.grid_source = GridSource::other_run;
  } else if (evidence.surrogate && evidence.surrogate->grid) {
    estimate.grid = evidence.surrogate->grid;
    estimate.grid_source = GridSource::levels;
  }
}

double square(double value) {
  return value * value;
}

}  // namespace

std::optional<double> RepeatEstimate::standard_uncertainty() const {
  if (!scatter) return std::nullopt;
  return std::sqrt(square(*scatter) + square(mean_uncertainty) + square(grid.value_or(0.0)));
}

std::optional<double> RepeatEstimate::lower_95() const {
  const auto deviation = standard_uncertainty();
  if (!deviation) return std::nullopt;
  return std::clamp(mean + math::student_quantile(0.025, freedom) * *deviation, least, greatest);
}

std::optional<double> RepeatEstimate::upper_95() const {
  const auto deviation = standard_uncertainty();
  if (!deviation) return std::nullopt;
  return std::clamp(mean + math::student_quantile(0.975, freedom) * *deviation, least, greatest);
}

std::optional<double> RepeatEstimate::probability_within(const std::optional<double>& lower,
                                                         const std::optional<double>& upper) const {
  const auto deviation = standard_uncertainty();
  if (!deviation) return std::nullopt;
  // Of values that cannot be, all are at the nearest possible one.
  const auto up_to = [&](double value) {
    if (value >= greatest) return 1.0;
    if (value < least) return 0.0;
    if (!(*deviation > 0.0)) return value >= mean ? 1.0 : 0.0;
    return math::student_cdf((value - mean) / *deviation, freedom);
  };
  const auto below = [&](double value) {
    if (value <= least) return 0.0;
    if (value > greatest) return 1.0;
    if (!(*deviation > 0.0)) return value > mean ? 1.0 : 0.0;
    return math::student_cdf((value - mean) / *deviation, freedom);
  };
  return std::max(0.0, (upper ? up_to(*upper) : 1.0) - (lower ? below(*lower) : 0.0));
}

std::optional<RepeatEstimate> repeat_estimate(const RepeatEvidence& evidence) {
  const std::vector<double> runs = all_runs(evidence);
  RepeatEstimate estimate;
  estimate.runs = static_cast<int>(runs.size());
  estimate.least = evidence.least;
  estimate.greatest = evidence.greatest;
  double freedom = std::numeric_limits<double>::infinity();
  if (evidence.surrogate) {
    pool(*evidence.surrogate, evidence, estimate, freedom);
  } else if (runs.size() > 1) {
    const auto n = static_cast<double>(runs.size());
    freedom = n - 1.0;
    estimate.mean = mean_of(runs);
    estimate.scatter = std::sqrt(squares_of(runs) / freedom);
    estimate.mean_uncertainty = *estimate.scatter / std::sqrt(n);
  } else if (runs.size() == 1) {
    estimate.mean = runs.front();
  } else {
    return std::nullopt;
  }
  estimate.mean = std::clamp(estimate.mean, estimate.least, estimate.greatest);
  add_grid(evidence, estimate);
  if (!estimate.scatter) return estimate;
  const double of_runs = square(*estimate.scatter) + square(estimate.mean_uncertainty);
  const double all = of_runs + square(estimate.grid.value_or(0.0));
  estimate.freedom =
      of_runs > 0.0 ? freedom * square(all / of_runs) : std::numeric_limits<double>::infinity();
  return estimate;
}

RepeatEstimate exact_estimate(double value) {
  RepeatEstimate estimate;
  estimate.mean = value;
  estimate.scatter = 0.0;
  estimate.grid = 0.0;
  return estimate;
}

std::optional<RepeatEstimate> prediction(const RepeatEvidence& evidence) {
  if (!evidence.surrogate) return std::nullopt;
  RepeatEvidence before = evidence;
  before.own.reset();
  before.again.clear();
  before.finer.reset();
  return repeat_estimate(before);
}

}  // namespace parapet::study
