#include "parapet/study/problem.hpp"

#include <cmath>

#include "parapet/study/scoring.hpp"

namespace parapet::study {

optimizer::Problem make_problem(const designs::StudySpec& study) {
  optimizer::Problem problem;
  for (const designs::Variable& variable : study.variables) {
    problem.names.push_back(variable.name);
    problem.lower.push_back(variable.lower);
    problem.upper.push_back(variable.upper);
  }
  problem.n_constraints = metric_limit_count(study);
  problem.n_cheap_constraints = expression_limit_count(study);
  problem.cheap_constraints = [&study](const std::vector<double>& x) {
    return expression_violations(study, to_design(study, x));
  };
  return problem;
}

designs::Design to_design(const designs::StudySpec& study, const std::vector<double>& x) {
  designs::Design design;
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const bool whole = study.variables[i].kind != designs::VariableKind::continuous;
    design[study.variables[i].name] = whole ? std::round(x[i]) + 0.0 : x[i];  // no -0
  }
  return design;
}

}  // namespace parapet::study
