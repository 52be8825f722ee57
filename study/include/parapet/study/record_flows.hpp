/// Flows simulated once more to be looked at: recordings/NAME.flow beside the results.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/simulation_task.hpp"

namespace parapet::study {

/// One flow that is to be recorded.
struct FlowToRecord {
  std::string name;  ///< of the file, without its ending: a design's or a row's id
  SimulationTask task;
  std::vector<solver::Metric> metrics;  ///< that it gave before; empty: not known
};

/// The file of a recording in a folder of results.
std::filesystem::path recording_file(const std::filesystem::path& folder, const std::string& name);

/// The flow of an evaluated design at its own spacing. With several events it is the one in which
/// the first objective is worst; the first event where that is a formula.
/// @throws designs::InputError when the design's scene is impossible
FlowToRecord flow_of_design(const designs::StudySpec& study,
                            const records::EvaluationRecord& record);

/// The designs that a study's "recordings" asks for: the front (of one objective the best design
/// and the best start), or all that ended well at the finest spacing. Of a front of more than
/// most_recorded_designs, as many, evenly spread along the first objective, its ends among them.
std::vector<records::EvaluationRecord> designs_to_record(
    const designs::StudySpec& study, const std::vector<records::EvaluationRecord>& records);

constexpr std::size_t most_recorded_designs = 12;

/// What became of it.
struct RecordOutcome {
  int recorded = 0;  ///< simulated by this call
  int kept = 0;      ///< whose recording was there, of the same case
  bool cancelled = false;
  /// Names whose metrics are not the ones given: another program made those. They are recorded.
  std::vector<std::string> different;
  std::vector<std::string> failed;  ///< whose simulation failed; nothing is recorded
};

/// Simulates them, `jobs` side by side, and writes their recordings; recordings of other names are
/// removed when `only_these`. The folder must be locked by the caller.
/// @throws records::FileError
RecordOutcome record_flows(const std::filesystem::path& folder, std::vector<FlowToRecord> flows,
                           int jobs, const Hooks& hooks, bool only_these = true);

}  // namespace parapet::study
