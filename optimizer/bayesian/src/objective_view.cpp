#include "objective_view.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::bayesian {
namespace {

/// What a logarithm promises beyond this many ranges of the data is no longer a number to reckon
/// with.
constexpr double most_ranges = 10.0;

}  // namespace

double ObjectiveView::to_view(double value) const {
  return sign * (in_model_units ? process->to_model(value) : (value - shift) / scale);
}

double ObjectiveView::of_composed(double value) const {
  if (std::isnan(value)) return to_view(sign > 0.0 ? greatest : least);
  return to_view(std::clamp(value, least, greatest));
}

double ObjectiveView::from_model(double z) const {
  if (in_model_units) return sign * z;
  return to_view(std::clamp(process->from_model(z), least, greatest));
}

double ObjectiveView::deviation(double z, double deviation) const {
  if (in_model_units) return deviation;
  if (process->parameters().transform.kind == surrogate::TransformKind::identity) {
    return deviation * process->parameters().transform.scale / scale;
  }
  return std::max(0.0, from_model(z) - from_model(z - sign * deviation));
}

ObjectiveView view_of(const Problem& problem, const Models& models, const std::vector<Told>& told,
                      std::size_t j) {
  const Objective& objective = problem.objectives[j];
  ObjectiveView view;
  view.metric = objective.metric;
  view.sign = objective.maximize ? -1.0 : 1.0;
  view.process = models.process(objective.metric);
  view.in_model_units = view.process != nullptr && problem.objectives.size() == 1;
  std::vector<double> values;
  for (const Told& t : told) {
    if (t.values[objective.metric]) values.push_back(*t.values[objective.metric]);
  }
  if (values.empty()) return view;
  const auto transform = surrogate::OutputTransform::standardizing(
      surrogate::TransformKind::identity,
      Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  view.shift = transform.shift;
  view.scale = transform.scale;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double reach = most_ranges * std::max(*greatest - *least, transform.scale);
  view.least = *least - reach;
  view.greatest = *greatest + reach;
  return view;
}

}  // namespace parapet::bayesian
