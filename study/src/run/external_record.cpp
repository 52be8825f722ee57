#include "parapet/study/external_record.hpp"

#include "parapet/records/provenance.hpp"

namespace parapet::study {

records::EvaluationRecord external_record(const DesignRun& run,
                                          const records::ProgramInfo& program) {
  records::EvaluationRecord record = run.record();
  record.id = records::evaluation_id(1);
  record.stage = "external";
  records::set_program(record, program);
  return record;
}

records::EvaluationRecord log_external(records::StudyFolder& folder,
                                       const designs::StudySpec& study, const DesignRun& run,
                                       const records::ProgramInfo& program, bool with_report) {
  records::EvaluationRecord record = external_record(run, program);
  if (const auto* known = folder.log().find(record.design, record.spacing)) return *known;
  int number = static_cast<int>(folder.log().records().size()) + 1;
  while (!folder.id_is_free(records::evaluation_id(number), record.design, record.spacing)) {
    ++number;
  }
  record.id = records::evaluation_id(number);
  if (!with_report) {
    folder.store(record, nullptr);
    return record;
  }
  const designs::Json provenance = records::study_provenance(study, program);
  for (std::size_t event = 0; event < run.size(); ++event) {
    const designs::Scenario* scenario = run.scenario(event);
    if (scenario == nullptr) continue;
    folder.store_simulation(record.id, run.design(), run.spacing(), *scenario,
                            run.simulation(event).value(), provenance);
  }
  folder.store(record, run.report(program));
  return record;
}

}  // namespace parapet::study
