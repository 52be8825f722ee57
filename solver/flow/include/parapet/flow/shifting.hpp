/// From the sums of the gradient pass to what the equations need, particle by particle:
/// renormalised gradients (Eq. 8), surface indicator and shifting velocity (Eq. 9-11), shear rate
/// (Eq. 13), viscosity (Eq. 14-15) and the switch of the tensile-instability control.
#pragma once

#include "parapet/flow/fluid.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// The limits of Eq. 10 are for plain sums, which on a lattice of the paper's h = 1.33 dx have this
/// smallest eigenvalue. The flow's kernel gives 1 there (lattice_moment).
constexpr double paper_lattice_sum = 0.979;

/// Eq. 10: with a smallest eigenvalue below this a particle has come off the fluid.
constexpr bool is_spray(double lambda) {
  return lambda < 0.55 / paper_lattice_sum;
}

/// Trace of that tensor: 2 in the fluid, 0.2 for a lone pair at the particle spacing. Below this no
/// neighbour is near enough to change the density.
constexpr bool is_alone(double closeness) {
  return closeness < 0.01;
}

/// Constants of the shifting.
struct ShiftingSettings {
  double smoothing_length;     ///< h [m]
  double max_speed;            ///< u_max of Eq. 9 [m/s]
  double factor;               ///< 1 is the paper's
  bool no_slip;                ///< walls shear the fluid
  double background_pressure;  ///< P_0, of which no friction comes [Pa]
  double still2 = 1e-12;       ///< of still_rate2 [1/s2]
};

/// Fills lambda, closeness, tic, shift_u/w, density_grad, quadrature, shear_rate, viscosity and
/// pair_viscosity of particles [begin, end) from their sums, those of `begin` first, and pressures.
void finish_gradients(Fluid& fluid, const GradientSums& sums, const ShiftingSettings& settings,
                      const Material& material, int begin, int end);

}  // namespace parapet::solver
