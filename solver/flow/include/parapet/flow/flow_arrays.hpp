/// Views of everything the neighbour sums read and write. Plain pointers, so that the passes can be
/// compiled once per instruction set without pulling in library code.
/// Index n_fluid (n_wall) is a ghost far away: padding of the neighbour rows points at it.
#pragma once

#include <cstdint>

#include "parapet/flow/kernel.hpp"
#include "parapet/flow/particle_fields.hpp"

namespace parapet::solver {

/// Neighbour rows: slots [begin, wall_begin) hold fluid neighbours of a fluid particle, slots
/// [wall_begin, end) the wall points that it sees; both parts are padded to full vectors.
struct RowView {
  const std::int32_t* begin;             ///< [n_fluid]
  const std::int32_t* wall_begin;        ///< [n_fluid]
  const std::int32_t* end;               ///< [n_fluid]
  const std::int32_t* index;             ///< [n_slots]
  const std::int32_t* wall_point_begin;  ///< [n_active]: rows of wall points, fluid neighbours only
  const std::int32_t* wall_point_end;    ///< [n_active]
  const std::int32_t* wall_point_index;  ///< [n_wall_slots]
  const std::int32_t* active_wall;       ///< [n_active]: wall points that see fluid
  int n_active;
};

/// What a neighbour sum wants of its neighbours, four values side by side. The records repeat the
/// arrays; Fluid::pack fills them.
#define PARAPET_DECLARE_RECORD(name, Type, a, b, c, d) \
  struct alignas(32) Type {                            \
    double a, b, c, d;                                 \
  };
PARAPET_PARTICLE_RECORDS(PARAPET_DECLARE_RECORD)
PARAPET_WALL_RECORDS(PARAPET_DECLARE_RECORD)
#undef PARAPET_DECLARE_RECORD

/// What the fluid does to a wall point.
struct alignas(32) WallState {
  double pressure;          ///< extrapolated from the fluid [Pa]
  double fluid_u, fluid_w;  ///< fluid velocity interpolated at the point [m/s]
  double unused;            ///< a record holds four
};

/// A vector in the plane, side by side.
struct alignas(16) Pair {
  double x, z;
};

/// Arrays [n + 1] of every quantity that lasts, and the records; names and units:
/// particle_fields.hpp.
struct FluidView {
  int n;
#define PARAPET_VIEW_FIELD(name, ...) const double* name;
#define PARAPET_VIEW_RECORD(name, Type, ...) const Type* name;
  PARAPET_STATE_FIELDS(PARAPET_VIEW_FIELD)
  PARAPET_DERIVED_FIELDS(PARAPET_VIEW_FIELD)
  PARAPET_PARTICLE_RECORDS(PARAPET_VIEW_RECORD)
};

/// Arrays [n + 1] of the wall points, likewise.
struct WallView {
  int n;
  PARAPET_WALL_FIELDS(PARAPET_VIEW_FIELD)
  PARAPET_WALL_RECORDS(PARAPET_VIEW_RECORD)
#undef PARAPET_VIEW_FIELD
#undef PARAPET_VIEW_RECORD
  WallState* state;  ///< the ghost's is zero
};

/// What the gradient and the density pass write, [n_fluid] each.
#define PARAPET_WRITTEN_FIELD(name, ...) double* name;
/// Sums of the gradient pass.
struct GradientSums {
  PARAPET_GRADIENT_SUMS(PARAPET_WRITTEN_FIELD)
};
/// Rates of the density pass.
struct ShiftedRates {
  PARAPET_RATE_FIELDS(PARAPET_WRITTEN_FIELD)
};
#undef PARAPET_WRITTEN_FIELD

/// What is the same for all particles.
struct FlowConstants {
  Kernel kernel;
  double smoothing_length;      ///< h [m]
  double sound_speed;           ///< [m/s]
  double reference_density;     ///< [kg/m3]
  double density_diffusion;     ///< delta
  double gravity_x, gravity_z;  ///< [m/s2]
  double periodic_length;       ///< of the domain along x [m]; 0 when not periodic
  double even_volume;           ///< V_j of Eq. 9: dx^2 [m2]
  bool no_slip;
};

/// Viscous matrix: slot s couples its pair by b b^T, b = sqrt(dt 8 eta_ij |F| V_i V_j) r_ij/r.
struct ViscousView {
  double *bx, *bz;                                  ///< [n_slots], fluid slots only
  double *diagonal_xx, *diagonal_xz, *diagonal_zz;  ///< [n_fluid] mass, pairs and walls
  double *wall_xx, *wall_xz, *wall_zz;              ///< [n_fluid] mass and walls alone
  double *rhs_x, *rhs_z;  ///< [n_fluid] momentum from the walls' lagged part
  const double* mass;     ///< [n_fluid]
  double dt;
};

/// Vectors of the conjugate gradients; [n_fluid], padded with zeros to whole vectors. `scale` turns
/// a squared residual into a squared acceleration, twice the same.
struct DescentView {
  Pair *solution, *residual, *preconditioned, *direction, *image;
  const Pair *inverse_diagonal, *inverse_off, *scale;  ///< of the 2 x 2 block: (xx, zz), (xz, xz)
};

/// What a step of the conjugate gradients finds.
struct DescentSums {
  double product;  ///< residual . preconditioned
  double worst;    ///< largest squared acceleration [m2/s4]
};

/// Rows of the pairs within the support alone, for as long as no particle moves: the same shape as
/// RowView's, of [n_fluid] and at most [n_slots].
struct ReachedRows {
  std::int32_t *begin, *wall_begin, *end, *index;
};

/// Everything that a pass sees.
struct FlowArrays {
  FlowConstants constants;
  FluidView fluid;
  WallView wall;
  RowView rows;
};

}  // namespace parapet::solver
