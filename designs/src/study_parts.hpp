/// The parts of a study, each read and checked on its own. All expect JSON that the schema has
/// passed, with defaults written out, and add what they find.
#pragma once

#include <string>
#include <vector>

#include "findings.hpp"
#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

/// The numbers of a case's scene that a variable may take the place of, as JSON pointers.
std::vector<std::string> numeric_inputs(const Json& resolved_case);

std::vector<Variable> read_variables(const Json& json, const Json& resolved_case,
                                     Findings& findings);

std::vector<Objective> read_objectives(const Json& json, int n_barriers, Findings& findings);

std::vector<Constraint> read_constraints(const Json& json, int n_barriers,
                                         const std::vector<Variable>& variables,
                                         Findings& findings);

/// Starting designs are checked against the variables, unless there are none. Algorithm names are
/// left to the optimiser.
Method read_method(const Json& json, const std::vector<Variable>& variables, Findings& findings);

/// The study with every default written out.
Json resolve_study(const StudySpec& study);

/// One thing wrong with an expression; empty problem when it is sound.
struct ExpressionProblem {
  std::string problem;
  std::string allowed;
};
ExpressionProblem expression_problem(const std::string& expression,
                                     const std::vector<std::string>& names);

}  // namespace parapet::designs
