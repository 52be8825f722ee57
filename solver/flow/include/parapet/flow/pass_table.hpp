/// The passes: the neighbour sums, each over a range [begin, end) of particles or of wall points
/// that begins with a whole group; one table per instruction set and scheme. Flow calls them; call
/// them yourself to measure or to check them.
///
///     FlowArrays arrays = flow.arrays();
///     const PassTable& passes = best_passes();
///     passes.pressure_force(arrays, ax.data(), az.data(), 0, arrays.fluid.n);
#pragma once

#include <string_view>

#include "parapet/flow/flow_arrays.hpp"

namespace parapet::solver {

enum class Scheme;  // parapet/solver/numerics.hpp

/// The passes of one instruction set. What differs in the scheme as_published is said in its
/// sources, passes/as_published/.
struct PassTable {
  const char* name;  ///< of the instruction set
  /// Writes the numbers of those candidates that are nearer than the distance, in their order, and
  /// says how many; `out` has room for a whole vector more than there are candidates.
  int (*pick_near)(const NearCandidates&, std::int32_t* out);
  /// The rows of the pairs that the kernel reaches; the arrays' own rows are not looked at.
  void (*reached_rows)(const FlowArrays&, const NearView&, const ReachedRows&, int begin, int end);
  /// Pressure of the fluid at wall points (Adami et al. 2012); range over active_wall.
  void (*extrapolate_walls)(const FlowArrays&, int begin, int end);
  /// All sums of the renormalised gradients, shifting and strain rate; those of `begin` come first.
  void (*gradient_sums)(const FlowArrays&, const GradientSums&, int begin, int end);
  /// Pressure part of Eq. 6 into ax, az [m/s2].
  void (*pressure_force)(const FlowArrays&, double* ax, double* az, int begin, int end);
  /// Viscous part of Eq. 6, added to ax, az [m/s2].
  void (*viscous_force)(const FlowArrays&, double* ax, double* az, int begin, int end);
  /// Density rate of Eq. 6-7, with what shifting adds to it and the mass and momentum that shifting
  /// exchanges.
  void (*density_rate)(const FlowArrays&, const ShiftedRates&, int begin, int end);
  /// The viscous force as a matrix, for the implicit step.
  void (*viscous_matrix)(const FlowArrays&, const ViscousView&, int begin, int end);
  /// y = A p over the fluid. p: places, and the vector in place of the velocities, [n_fluid + 1]
  /// with a ghost at rest; yx, yz: [n_fluid]. Returns p . y.
  double (*viscous_product)(const FlowArrays&, const ViscousView&, const MotionRecord* p,
                            double* yx, double* yz, int begin, int end);
  /// solution += step direction, residual -= step image.
  DescentSums (*descend)(const DescentView&, double step, int begin, int end);
  /// direction = D^-1 residual + beta direction.
  void (*turn)(const DescentView&, double beta, int begin, int end);
  /// Force of the fluid on wall points [N/m]; range over active_wall.
  void (*wall_load)(const FlowArrays&, double* fx, double* fz, int begin, int end);
};

/// The fastest table that this machine can run. Every table of a scheme gives the same bits.
const PassTable& best_passes(Scheme scheme);
const PassTable& best_passes();  ///< of Scheme::corrected

/// By name ("x86_64", "x86_64_v3", "x86_64_v4"); nullptr when this machine or build lacks it.
const PassTable* find_passes(std::string_view name, Scheme scheme);
const PassTable* find_passes(std::string_view name);  ///< of Scheme::corrected

}  // namespace parapet::solver
