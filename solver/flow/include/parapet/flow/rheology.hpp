/// Herschel-Bulkley viscosity with the cut-off (Eq. 12-15).
#pragma once

#include <algorithm>

#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// Yield stress of a material under pressure, tau_y = c + p tan phi with p not below 0 (below Eq.
/// 12 of the paper) [Pa].
inline double yield_stress_under(const Material& material, double tan_phi, double pressure) {
  return material.yield_stress + tan_phi * std::max(pressure, 0.0);
}

/// eta = min(tau_y/g_c, s tau_y/g) + K max(g, g_c)^(N-1) with the cut-off g_c [Pa s]; K alone for a
/// Newtonian fluid. With s = 1 that is tau_y/g + K g^(N-1) at g = max(shear rate, cut-off).
/// @param shear_rate g [1/s]
/// @param yield_fraction s, see below
double apparent_viscosity(const Material& material, double shear_rate, double yield_fraction = 1.0);
/// The same with a yield stress of its own [Pa].
double apparent_viscosity(const Material& material, double yield_stress, double shear_rate,
                          double yield_fraction);

/// Fraction s of tau_y/q that the yield part of a particle's viscosity takes, in [0.5, 1], so that
/// a jump in velocity is dissipated once.
///
/// The rate q of the viscous pairs is the root of a sum of squares. Where the velocity jumps by u
/// across a plane, the sum of V q over the particles is 1.5 to 1.8 u per area at h/dx = 1.33: a
/// plug that slides would meet 1.5 to 1.8 tau_y. The modulus g of the gradient is linear in the
/// velocity and sums to u. With the viscosity s tau_y/q, s = g/q, a particle dissipates tau_y g. In
/// a smooth flow g falls short of q by curvature and disorder alone, and there is no jump to share:
/// from g/q = 0.72 to 0.90 the fraction goes over to 1. Where walls are in reach it
/// does not; that, and both constants, were found by trial (docs/theory.md).
/// @param pair_rate q [1/s]
/// @param gradient_rate g = sqrt(2 S:S) of the renormalised gradient [1/s]
/// @param wall_trace the walls' part of the trace of the tensor of Eq. 8 (2 for all neighbours)
double yield_fraction(double pair_rate, double gradient_rate, double wall_trace);

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
