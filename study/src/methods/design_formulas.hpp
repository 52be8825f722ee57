/// Formulas of the design variables, made ready for a search that evaluates them very often.
#pragma once

#include <optional>
#include <string>

#include "parapet/bayesian/space.hpp"
#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// formula_value() of a search's points. One thread at a time may use it.
class DesignFormula {
 public:
  /// @param expression of the study's variables; the spec was checked
  DesignFormula(const designs::StudySpec& study, const bayesian::Space& space,
                const std::string& expression);

  /// A variable that is not active counts as 0. Empty where the value is not finite.
  std::optional<double> value(const bayesian::Point& x);

 private:
  bayesian::Space space_;
  std::optional<designs::Formula> formula_;  // empty where it cannot be evaluated at all
};

}  // namespace parapet::study
