#include "parapet/study/slices.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/study/bayesian_problem.hpp"
#include "stored_surrogates.hpp"

namespace parapet::study {
namespace {

/// The values that a variable takes along its slice.
std::vector<double> values_along(const designs::Variable& variable, int places) {
  std::vector<double> values;
  if (variable.kind == designs::VariableKind::continuous) {
    for (int k = 0; k < places; ++k) {
      values.push_back(variable.lower + (variable.upper - variable.lower) * k / (places - 1));
    }
    return values;
  }
  const double step = std::max(1.0, std::ceil((variable.upper - variable.lower) / places));
  for (double value = variable.lower; value <= variable.upper; value += step) {
    values.push_back(value);
  }
  return values;
}

VariablePlace place_at(const designs::Variable& variable, double value) {
  if (variable.kind != designs::VariableKind::choice) return value;
  return variable.options[static_cast<std::size_t>(value)].name;
}

Slice slice_along(const designs::StudySpec& study, const bayesian::Space& space,
                  const surrogate::GaussianProcess& process, const bayesian::Metric& metric,
                  const designs::Variable& variable, const designs::Design& design, int places) {
  Slice slice{.variable = variable.name, .at = {}, .median = {}, .lower_95 = {}, .upper_95 = {}};
  std::vector<bayesian::Point> points;
  for (const double value : values_along(variable, places)) {
    designs::Design moved = design;
    moved[variable.name] = value;
    slice.at.push_back(place_at(variable, value));
    points.push_back(to_point(study, moved));
  }
  const surrogate::Prediction prediction = process.predict(space.features(points));
  constexpr double two_sided_95 = 1.959963984540054;
  const auto real = [&](double z) {
    return std::clamp(process.from_model(z), metric.least, metric.greatest);
  };
  for (Eigen::Index k = 0; k < prediction.mean.size(); ++k) {
    const double mean = prediction.mean[k];
    const double half = two_sided_95 * std::sqrt(std::max(0.0, prediction.variance[k]));
    const double a = real(mean - half), b = real(mean + half);
    slice.median.push_back(real(mean));
    slice.lower_95.push_back(std::min(a, b));
    slice.upper_95.push_back(std::max(a, b));
  }
  return slice;
}

}  // namespace

std::vector<MetricSlices> surrogate_slices(const designs::StudySpec& study,
                                           const designs::Json& surrogates,
                                           const designs::Design& design, int places) {
  const SearchProblem problem = make_search_problem(study);
  const bayesian::Space& space = problem.problem.space;
  std::vector<MetricSlices> all;
  const designs::Json& stored = surrogates.at("metrics");
  for (std::size_t k = 0; k < std::min(stored.size(), problem.metrics.size()); ++k) {
    const auto process = stored_process(surrogates, stored[k]);
    if (!process) continue;
    MetricSlices one{.metric = problem.metrics[k].quantity.metric,
                     .slices = {},
                     .name = stored[k].at("name").get<std::string>()};
    for (const designs::Variable& variable : study.variables) {
      // A choice decides which other variables there are: no slice goes across it.
      const bool decides = std::ranges::any_of(study.variables, [&](const auto& other) {
        return other.active_when && other.active_when->choice == variable.name;
      });
      if (decides || !design.contains(variable.name)) continue;
      one.slices.push_back(slice_along(study, space, *process, problem.problem.metrics[k], variable,
                                       design, places));
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace parapet::study
