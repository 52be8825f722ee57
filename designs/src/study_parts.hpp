/// The parts of a study, each read and checked on its own. All expect JSON that the schema has
/// passed, with defaults written out, and add what they find.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "distributions.hpp"
#include "findings.hpp"
#include "parapet/designs/study_spec.hpp"
#include "study_metrics.hpp"
#include "study_targets.hpp"

namespace parapet::designs {

/// The variables, and the base case under every combination of their options: the base case alone
/// when there are no choices, none when the choices are wrong.
struct VariableReading {
  std::vector<Variable> variables;
  std::vector<Combination> combinations;
};
VariableReading read_variables(const Json& json, const Json& resolved_case, Findings& findings);

/// The terms, written out, in the order of their names; those that are wrong are left out.
std::vector<Term> read_terms(const Json& json, const Metrics& metrics,
                             const std::vector<Variable>& variables, Findings& findings);

std::vector<Objective> read_objectives(const Json& json, const Metrics& metrics,
                                       const std::vector<Variable>& variables,
                                       const std::vector<Term>& terms, Findings& findings);

std::vector<Constraint> read_constraints(const Json& json, const Metrics& metrics,
                                         const std::vector<Variable>& variables,
                                         const std::vector<Term>& terms, Findings& findings);

/// A list of events, or one drawn from distributions, with what differs between the drawn ones.
struct ScenarioReading {
  std::vector<Scenario> scenarios;
  std::vector<EventVariable> variables;
};

/// Adds what is wrong with quantiles over so few events that these do not bound them. Distributions
/// are no issue to a search with surrogates, which states the quantile over many more events.
void check_quantiles(const StudySpec& study, Findings& findings);

/// Precondition: at least one combination.
ScenarioReading read_scenarios(const Json& json, const std::vector<Variable>& variables,
                               const std::vector<Combination>& combinations, Findings& findings);

/// Nothing, with findings, when it is not sound.
std::optional<Distribution> read_distribution(const Json& json, const std::string& pointer,
                                              Findings& findings);

/// The levels, finest first; one with the case's own spacing when none is given.
std::vector<FidelityLevel> read_fidelity(const Json& json, const Json& resolved_case,
                                         const Metrics& metrics, Findings& findings);

/// Starting designs are checked against the variables, unless there are none. Algorithm names are
/// left to the optimiser.
Method read_method(const Json& json, const std::vector<Variable>& variables, Findings& findings);

/// Values by variable's name, choices by option's name; everything that check_design finds, too.
Design read_design_values(const std::vector<Variable>& variables, const Json& json,
                          const std::string& pointer, Findings& findings);

/// The study with every default written out. `scenarios` is what its key held: distributions stay
/// beside the list drawn from them.
Json resolve_study(const StudySpec& study, const Json& scenarios);

/// One thing wrong with an expression; empty problem when it is sound.
struct ExpressionProblem {
  std::string problem;
  std::string allowed;
};
/// @param known what the message calls the names; default: lists them all
ExpressionProblem expression_problem(const std::string& expression,
                                     const std::vector<std::string>& names, std::string known = "");

/// The names in an expression, each once, in the order in which they come first.
std::vector<std::string> names_in(const std::string& expression);

/// The expression with each name replaced by what is given for it, in brackets.
std::string with_names_replaced(const std::string& expression,
                                const std::map<std::string, std::string>& replacements);

}  // namespace parapet::designs
