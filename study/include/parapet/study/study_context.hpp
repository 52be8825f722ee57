/// What the parts of a running study share.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::study {

/// All must outlive what uses it.
struct StudyContext {
  const designs::StudySpec& study;
  records::StudyFolder& folder;
  const records::ProgramInfo& program;
  const Simulator& simulator;
  const Hooks& hooks;

  bool cancelled() const { return hooks.cancelled && hooks.cancelled(); }
};

/// A design on its way into the log.
class DesignJob {
 public:
  DesignJob(const StudyContext& context, std::string id, std::string stage, designs::Design design,
            double spacing);

  std::size_t size() const { return run_.size(); }
  const std::string& id() const { return id_; }

  enum class Outcome { cancelled, incomplete, complete };

  /// Simulates one event, or takes it from what an earlier run left, and keeps it on disk.
  /// Different events may be simulated at once; `complete` is returned once, by the last to end.
  /// @throws records::FileError
  Outcome simulate(std::size_t event, int threads);

  /// Writes the record of a complete design into the log. One thread at a time.
  /// @throws records::FileError
  records::EvaluationRecord store() const;

 private:
  std::string label(std::size_t event) const;

  const StudyContext& context_;
  std::string id_;
  std::string stage_;
  DesignRun run_;
  std::atomic<std::size_t> open_;  // events that have not ended well or badly
};

}  // namespace parapet::study
