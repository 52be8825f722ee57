/// What a study's spec, as study.json holds it, says of variables, objectives and constraints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/records/evaluation_log.hpp"
#include "study_log.hpp"

namespace parapet::reports {

/// A member of an object; null, empty or nothing when it is not there or of another type.
const designs::Json& member(const designs::Json& object, const char* key);
std::string text(const designs::Json& object, const char* key);
std::optional<double> number(const designs::Json& object, const char* key);

/// @throws designs::InputError for a study without variables, or one without bounds
std::vector<LoggedVariable> read_variables(const designs::Json& spec, const std::string& file);

/// A record's constraint or objective with what the spec says of it.
LoggedConstraint read_constraint(const records::ConstraintRecord& record,
                                 const designs::Json& spec);
LoggedObjective read_objective(const records::ObjectiveRecord& record, const designs::Json& spec);

}  // namespace parapet::reports
