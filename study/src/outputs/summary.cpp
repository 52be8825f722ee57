#include "parapet/records/hashes.hpp"
#include "parapet/study/study_run.hpp"

namespace parapet::study {
namespace {

designs::Json optional_record(const std::optional<records::EvaluationRecord>& record) {
  return record ? records::to_json(*record) : designs::Json(nullptr);
}

}  // namespace

std::string to_string(StudyState state) {
  switch (state) {
    case StudyState::running:
      return "running";
    case StudyState::done:
      return "done";
    case StudyState::interrupted:
      return "interrupted";
    case StudyState::failed:
      return "failed";
  }
  return "unknown";
}

designs::Json to_json(const StudySummary& summary, const designs::StudySpec& study) {
  designs::Json json;
  json["format"] = "parapet-study-summary/1";
  json["name"] = study.name;
  json["spec_hash"] = records::study_hash(study);
  json["state"] = to_string(summary.state);
  json["termination"] = summary.termination;
  json["message"] = summary.message;
  json["evaluations"] = summary.evaluations;
  json["simulated_by_this_run"] = summary.simulated;
  json["cache_hits"] = summary.cache_hits;
  json["rejected"] = summary.rejected;
  json["best"] = optional_record(summary.best);
  json["starting_best"] = optional_record(summary.starting_best);
  json["pareto_size"] = summary.pareto.size();
  json["hypervolume"] = summary.hypervolume;
  if (summary.optimizer_time) json["optimizer_time_s"] = *summary.optimizer_time;
  json["elapsed_s"] = summary.elapsed;
  return json;
}

}  // namespace parapet::study
