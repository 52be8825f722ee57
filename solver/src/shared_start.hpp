// What a run takes from the designs before it, and leaves to those after it.
#pragma once

#include <cstdint>
#include <optional>

#include "gauges/recorder.hpp"
#include "start_store.hpp"

namespace parapet::solver {

class SharedStart {
 public:
  // Without `starts` it does nothing.
  SharedStart(StartStates* starts, const Scene& scene, const Numerics& numerics,
              const RunOptions& options);

  // Puts flow and recorder to the latest known state before the last sample that their barriers
  // allow.
  // @return number of samples that are recorded then; 0 when there is no such state
  std::int64_t resume(Flow& flow, Recorder& recorder, std::int64_t samples);
  void stepped(const Flow& flow);                            // after every step
  void sampled(const Flow& flow, const Recorder& recorder);  // after every sample

 private:
  StartStates::Store* store_;  // nullptr: nothing more to give
  std::optional<SharedFlow> shared_;
  std::optional<GaugeSight> sight_;
  RecordedStart record_;
  RecordedStart::Reach reach_{0.0, 0.0};
};

}  // namespace parapet::solver
