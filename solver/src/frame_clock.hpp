/// Frames of a run at exactly the times that were asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "parapet/flow/flow.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::solver {

/// Watches a flow between its steps and offers a frame for each time asked for. A time between two
/// steps gets what lies between their states, by linear interpolation: an error of the order of
/// the square of a time step. Looking changes no bit of the run.
class FrameClock {
 public:
  /// Nothing is offered without callbacks.on_frame, or where no frames are asked for. The
  /// arguments must outlive the clock.
  FrameClock(const RunOptions& options, const Callbacks& callbacks);

  /// The flow is at its start.
  void begin(Flow& flow);

  /// The flow is about to step, to `reached` [s] at the farthest.
  void before_step(Flow& flow, double reached);

  /// It has.
  void after_step(Flow& flow);

  /// The run has ended well: its last state is offered.
  void end(Flow& flow);

 private:
  /// Particles as copies, in the order of the flow.
  struct State {
    double time = 0.0;
    std::vector<double> x, z, u, w, density, pressure, viscosity;
    std::vector<std::int32_t> id;
  };

  double regular_time() const;
  double next_time() const;
  void advance();
  void show(Flow& flow, double time, bool last);
  void show_between(Flow& flow, double time);
  void keep(Flow& flow);

  const RunOptions& options_;
  const Callbacks& callbacks_;
  bool wanted_;
  std::int64_t regular_ = 0;  // frames of the interval that were offered
  std::size_t chosen_ = 0;    // of the further times
  double last_shown_ = -1.0;  // [s]
  bool kept_ = false;         // whether before_ is the state before the step
  State before_, between_;
  std::vector<std::int32_t> place_;  // of an id in before_; -1: not there
};

}  // namespace parapet::solver
