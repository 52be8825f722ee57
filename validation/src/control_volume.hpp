// The load on a barrier by the momentum of the flow around it: a cross-check of the load gauge,
// which sums the forces at the barrier's wall points.
#pragma once

#include <vector>

#include "parapet/flow/flow.hpp"

namespace parapet::validation {

// The load cells of a flow that is set up by with_control_volume.
enum ControlCells { stem_cell, deflector_cell, bed_cell, control_cells };

// Everything between two planes normal to the bed [m].
struct ControlPlanes {
  double from, to;
};

// The planes around the first barrier of a channel, on whole spacings: `clearance` or more to
// either side of its foot, and of all of its outline.
ControlPlanes planes_around(const solver::Scene& scene, double spacing, double clearance);

// A channel with one barrier whose bed between the planes is a load cell of its own.
// @pre of channel_setup, planes at multiples of the particle spacing
void with_control_volume(solver::FlowSetup& setup, const ControlPlanes& planes);

// Momentum of what is between the planes, step by step:
//   impulse on the barrier = gravity + flux through the planes + forces across the planes
//                            - impulse on the bed - change of the momentum
// The forces across the planes are those of particles outside on particles inside: pressure (Eq.
// 6), viscosity (Monaghan and Gingold 1983), and the momentum that shifting exchanges; and of the
// bed beyond a plane on them, less what the bed inside does to particles outside. All are summed
// here pair by pair, on their own.
class ControlVolume {
 public:
  ControlVolume(const solver::Flow& flow, const ControlPlanes& planes);

  // After each step of the flow; takes its impulses.
  void add_step(solver::Flow& flow);

  struct Sample {
    double time;                     // [s]
    solver::Vec2 measured, balance;  // impulses on the barrier since the start [N s/m]
  };
  const std::vector<Sample>& samples() const { return samples_; }

  struct Mean {
    double end;                      // of the window [s]
    solver::Vec2 measured, balance;  // mean forces in it [N/m]
  };
  // Over the window of that length in which the measured force is largest [s].
  Mean largest_mean(double window) const;

 private:
  // Of a particle as it was at the end of the step before, by its number at release.
  struct Before {
    double x = 0.0, z = 0.0;
    solver::Vec2 momentum;
    bool inside = false;
  };
  bool inside(double x) const { return x >= planes_.from && x < planes_.to; }
  void remember(const solver::Flow& flow);
  // Forces on those inside [N/m]: of the particles outside, and of the bed beyond the planes.
  solver::Vec2 of_particles(const solver::Flow& flow, const solver::FlowConstants& constants) const;
  solver::Vec2 of_bed(const solver::Flow& flow, const solver::FlowConstants& constants) const;

  ControlPlanes planes_;
  std::vector<Before> before_;           // [n_released]
  std::vector<std::size_t> bed_points_;  // within reach of a plane
  std::vector<Sample> samples_;
};

}  // namespace parapet::validation
