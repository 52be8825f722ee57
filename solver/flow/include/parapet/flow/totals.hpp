/// Sums over the fluid: what a flow should keep and what it loses.
#pragma once

#include "parapet/flow/flow.hpp"

namespace parapet::solver {

/// Per metre width.
struct Totals {
  double mass = 0.0;              ///< [kg/m]
  Vec2 momentum;                  ///< [kg/s]
  double angular_momentum = 0.0;  ///< about the origin, anticlockwise in (x, z) [kg m/s]
  double kinetic = 0.0;           ///< [J/m]
  double potential = 0.0;         ///< in gravity and the central force [J/m]
  double elastic = 0.0;      ///< of the compressible fluid, sum m c^2/2 (rho/rho_0 - 1)^2 [J/m]
  double dissipation = 0.0;  ///< sum V eta g^2 with the shear rates of the last gradients [W/m]
};
/// Of the particles as they are now.
Totals totals(const Flow& flow);

}  // namespace parapet::solver
