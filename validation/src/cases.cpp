#include "cases.hpp"

#include <array>

namespace parapet::validation {

std::span<const Case> all_cases() {
  static constexpr auto cases = std::to_array<Case>({
      {"operators", "Kernel and operators", operators},
      {"slip_planes", "Sliding on a wall and on a plane inside", slip_planes},
      {"plane_flows", "Plane Poiseuille and Couette flow", plane_flows},
      {"uniform_flow", "Uniform debris flow down the channel", uniform_flow},
      {"frictional_layer", "Layer with friction, and the slope at which it stops",
       frictional_layer},
      {"tanks", "Fluid at rest in tanks", tanks},
      {"conservation", "Conservation and frames of reference", conservation},
      {"energy_gain", "Energy that thin fluid gains at a barrier", energy_gain},
      {"taylor_green", "Taylor-Green vortices", taylor_green},
      {"oscillating_drop", "Oscillating drop", oscillating_drop},
      {"rotating_patch", "Rotating patch", rotating_patch},
      {"slump", "Arrested slump on a flat bed", slump},
      {"pond", "Pond held behind a stem", pond},
      {"dam_break", "Water dam break against a wall", dam_break},
      {"water_column", "Collapse of a column of water", water_column},
      {"ballistic", "Overflow against the ballistic formula", ballistic},
      {"table3", "Table 3 of the source paper", table3},
      {"table3_as_published", "Table 3 with the paper's scheme", table3_as_published},
      {"grid_convergence", "Grid convergence of the metrics", grid_convergence},
      {"noise", "Scatter between equal runs", noise},
      {"resolution", "Support of the kernel and particle spacing: error and cost", resolution},
      {"smoothness", "Smooth answers over the designs", smoothness},
  });
  return cases;
}

}  // namespace parapet::validation
