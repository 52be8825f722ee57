#include "parapet/study/bayesian_space.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace parapet::study {

bayesian::Space make_space(const designs::StudySpec& study) {
  std::vector<bayesian::Variable> variables;
  for (const designs::Variable& variable : study.variables) {
    bayesian::Variable one;
    one.name = variable.name;
    one.lower = variable.lower;
    one.upper = variable.upper;
    switch (variable.kind) {
      case designs::VariableKind::continuous:
        one.kind = bayesian::VariableKind::continuous;
        break;
      case designs::VariableKind::integer:
        one.kind = bayesian::VariableKind::integer;
        break;
      case designs::VariableKind::choice:
        one.kind = bayesian::VariableKind::choice;
        break;
    }
    if (variable.active_when) {
      bayesian::Condition condition;
      while (condition.choice < study.variables.size() &&
             study.variables[condition.choice].name != variable.active_when->choice) {
        ++condition.choice;
      }
      condition.options = variable.active_when->options;
      one.active_when = std::move(condition);
    }
    variables.push_back(std::move(one));
  }
  return bayesian::Space(std::move(variables));
}

bayesian::Point to_point(const designs::StudySpec& study, const designs::Design& design) {
  bayesian::Point point;
  for (const designs::Variable& variable : study.variables) {
    const auto found = design.find(variable.name);
    point.push_back(found == design.end() ? std::numeric_limits<double>::quiet_NaN()
                                          : found->second);
  }
  return point;
}

designs::Design to_design(const designs::StudySpec& study, const bayesian::Space& space,
                          const bayesian::Point& point) {
  const bayesian::Point canonical = space.canonical(point);
  designs::Design design;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    if (std::isnan(canonical[i])) continue;
    design[study.variables[i].name] = canonical[i] + 0.0;  // -0 and 0 are one design
  }
  return design;
}

}  // namespace parapet::study
