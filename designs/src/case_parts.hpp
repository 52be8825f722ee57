/// The steps from a case's JSON to a scene, for cases of their own and inside studies and sweeps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings.hpp"
#include "parapet/designs/case_spec.hpp"
#include "schema.hpp"

namespace parapet::designs {

/// The schema of a case inside another document: neither format nor name is required there.
SchemaNode inner_case_schema();

/// Adds the format, and the name where none is given. Precondition: the schema found nothing.
Json complete_inner_case(Json json, const std::string& name);

/// Throws when the document says that it is something else; then nothing more is worth saying.
/// @throws InputError
/// @throws InputError naming every text of a document that holds a control character.
void refuse_control_characters(const Json& json, const std::string& file);

void require_format(const Json& json, const std::string& file, const std::string& expected);

/// Either a case or every issue that was found.
struct CaseAttempt {
  std::optional<CaseSpec> spec;
  std::vector<InputIssue> issues;
};

/// Checks (schema, then meaning) and builds a case. Pointers are reported below `prefix`.
CaseAttempt try_case(SchemaNode schema, const Json& json, const std::string& file,
                     const std::string& prefix);

/// Writes the defaults out. Precondition: schema and keys are sound.
Json resolve_case(SchemaNode schema, const Json& json);

/// Multiplies the defaults that belong to the size of the event, where they were not given.
/// @param given the case as written  @param resolved the same with_defaults
void scale_defaults(SchemaNode schema, const Json& given, Json& resolved);

/// Scene, numerics and options of a resolved case.
solver::Scene read_scene(const Json& resolved);
solver::Numerics read_numerics(const Json& resolved, const solver::Scene& scene);
solver::RunOptions read_run(const Json& resolved);

/// Keys that exclude or need each other; looks at what was written, before defaults.
void check_barrier_keys(const Json& json, Findings& findings);

/// What makes the case impossible or meaningless although each number is in its own range.
void check_case_meaning(const CaseSpec& spec, Findings& findings);

/// The base case of a study or sweep, from its key `case` or from the file its `case_file` names.
/// Adds to the findings what is wrong with it.
std::optional<CaseSpec> base_case(const Json& json, const std::string& file, Findings& findings);

}  // namespace parapet::designs
