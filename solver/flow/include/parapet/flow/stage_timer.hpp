/// Stopwatch of a flow: one clock that always runs for exactly one stage, so that the stages add up
/// to the whole. Entering a stage stops the one around it. For the calling thread only.
///
///     StageTimer timer;
///     setup.timer = &timer;  // before the flow is made; the timer must outlive it
///     ...
///     for (const StageTime& stage : timer.profile().stages) ...
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "parapet/flow/flow_arrays.hpp"
#include "parapet/flow/time_step.hpp"
#include "parapet/solver/profile.hpp"

namespace parapet::solver {

/// What the time goes into.
enum class Stage {
  neighbor_check,
  neighbor_rows,
  equation_of_state,
  wall_boundary,
  gradients,
  pressure_force,
  viscous_force,
  viscous_matrix,
  conjugate_gradients,
  density_rate,
  wall_load,
  integrate,
  wall_contact,
  step_control,
  gauges,
  output,
  profiling,
  other
};
/// How many there are.
constexpr std::size_t n_stages = static_cast<std::size_t>(Stage::other) + 1;

/// Directed pairs of a state, and the row slots that hold them.
struct PairCount {
  std::int64_t particles = 0;
  std::int64_t fluid = 0, wall = 0;  ///< within the kernel's reach
  std::int64_t slots = 0;            ///< with padding
};
/// Of the rows as they are.
PairCount count_pairs(const FlowArrays& arrays);

/// Adds up seconds, visits and pairs by stage.
class StageTimer {
 public:
  using Clock = std::function<double()>;  ///< [s]
  StageTimer();                           ///< on the steady clock
  explicit StageTimer(Clock clock);       ///< on a clock of the caller's, for tests

  /// From now on the time is `stage`'s; the stage that had it so far is returned, for leave().
  Stage enter(Stage stage);
  /// Gives the time back to the stage that enter() returned.
  void leave(Stage outer) { switch_to(outer); }

  /// Pairs that each visit of a neighbour sum sees from now on.
  void set_pairs(const PairCount& pairs);
  /// Visits beyond the one that entering a stage stands for.
  void add_visits(Stage stage, std::int64_t visits);
  /// One time step [s], the limit that decided it, and the stable one.
  void count_step(TimeStepLimit limit, double time_step, double stable);

  Profile profile();  ///< of all until now

 private:
  struct Sum {
    double seconds = 0.0;
    std::int64_t calls = 0, pairs = 0;
  };
  Sum& sum(Stage stage) { return sums_[static_cast<std::size_t>(stage)]; }
  void switch_to(Stage stage);

  Clock clock_;
  double since_;
  Stage running_ = Stage::other;
  std::array<Sum, n_stages> sums_;
  PairCount pairs_, counted_;  // of the present rows; sum over all renewals
  std::array<std::int64_t, n_time_step_limits> limits_{};
  double taken_ = 0.0, stable_ = 0.0;  // sums of time steps [s]
};

/// Gives a stage the time from here to the end of the block. Without a timer it does nothing.
class StageScope {
 public:
  /// Enters the stage, until the end of the block. `timer` may be null.
  StageScope(StageTimer* timer, Stage stage) : timer_(timer) {
    if (timer_ != nullptr) outer_ = timer_->enter(stage);
  }
  ~StageScope() {
    if (timer_ != nullptr) timer_->leave(outer_);
  }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

 private:
  StageTimer* timer_;
  Stage outer_ = Stage::other;
};

}  // namespace parapet::solver
