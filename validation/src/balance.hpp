// What a flow should keep and what it loses: mass, momentum with the forces of the walls, energy.
#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "flow_tools.hpp"

namespace parapet::validation {

// Followed step by step by advance(). Needs measure_all_walls for the momentum; walls at rest for
// the energy.
class Balance {
 public:
  explicit Balance(const solver::Flow& flow);

  // After each step of the flow.
  void add_step(solver::Flow& flow);

  // What each barrier received in the last step; the flow itself no longer knows it.
  const std::vector<solver::BarrierImpulse>& last_impulses() const { return last_; }

  // Mass now (with what has left) over mass at the start, minus 1.
  double mass_change(const solver::Flow& flow) const;
  // |momentum now - momentum at the start - impulse of gravity and walls| over the largest
  // impulse of gravity so far (or over the largest momentum, without gravity).
  double momentum_error(const solver::Flow& flow) const;
  // Kinetic, potential and elastic energy lost since the start [J/m].
  double energy_loss(const solver::Flow& flow) const;
  // Of the fluid on each load cell since the start.
  const std::vector<solver::BarrierImpulse>& impulses() const { return impulses_; }
  // Dissipated by the viscous forces since the start [J/m].
  double dissipated() const { return dissipated_; }
  // (energy lost - dissipated) over `scale`, by default the energy lost: what the scheme itself
  // (density diffusion, shifting, splitting) has taken, or given when negative.
  double numerical_share(const solver::Flow& flow, double scale = 0.0) const;

 private:
  Totals start_;
  solver::Vec2 impulse_;                          // of gravity and walls on the fluid [N s/m]
  std::vector<solver::BarrierImpulse> last_;      // of the latest step
  std::vector<solver::BarrierImpulse> impulses_;  // since the start
  double scale_ = 0.0, dissipated_ = 0.0;
};

// Rows of the scorecard that every flow has: mass kept to rounding; momentum. `of` ends up in the
// words ("dam break"), `key` starts the keys.
void add_balance(CaseRun& run, const std::string& key, const std::string& of,
                 const Balance& balance, const solver::Flow& flow);

}  // namespace parapet::validation
