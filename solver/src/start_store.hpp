// What StartStates keeps.
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "gauges/recorded_start.hpp"
#include "parapet/flow/flow_state.hpp"
#include "parapet/solver/simulation.hpp"
#include "parapet/solver/start_states.hpp"

namespace parapet::solver {

// Everything that decides how a flow begins, and what is recorded of it.
struct SharedFlow {
  SharedFlow(const Scene& scene, const Numerics& numerics, const RunOptions& options);
  bool operator==(const SharedFlow&) const = default;

  Scene channel;  // without barriers and gauges
  Numerics numerics;
  double series_interval, retention_change, kinetic_energy_share, front_mass_share;
};

// A flow at a sample, and how it came there.
struct Start {
  FlowState flow;
  RecordedStart record;
};

class StartStates::Store {
 public:
  explicit Store(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  // The latest start of which nothing has come into sight; nullptr when there is none.
  std::shared_ptr<const Start> latest(const SharedFlow& flow, const GaugeSight& sight,
                                      std::size_t most_samples);
  // Whether a start at this sample would be kept.
  bool wants(const SharedFlow& flow, std::size_t samples);
  void add(const SharedFlow& flow, std::shared_ptr<const Start> start);
  Use use() const;

 private:
  struct Known {
    SharedFlow flow;
    std::size_t every = 1;  // samples from one start to the next
    std::map<std::size_t, std::shared_ptr<const Start>> starts;  // by number of samples
    std::size_t bytes = 0;
  };
  std::list<Known>::iterator find(const SharedFlow& flow);
  static void drop(Known& known, std::size_t samples);
  static void thin_out(Known& known);
  void make_room(const Known& newest);

  mutable std::mutex mutex_;
  std::size_t most_bytes_;
  std::list<Known> flows_;  // the latest asked for first
  Use use_;
};

}  // namespace parapet::solver
