#include "parapet/study/spec_files.hpp"

#include <filesystem>
#include <utility>

#include "parapet/study/expected_cost.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using designs::Json;

std::string shipped_names() {
  std::string names;
  for (const std::string& name : designs::embedded_spec_names()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

void require_format(const SpecDocument& document, const std::string& wanted,
                    const std::string& verb_for_it) {
  const std::string stated = designs::document_format(document.json, document.file);
  if (stated == wanted) return;
  throw InputError({{.file = document.file,
                     .pointer = "/format",
                     .value = '"' + stated + '"',
                     .problem = "this verb takes another kind of file",
                     .allowed = '"' + wanted + '"' + verb_for_it}});
}

double metres(double millimetres) {
  return millimetres / 1000.0;
}

}  // namespace

SpecDocument read_spec(const std::string& argument) {
  const std::filesystem::path path = argument;
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return {designs::read_json(path), argument};
  const std::string name = path.stem().string();
  if (const char* text = designs::embedded_spec(name)) {
    const std::string shown = name + ".json (shipped)";
    return {designs::parse_json(text, shown), shown};
  }
  throw InputError({{.file = argument,
                     .pointer = "",
                     .value = "",
                     .problem = "there is no such file",
                     .allowed = "a JSON file, or the name of a shipped spec: " + shipped_names()}});
}

void require_affordable(const designs::CaseSpec& spec, const std::string& file) {
  auto issues = cost_issues(case_cost(spec), machine_memory(), file, "");
  if (!issues.empty()) throw InputError(std::move(issues));
}

void require_affordable(const designs::StudySpec& study, const std::string& file) {
  for (const CaseCost& level : study_cost(study).levels) {
    auto issues = cost_issues(level, machine_memory(), file, "/case");
    if (issues.empty()) continue;
    const bool by_spacing = issues.front().pointer == "/case/numerics/spacing_m";
    if (by_spacing && study.fidelity.size() > 1) issues.front().pointer = "/fidelity/spacings_m";
    if (by_spacing) issues.front().value = Json(level.spacing).dump();
    throw InputError(std::move(issues));
  }
}

void require_affordable(const designs::SweepSpec& sweep, const std::string& file) {
  for (const designs::SweepRow& row : sweep.rows) {
    require_affordable(row.spec, file + ", row " + row.id);
  }
}

designs::CaseSpec read_case(const std::string& argument, std::optional<double> spacing_mm) {
  return case_of(read_spec(argument), spacing_mm);
}

designs::CaseSpec case_of(const SpecDocument& document, std::optional<double> spacing_mm) {
  require_format(document, "parapet-case/1", "; a study goes to parapet optimize");
  designs::CaseSpec spec = designs::parse_case(document.json, document.file);
  std::string source = document.file;
  if (spacing_mm) {
    Json json = spec.resolved;
    json["numerics"]["spacing_m"] = metres(*spacing_mm);
    source += " with --spacing-mm";
    spec = designs::parse_case(json, source);
  }
  require_affordable(spec, source);
  return spec;
}

designs::StudySpec read_study(const std::string& argument, std::optional<double> spacing_mm) {
  return study_of(read_spec(argument), spacing_mm);
}

designs::StudySpec study_of(const SpecDocument& document, std::optional<double> spacing_mm) {
  require_format(document, "parapet-study/1", "; a case goes to parapet simulate");
  designs::StudySpec study = designs::parse_study(document.json, document.file);
  if (!spacing_mm) {
    require_affordable(study, document.file);
    return study;
  }
  Json json = study.resolved;
  json["case"]["numerics"]["spacing_m"] = metres(*spacing_mm);
  json["fidelity"] = Json::object();  // one level, of which nothing is known
  json["fidelity"]["spacings_m"] = Json::array({metres(*spacing_mm)});
  designs::StudySpec other = designs::parse_study(json, document.file + " with --spacing-mm");
  require_affordable(other, other.source_file);
  return other;
}

designs::SweepSpec read_sweep(const std::string& argument, std::optional<double> spacing_mm) {
  const SpecDocument document = read_spec(argument);
  require_format(document, "parapet-sweep/1", "");
  designs::SweepSpec sweep = designs::parse_sweep(document.json, document.file);
  if (!spacing_mm) {
    require_affordable(sweep, document.file);
    return sweep;
  }
  for (designs::SweepRow& row : sweep.rows) {
    Json json = row.spec.resolved;
    json["numerics"]["spacing_m"] = metres(*spacing_mm);
    row.spec = designs::parse_case(json, document.file + " with --spacing-mm, row " + row.id);
  }
  sweep.resolved["case"]["numerics"]["spacing_m"] = metres(*spacing_mm);
  require_affordable(sweep, document.file + " with --spacing-mm");
  return sweep;
}

}  // namespace parapet::study
