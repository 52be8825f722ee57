#include "approach_run.hpp"

#include "interrupt.hpp"
#include "parapet/records/approach_json.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/study/thread_count.hpp"
#include "run_monitor.hpp"

namespace parapet::cli {

void require_barrier(const designs::CaseSpec& spec, const std::string& file) {
  if (!spec.scene.barriers.empty()) return;
  throw designs::InputError({{file, "/barriers", "[]", "there is no barrier to approach",
                              "a case with at least one barrier"}});
}

solver::UndisturbedRun run_undisturbed(const Session& session, const designs::CaseSpec& spec,
                                       int jobs) {
  RunMonitor monitor(session, 1, "");
  solver::RunOptions options = spec.run;
  options.threads = study::worthwhile_threads(spec, jobs);
  return solver::simulate_undisturbed(solver::undisturbed(spec.scene), spec.numerics, options,
                                      [&](const solver::Progress& progress) {
                                        monitor.running(spec.name + " without barriers", progress);
                                        return !interrupted();
                                      });
}

designs::Json write_approach(const Session& session, const designs::CaseSpec& spec,
                             const solver::UndisturbedRun& open,
                             const solver::Result* with_barriers,
                             const std::filesystem::path& folder) {
  const designs::Json provenance =
      records::provenance_json(session.program, records::case_hash(spec), spec);
  designs::Json json = records::approach_file_json(spec, open, with_barriers, provenance);
  records::write_file_atomically(folder / "approach.json", records::json_text(json));
  return json;
}

}  // namespace parapet::cli
