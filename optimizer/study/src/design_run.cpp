#include "parapet/study/design_run.hpp"

#include <stdexcept>

#include "parapet/reports/result_json.hpp"
#include "parapet/study/hashes.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/thread_count.hpp"

namespace parapet::study {
namespace {

using designs::Json;

/// Fills in a record whose design cannot be simulated.
void record_failure(const designs::StudySpec& study, DesignRun& run, const std::string& reason) {
  run.record.ok = false;
  run.record.reason = reason;
  run.record.constraints = score_expressions(study, run.record.design);
}

void record_result(const designs::StudySpec& study, DesignRun& run, const solver::Result& result) {
  reports::EvaluationRecord& record = run.record;
  record.metrics = result.metrics;
  record.wall_time = result.statistics.wall_time;
  if (result.status != solver::Status::ok) {
    record_failure(study, run, result.reason);
    return;
  }
  Score scored = score(study, record.design, result.metrics);
  record.ok = scored.problem.empty();
  record.reason = scored.problem;
  record.objectives = std::move(scored.objectives);
  record.objective_scalar = scored.objective_scalar;
  record.constraints = std::move(scored.constraints);
  record.feasible = scored.feasible;
}

Json simulation_json(const Json& result) {
  Json json = Json::object();
  for (const char* key :
       {"status", "reason", "stop_reason", "stop_time_s", "mass", "statistics", "timing"}) {
    json[key] = result.at(key);
  }
  return json;
}

}  // namespace

DesignRun run_design(const designs::StudySpec& study, const designs::Design& design,
                     const reports::ProgramInfo& program, int threads,
                     const solver::Callbacks& callbacks) {
  DesignRun run;
  run.record.design = design;
  run.report["provenance"] = reports::provenance_json(program, study_hash(study));
  run.report["provenance"]["seed"] = study.method.seed;
  run.record.spacing = study.base_case.at("/numerics/spacing_m"_json_pointer).get<double>();
  try {
    designs::CaseSpec spec = designs::design_case(study, design);
    run.record.spacing = spec.numerics.spacing;
    run.report["provenance"]["numerics"] = spec.resolved.at("numerics");
    spec.run.threads = worthwhile_threads(spec, threads);
    const solver::Result result = solver::simulate(spec.scene, spec.numerics, spec.run, callbacks);
    run.cancelled = result.status == solver::Status::cancelled;
    record_result(study, run, result);
    run.report["simulation"] = simulation_json(
        reports::result_json(study.name, result, nullptr, nullptr, spec.run.threads));
    run.report["case"] = spec.resolved;
    run.report["series"] = reports::series_json(result.series);
  } catch (const designs::InputError& error) {
    record_failure(study, run, std::string("the scene is impossible: ") + error.what());
  } catch (const std::invalid_argument& error) {
    record_failure(study, run, std::string("the scene is impossible: ") + error.what());
  }
  return run;
}

Json evaluation_report(const reports::EvaluationRecord& record, const Json& report) {
  Json json;
  json["format"] = "parapet-evaluation/1";
  json.update(reports::to_json(record));
  json.update(report);
  return json;
}

}  // namespace parapet::study
