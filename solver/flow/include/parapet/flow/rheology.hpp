/// Herschel-Bulkley viscosity with the cut-off (Eq. 12-15).
#pragma once

#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// eta = tau_y/g + K g^(N-1), g = max(shear rate, cut-off) [Pa s]; K alone for a Newtonian fluid.
/// The shear rate is in 1/s.
double apparent_viscosity(const Material& material, double shear_rate);

/// Square of a strain rate so slow that it has no direction: 1e-10 of the cut-off's square [1/s2].
double still_rate2(const Material& material);

/// Correction of the viscous pair sum for the arrangement of the neighbours, in [0.5, 2].
///
/// The sum with alpha = 8 dissipates 4 (a^2 P + 2 a b X + b^2 Q) eta in a strain rate
/// S = [[a, b], [b, -a]], where P, X, Q are the fourth moments sum (p^2, p q, q^2) |F| V/r^2 with
/// p = x^2 - z^2, q = 2 x z. The exact value 2 eta S:S = 4 (a^2 + b^2) eta needs P = Q = 1, X = 0,
/// which holds for an isotropic neighbourhood only: rows of particles that slide along a wall give
/// 0.82 at h/dx = 1.33. The factor returned makes the dissipation exact; multiplied into the
/// viscosity it leaves the pair forces central and symmetric, so that both momenta are kept. Where
/// the support is cut off by a free surface it does not make up for what is missing.
/// @param pp, pq, qq P, X and Q
/// @param a, b of the strain rate [1/s]
/// @param still2 of still_rate2 [1/s2]
double viscous_quadrature(double pp, double pq, double qq, double a, double b,
                          double still2 = 1e-12);

}  // namespace parapet::solver
