// The neighbour sums, each over a range of particles; one table per instruction set.
#pragma once

#include <string_view>

#include "../flow_arrays.hpp"

namespace parapet::solver {

struct PassTable {
  const char* name;
  // The rows without the pairs that the skin holds but the kernel does not reach; the rows of a
  // range start at its first row's old place.
  void (*reached_rows)(const FlowArrays&, const ReachedRows&, int begin, int end);
  // Pressure and velocity of the fluid at wall points (Adami et al. 2012); range over active_wall.
  void (*extrapolate_walls)(const FlowArrays&, int begin, int end);
  // All sums of the renormalised gradients, shifting and strain rate.
  void (*gradient_sums)(const FlowArrays&, const GradientSums&, int begin, int end);
  // Pressure part of Eq. 6 [m/s2].
  void (*pressure_force)(const FlowArrays&, double* ax, double* az, int begin, int end);
  // Viscous part of Eq. 6, added to ax, az.
  void (*viscous_force)(const FlowArrays&, double* ax, double* az, int begin, int end);
  // Density rate of Eq. 6-7 without the shifting.
  void (*density_rate)(const FlowArrays&, const ShiftedRates&, int begin, int end);
  void (*viscous_matrix)(const FlowArrays&, const ViscousView&, int begin, int end);
  // y = A p over the fluid; both [n_fluid], p with the ghost at rest. Returns p . y.
  double (*viscous_product)(const FlowArrays&, const ViscousView&, const Pair* p, Pair* y,
                            int begin, int end);
  // solution += step direction, residual -= step image, preconditioned = D^-1 residual.
  DescentSums (*descend)(const DescentView&, double step, int begin, int end);
  // direction = preconditioned + beta direction.
  void (*turn)(const DescentView&, double beta, int begin, int end);
  // Force of the fluid on wall points [N/m]; range over active_wall.
  void (*wall_load)(const FlowArrays&, double* fx, double* fz, int begin, int end);
};

// The fastest table that this machine can run. Every table gives the same bits.
const PassTable& best_passes();

// By name ("x86_64", "x86_64_v3", "x86_64_v4"); nullptr when this machine or build lacks it.
const PassTable* find_passes(std::string_view name);

}  // namespace parapet::solver
