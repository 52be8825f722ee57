#include "cases.hpp"

#include <array>

namespace parapet::validation {

std::span<const Case> all_cases() {
  static constexpr auto cases = std::to_array<Case>({
      {"plane_flows", "Plane Poiseuille and Couette flow", plane_flows},
      {"tanks", "Fluid at rest in tanks", tanks},
      {"uniform_flow", "Uniform debris flow down the channel", uniform_flow},
      {"slump", "Arrested slump on a flat bed", slump},
      {"pond", "Pond held behind a stem", pond},
      {"grid_convergence", "Grid convergence of the metrics", grid_convergence},
      {"noise", "Scatter between equal runs", noise},
      {"smoothness", "Smooth answers over the designs", smoothness},
  });
  return cases;
}

}  // namespace parapet::validation
