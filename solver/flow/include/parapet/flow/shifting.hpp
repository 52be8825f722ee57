/// From the sums of the gradient pass to what the equations need, particle by particle:
/// renormalised gradients (Eq. 8), surface indicator and shifting velocity (Eq. 9-11), shear rate
/// (Eq. 13) and the switch of the tensile-instability control.
#pragma once

#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

/// Eq. 10: with a smallest eigenvalue below this a particle has come off the fluid.
constexpr bool is_spray(double lambda) {
  return lambda < 0.55;
}

/// Trace of that tensor: 2 in the fluid, 0.2 for a lone pair at the particle spacing. Below this no
/// neighbour is near enough to change the density.
constexpr bool is_alone(double closeness) {
  return closeness < 0.01;
}

/// Constants of the shifting.
struct ShiftingSettings {
  double smoothing_length;  ///< h [m]
  double max_speed;         ///< u_max of Eq. 9 [m/s]
  double factor;            ///< 1 is the paper's
  bool no_slip;             ///< walls shear the fluid
  double still2 = 1e-12;    ///< of still_rate2 [1/s2]
};

/// Fills lambda, closeness, tic, shift_u/w, density_grad, quadrature and shear_rate of particles
/// [begin, end) from their sums, those of `begin` first, and pressures.
void finish_gradients(Fluid& fluid, const GradientSums& sums, const ShiftingSettings& settings,
                      int begin, int end);

}  // namespace parapet::solver
