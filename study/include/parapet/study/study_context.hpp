/// What the parts of a running study share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/simulation_service.hpp"

namespace parapet::study {

/// All must outlive what uses it.
struct StudyContext {
  const designs::StudySpec& study;
  records::StudyFolder& folder;
  const records::ProgramInfo& program;
  SimulationService& service;
  const Hooks& hooks;

  /// Whether the user wants to stop.
  bool cancelled() const { return hooks.cancelled && hooks.cancelled(); }
};

/// Writes a design that the constraints on formulas refuse into the log, unless it stands there.
/// @throws records::FileError
void store_refused(const StudyContext& context, designs::Design design);

/// A design on its way into the log.
class DesignJob {
 public:
  /// A design that is to be simulated at a particle spacing [m]; `stage` as in
  /// records::EvaluationRecord.
  DesignJob(const StudyContext& context, std::string id, std::string stage, designs::Design design,
            double spacing);

  /// Number of events.
  std::size_t size() const { return run_.size(); }

  /// The id that the log will give it.
  const std::string& id() const { return id_; }

  /// The task of one event. Empty when nothing is to be simulated: an earlier run left the event's
  /// simulation, or the scene is impossible; the event has ended then.
  /// @param threads that the simulation may use
  std::optional<SimulationTask> begin(std::size_t event, int threads);

  /// One event has ended: its simulation is kept, and with scenarios it must go to disk by
  /// write_event(). A cancelled one leaves the event open.
  void end(std::size_t event, records::Simulation simulation);

  /// Writes an event that has ended, with scenarios; for several at once from several threads.
  /// @throws records::FileError
  void write_event(std::size_t event) const;

  /// An event that could not be written counts as open again.
  void lose(std::size_t event);

  /// Whether every event has ended.
  bool complete() const { return open_ == 0; }

  /// Keeps what has ended on disk until it is logged: nothing is lost in between. With scenarios it
  /// is there already. Of several designs at once from several threads.
  /// @throws records::FileError
  void wait_on_disk();

  /// Writes the report of a complete design, which must be there before the log has its record. Of
  /// several designs at once from several threads.
  /// @throws records::FileError
  void write_report();

  /// What the log is to say of a complete design.
  const records::EvaluationRecord& record();

  /// The log has the record: what waited on disk is not needed any more.
  void logged() const;

 private:
  std::string label(std::size_t event) const;
  void keep(std::size_t event, records::Simulation simulation);

  const StudyContext& context_;
  std::string id_;
  std::string stage_;
  DesignRun run_;
  std::size_t open_;  // events that have not ended
  bool waits_ = false;
  std::optional<records::EvaluationRecord> record_;  // once it is complete
};

}  // namespace parapet::study
