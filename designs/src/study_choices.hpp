/// Choices: what their options do to a case, and which variables exist under them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "findings.hpp"
#include "parapet/designs/study_spec.hpp"
#include "study_targets.hpp"

namespace parapet::designs {

/// What keeps an option from being applied.
struct OptionProblem {
  std::string member;  ///< JSON pointer into the option: /remove/0, ...
  std::string problem, allowed;
};

/// Changes the case as the option says: removals first, then the values. Of two keys that exclude
/// each other (foot_x_m and spacing_m, stem_lean_deg and stem_inclination), the one set stays.
std::optional<OptionProblem> apply_option(const Option& option, Json& json);

/// Whether a variable exists: it has no condition, or the choice it names exists and has taken one
/// of the options.
bool is_active(const std::vector<Variable>& variables, const Variable& variable,
               const Design& design);

/// The case with the options of a design applied, in the order of the variables, and defaults
/// written out as far as the case is sound. Choices that are missing in the design change nothing.
/// @throws InputError when an option cannot be applied.
Json structured_case(const StudySpec& study, const Design& design);

/// Every combination of options, with the choices that are active in it. What is wrong with an
/// option goes to the findings; combinations that are no case are left out.
std::vector<Combination> combinations(const std::vector<Variable>& variables,
                                      const Json& resolved_case, Findings& findings);

/// Every place that a variable or an option changes under some combination, and what does it:
/// "the variable plate_m", "the option big of deflector".
std::map<std::string, std::string> varied_places(const std::vector<Variable>& variables,
                                                 const std::vector<Combination>& combinations);

}  // namespace parapet::designs
