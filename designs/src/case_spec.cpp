#include "parapet/designs/case_spec.hpp"

#include <utility>

#include "case_parts.hpp"
#include "parapet/designs/text.hpp"

namespace parapet::designs {
namespace {

/// The solver's own checks, for what the checks here do not know. Its sentences name the field.
void check_with_solver(const CaseSpec& spec, Findings& findings) {
  for (const auto& sentences :
       {solver::scene_errors(spec.scene), solver::numerics_errors(spec.numerics),
        solver::run_errors(spec.run), solver::gauge_errors(spec.run.gauges)}) {
    for (const std::string& sentence : sentences) findings.add("", sentence, "");
  }
}

}  // namespace

// Two of a barrier's defaults hold only while the key that replaces them
// is not given.
Json resolve_case(SchemaNode schema, const Json& json) {
  Json resolved = with_defaults(schema, json);
  resolved.erase("$schema");
  scale_defaults(schema, json, resolved);
  Json& barriers = resolved["barriers"];
  for (std::size_t k = 0; k < barriers.size(); ++k) {
    const Json& given = json.at("barriers")[k];
    if (k > 0 && !given.contains("foot_x_m")) barriers[k].erase("foot_x_m");
    if (given.contains("stem_lean_deg")) barriers[k].erase("stem_inclination");
  }
  return resolved;
}

SchemaNode inner_case_schema() {
  const SchemaNode document = schema_document("case.schema.json");
  return {document.document, &document->at("definitions").at("case")};
}

void require_format(const Json& json, const std::string& file, const std::string& expected) {
  if (!json.is_object() || !json.contains("format") || json.at("format") == expected) return;
  throw InputError({{file, "/format", short_text(json.at("format")),
                     "is not what this file should be", "\"" + expected + "\""}});
}

void refuse_control_characters(const Json& json, const std::string& file) {
  std::vector<InputIssue> issues = control_character_issues(json, file);
  if (!issues.empty()) throw InputError(std::move(issues));
}

CaseAttempt try_case(SchemaNode schema, const Json& json, const std::string& file,
                     const std::string& prefix) {
  CaseAttempt attempt;
  attempt.issues = schema_issues(schema, json, file, prefix);
  if (!attempt.issues.empty()) return attempt;
  Findings key_findings(file, json, prefix);
  check_barrier_keys(json, key_findings);
  attempt.issues = key_findings.issues();
  if (!attempt.issues.empty()) return attempt;

  CaseSpec spec;
  spec.resolved = resolve_case(schema, json);
  spec.name = spec.resolved.at("name").get<std::string>();
  spec.description = spec.resolved.at("description").get<std::string>();
  spec.scene = read_scene(spec.resolved);
  spec.numerics = read_numerics(spec.resolved, spec.scene);
  spec.run = read_run(spec.resolved);
  Findings findings(file, spec.resolved, prefix);
  check_case_meaning(spec, findings);
  if (findings.empty()) check_with_solver(spec, findings);
  attempt.issues = findings.issues();
  if (attempt.issues.empty()) attempt.spec = std::move(spec);
  return attempt;
}

Json complete_inner_case(Json json, const std::string& name) {
  json["format"] = "parapet-case/1";
  if (!json.contains("name")) json["name"] = name;
  return json;
}

CaseSpec parse_case(const Json& json, const std::string& file) {
  require_format(json, file, "parapet-case/1");
  refuse_control_characters(json, file);
  CaseAttempt attempt = try_case(schema_document("case.schema.json"), json, file, "");
  if (!attempt.spec) throw InputError(std::move(attempt.issues));
  return *std::move(attempt.spec);
}

CaseSpec load_case(const std::filesystem::path& file) {
  return parse_case(read_json(file), file.string());
}

std::optional<CaseSpec> base_case(const Json& json, const std::string& file, Findings& findings) {
  const bool is_inside = json.contains("case");
  if (is_inside == json.contains("case_file")) {
    findings.add(
        "/case",
        is_inside ? "stands beside case_file, and only one of them can hold" : "is missing",
        "either a case, or the key case_file with the name of a case file");
    return std::nullopt;
  }
  if (is_inside) {
    const Json inner = complete_inner_case(json.at("case"), json.at("name").get<std::string>());
    CaseAttempt attempt = try_case(inner_case_schema(), inner, file, "/case");
    findings.append(attempt.issues);
    return std::move(attempt.spec);
  }
  const std::filesystem::path named = json.at("case_file").get<std::string>();
  const std::filesystem::path path =
      named.is_absolute() ? named : std::filesystem::path(file).parent_path() / named;
  if (!std::filesystem::is_regular_file(path)) {
    findings.add("/case_file", "there is no file " + path.string(),
                 "the name of a case file, relative to this file");
    return std::nullopt;
  }
  try {
    return load_case(path);
  } catch (const InputError& error) {
    findings.append(error.issues());
    return std::nullopt;
  }
}

}  // namespace parapet::designs
