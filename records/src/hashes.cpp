#include "parapet/records/hashes.hpp"

namespace parapet::records {
namespace {

using designs::Json;

void leave_out_of_case(Json& json) {
  json.erase("name");
  json.erase("description");
  if (json.contains("run")) json["run"].erase("frame_interval_s");
}

}  // namespace

std::string case_hash(const designs::CaseSpec& spec) {
  return case_hash(spec.resolved);
}

std::string case_hash(Json resolved) {
  leave_out_of_case(resolved);
  return designs::spec_hash(resolved);
}

std::string study_hash(const designs::StudySpec& study) {
  Json json = study.resolved;
  json.erase("name");
  json.erase("description");
  json.erase("recordings");
  if (json.contains("case")) leave_out_of_case(json["case"]);
  if (json.contains("method")) {
    // When a study ends does not change what it is: it may be continued.
    for (const char* limit : {"max_evaluations", "max_time_s", "max_cpu_time_s", "max_finest_runs",
                              "stagnation_evaluations", "least_gain"}) {
      json["method"].erase(limit);
    }
    if (designs::is_laid_out_for_budget(study)) {
      json["method"]["max_evaluations"] = study.method.max_evaluations;
    }
  }
  return designs::spec_hash(json);
}

}  // namespace parapet::records
