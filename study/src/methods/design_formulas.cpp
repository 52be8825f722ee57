#include "design_formulas.hpp"

#include <cmath>
#include <vector>

namespace parapet::study {
namespace {

std::vector<std::string> variable_names(const designs::StudySpec& study) {
  std::vector<std::string> names;
  for (const designs::Variable& variable : study.variables) names.push_back(variable.name);
  return names;
}

}  // namespace

DesignFormula::DesignFormula(const designs::StudySpec& study, const bayesian::Space& space,
                             const std::string& expression)
    : space_(space) {
  try {
    formula_.emplace(expression, variable_names(study));
  } catch (const designs::InputError&) {  // then no design has a value
  }
}

std::optional<double> DesignFormula::value(const bayesian::Point& x) {
  if (!formula_) return std::nullopt;
  std::vector<double> values = space_.canonical(x);
  for (double& one : values) one = std::isnan(one) ? 0.0 : one + 0.0;  // as in to_design()
  const double result = formula_->value(values);
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace parapet::study
