#include <set>
#include <utility>

#include "case_parts.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/metric_catalog.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

/// A row's issue is the row's where its changes hold the place, and else the base's.
void place_in_row(InputIssue& issue, const Json& changes, const std::string& row_pointer) {
  const Json::json_pointer place(issue.pointer);
  if (changes.contains(place)) {
    issue.pointer = row_pointer + "/changes" + issue.pointer;
  } else {
    issue.problem += " (at " + (issue.pointer.empty() ? "the case" : issue.pointer) +
                     ", with the row's changes)";
    issue.pointer = row_pointer + "/changes";
    issue.value = short_text(changes);
  }
}

void check_published(const SweepRow& row, const std::string& pointer, Findings& findings) {
  std::vector<std::string> keys;
  for (const auto& info :
       solver::metric_catalog(static_cast<int>(row.spec.scene.barriers.size()))) {
    keys.push_back(info.key);
  }
  for (const auto& [key, statement] : row.published.items()) {
    const std::string place = child_pointer(pointer + "/published", key);
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      findings.add(place, "is not a metric of this row" + did_you_mean(key, keys),
                   "one of " + joined(keys));
    }
    if (!statement.contains("value") && !statement.contains("lower") &&
        !statement.contains("upper")) {
      findings.add(place, "states no number", "a value, or a lower or upper limit");
    }
  }
}

SweepRow read_row(const Json& json, const std::string& pointer, const Json& base,
                  const std::string& file, Findings& findings) {
  SweepRow row;
  row.id = json.at("id").get<std::string>();
  row.description = json.at("description").get<std::string>();
  row.published = json.at("published");
  Json patched = base;
  patched.merge_patch(json.at("changes"));
  patched["name"] = row.id;
  patched["description"] = row.description;
  const Json complete = complete_inner_case(patched, row.id);
  CaseAttempt attempt = try_case(inner_case_schema(), complete, file, "");
  for (InputIssue& issue : attempt.issues) {
    place_in_row(issue, json.at("changes"), pointer);
    findings.append({issue});
  }
  if (attempt.spec) {
    row.spec = *std::move(attempt.spec);
    if (row.published.is_object()) check_published(row, pointer, findings);
  }
  return row;
}

Json resolve_sweep(const Json& complete, const Json& base, const std::vector<SweepRow>& rows) {
  Json resolved = complete;
  resolved.erase("$schema");
  resolved.erase("case_file");
  resolved.erase("rows");
  resolved["case"] = base;
  resolved["rows"] = complete.at("rows");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // The barriers with their defaults; everything else of a row is what it changes.
    Json& changes = resolved["rows"][k]["changes"];
    if (changes.contains("barriers")) changes["barriers"] = rows[k].spec.resolved.at("barriers");
  }
  return resolved;
}

}  // namespace

SweepSpec parse_sweep(const Json& json, const std::string& file) {
  require_format(json, file, "parapet-sweep/1");
  refuse_control_characters(json, file);
  const SchemaNode schema = schema_document("sweep.schema.json");
  std::vector<InputIssue> issues = schema_issues(schema, json, file);
  if (!issues.empty()) throw InputError(std::move(issues));

  const Json complete = with_defaults(schema, json);
  Findings findings(file, complete);
  const std::optional<CaseSpec> base = base_case(json, file, findings);
  if (!base) findings.throw_if_any();

  SweepSpec sweep;
  sweep.name = complete.at("name").get<std::string>();
  sweep.source = complete.at("source").get<std::string>();
  std::set<std::string> ids;
  const Json& rows = complete.at("rows");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string pointer = child_pointer("/rows", k);
    sweep.rows.push_back(read_row(rows[k], pointer, base->resolved, file, findings));
    if (!ids.insert(sweep.rows.back().id).second) {
      findings.add(pointer + "/id", "another row has this id", "an id of its own");
    }
  }
  findings.throw_if_any();
  sweep.resolved = resolve_sweep(complete, base->resolved, sweep.rows);
  return sweep;
}

SweepSpec load_sweep(const std::filesystem::path& file) {
  return parse_sweep(read_json(file), file.string());
}

}  // namespace parapet::designs
