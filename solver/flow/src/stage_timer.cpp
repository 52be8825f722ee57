#include "parapet/flow/stage_timer.hpp"

#include <chrono>
#include <utility>

namespace parapet::solver {
namespace {

struct StageInfo {
  const char* name;
  bool fluid_pairs, wall_pairs;  // that one visit sees
};

// In the order of Stage.
constexpr std::array<StageInfo, n_stages> stage_table{{{"neighbour check", false, false},
                                                       {"neighbour rows", false, false},
                                                       {"equation of state", false, false},
                                                       {"wall boundary", false, true},
                                                       {"gradients, rheology", true, true},
                                                       {"pressure force", true, true},
                                                       {"viscous force", true, true},
                                                       {"viscous matrix", true, true},
                                                       {"conjugate gradients", true, false},
                                                       {"density rate", true, true},
                                                       {"wall load", false, false},
                                                       {"integrate", false, false},
                                                       {"wall contact", false, false},
                                                       {"time step, checks", false, false},
                                                       {"gauges, metrics", false, false},
                                                       {"output", false, false},
                                                       {"profiling", false, false},
                                                       {"other", false, false}}};

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double ratio(double a, double b) {
  return b > 0.0 ? a / b : 0.0;
}

}  // namespace

PairCount count_pairs(const FlowArrays& a) {
  const double reach = 2.0 * a.constants.smoothing_length, length = a.constants.periodic_length;
  const auto near = [&](int i, double x, double z) {
    double rx = a.fluid.x[i] - x;
    if (length > 0.0 && rx > 0.5 * length) rx -= length;
    if (length > 0.0 && rx < -0.5 * length) rx += length;
    const double rz = a.fluid.z[i] - z;
    return rx * rx + rz * rz < reach * reach;
  };
  PairCount count;
  count.particles = a.fluid.n;
  for (int i = 0; i < a.fluid.n; ++i) {
    const int g = i / lanes, lane = i % lanes;
    for (int s = a.rows.begin[g] + lane; s < a.rows.wall_begin[g]; s += lanes) {
      const int j = a.rows.index[s];
      count.fluid += j < a.fluid.n && near(i, a.fluid.x[j], a.fluid.z[j]);
    }
    for (int s = a.rows.wall_begin[g] + lane; s < a.rows.end[g]; s += lanes) {
      const int k = a.rows.index[s];
      count.wall += k < a.wall.n && near(i, a.wall.x[k], a.wall.z[k]);
    }
    if (lane == 0) count.slots += a.rows.end[g] - a.rows.begin[g];
  }
  return count;
}

StageTimer::StageTimer() : StageTimer(steady_seconds) {}

StageTimer::StageTimer(Clock clock) : clock_(std::move(clock)), since_(clock_()) {
  sum(running_).calls = 1;
}

void StageTimer::switch_to(Stage stage) {
  const double now = clock_();
  sum(running_).seconds += now - since_;
  since_ = now;
  running_ = stage;
}

Stage StageTimer::enter(Stage stage) {
  const Stage outer = running_;
  switch_to(stage);
  ++sum(stage).calls;
  add_visits(stage, 1);
  return outer;
}

void StageTimer::set_pairs(const PairCount& pairs) {
  pairs_ = pairs;
  counted_.particles += pairs.particles;
  counted_.fluid += pairs.fluid;
  counted_.wall += pairs.wall;
  counted_.slots += pairs.slots;
}

void StageTimer::add_visits(Stage stage, std::int64_t visits) {
  const StageInfo& info = stage_table[static_cast<std::size_t>(stage)];
  if (info.fluid_pairs) sum(stage).pairs += visits * pairs_.fluid;
  if (info.wall_pairs) sum(stage).pairs += visits * pairs_.wall;
}

void StageTimer::count_step(TimeStepLimit limit, double time_step, double stable) {
  ++limits_[static_cast<std::size_t>(limit)];
  taken_ += time_step;
  stable_ += stable;
}

Profile StageTimer::profile() {
  switch_to(running_);
  Profile p;
  for (std::size_t k = 0; k < n_stages; ++k) {
    if (sums_[k].calls == 0) continue;
    p.stages.push_back({stage_table[k].name, sums_[k].seconds, sums_[k].calls, sums_[k].pairs});
  }
  p.steps_acoustic = limits_[static_cast<std::size_t>(TimeStepLimit::acoustic)];
  p.steps_acceleration = limits_[static_cast<std::size_t>(TimeStepLimit::acceleration)];
  p.steps_viscous = limits_[static_cast<std::size_t>(TimeStepLimit::viscous)];
  p.step_shortening = stable_ > 0.0 ? 1.0 - taken_ / stable_ : 0.0;
  const auto particles = static_cast<double>(counted_.particles);
  const auto fluid = static_cast<double>(counted_.fluid), wall = static_cast<double>(counted_.wall);
  p.fluid_neighbors = ratio(fluid, particles);
  p.wall_neighbors = ratio(wall, particles);
  p.slots_per_pair = ratio(static_cast<double>(counted_.slots), fluid + wall);
  return p;
}

double Profile::seconds() const {
  double sum = 0.0;
  for (const StageTime& stage : stages) sum += stage.seconds;
  return sum;
}

}  // namespace parapet::solver
