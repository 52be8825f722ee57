/// What the scheme as_published (Scheme in numerics.hpp) does between its passes: Eq. 2 and 8-15 of
/// Huang et al. 2024 without what Parapet adds. docs/theory.md lists the differences.
#pragma once

#include "parapet/flow/fluid.hpp"
#include "parapet/flow/shifting.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// Eq. 2, p = c_s^2 (rho - rho_0) + P_0, and the volumes, of all particles.
/// @param c2 c_s^2 [m2/s2]
/// @param background_pressure P_0 [Pa]
void published_pressure(Fluid& fluid, double c2, double reference_density,
                        double background_pressure);

/// What finish_gradients fills, by the paper: lambda over fluid and walls; density gradient (Eq.
/// 8); shear rate sqrt(2 S:S) of the plain gradient (Eq. 4, 13) and its viscosity (Eq. 14-15), with
/// the quadrature 1; shifting velocity of Eq. 9 and 11, not yet projected at the surface: zero
/// where lambda < 0.55. The tensile-instability control acts where p < 0 and lambda > 0.9.
void finish_published_gradients(Fluid& fluid, const GradientSums& sums,
                                const ShiftingSettings& settings, const Material& material,
                                int begin, int end);

/// Second line of Eq. 10: where 0.55 <= lambda <= 0.9 and the shift points out of the fluid, only
/// its part along the surface remains. The normal is that of Marrone et al. 2010,
/// n = -L sum (lambda_j - lambda_i) grad W V_j over the fluid, of unit length.
/// @pre lambda and shift of all particles are those of finish_published_gradients
void project_shift_at_surface(Fluid& fluid, const FlowArrays& arrays, int begin, int end);

}  // namespace parapet::solver
