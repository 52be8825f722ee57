/// Views of everything the neighbour sums read and write. Plain pointers, so that the passes can be
/// compiled once per instruction set without pulling in library code.
/// Index n_fluid (n_wall) is a ghost far away: padding of the neighbour rows points at it.
#pragma once

#include <cstdint>

#include "parapet/flow/kernel.hpp"
#include "parapet/flow/particle_fields.hpp"

namespace parapet::solver {

/// Groups of `lanes` particles that n of them make; the last one may have fewer.
constexpr int groups_of(int n) {
  return (n + lanes - 1) / lanes;
}

/// Neighbour rows of whole groups, of the pairs within the support: group g holds the particles
/// lanes g, lanes g + 1 and so on, and each of its slots `lanes` indices, one neighbour of each
/// particle in their order. Slots [begin, wall_begin) hold fluid neighbours, slots [wall_begin,
/// end) the wall points that a particle sees; a particle with fewer than others of its group has
/// the ghost in its last ones.
///
///     for (int s = rows.begin[i / lanes] + i % lanes; s < rows.wall_begin[i / lanes]; s += lanes)
///     {
///       const int j = rows.index[s];  // a neighbour of i when j < fluid.n
///
struct RowView {
  const std::int32_t* begin;       ///< [n_groups] where a group's first slot starts in index
  const std::int32_t* wall_begin;  ///< [n_groups]
  const std::int32_t* end;         ///< [n_groups]
  const std::int32_t* index;       ///< [lanes n_slots]
  /// Wall points that see fluid, [n_active] and ghosts up to a whole group; the rows of these
  /// groups, fluid neighbours only, are [wall_point_begin[g], wall_point_begin[g + 1]).
  const std::int32_t* active_wall;
  const std::int32_t* wall_point_begin;  ///< [n_active_groups + 1]
  const std::int32_t* wall_point_index;  ///< [lanes n_wall_slots]
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
  double* pressure;  ///< extrapolated from the fluid [Pa]; the ghost's is zero
  /// Scheme as_published: velocity that shears the fluid, mirrored at the wall [m/s].
  double *mirrored_u, *mirrored_w;
};

/// Sums of the gradient pass over a range of particles, [end - begin] each.
struct GradientSums {
#define PARAPET_WRITTEN_SUM(name) double* name;
  PARAPET_GRADIENT_SUMS(PARAPET_WRITTEN_SUM)
#undef PARAPET_WRITTEN_SUM
};
/// Rates of the density pass, [n_fluid] each.
struct ShiftedRates {
#define PARAPET_WRITTEN_RATE(name, ...) double* name;
  PARAPET_RATE_FIELDS(PARAPET_WRITTEN_RATE)
#undef PARAPET_WRITTEN_RATE
};

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
  double mass_diffusivity;      ///< between particles of unequal masses [m2/s]
  bool no_slip;
};

/// Viscous matrix: a pair is coupled by s r r^T, r = r_ij, s = dt 8 eta_ij |F| V_i V_j/r^2.
struct ViscousView {
  float* strength;                                  ///< s of the fluid's slots, by groups
  const std::int32_t* begin;                        ///< [n_groups] where a group's start
  double *wall_xx, *wall_xz, *wall_zz;              ///< [n_fluid] mass and walls alone
  double *diagonal_xx, *diagonal_xz, *diagonal_zz;  ///< [n_fluid] mass, pairs and walls
  double *rhs_x, *rhs_z;                            ///< [n_fluid] momentum from walls that move
  double dt;
};

/// Vectors of the conjugate gradients, [n_fluid]. The direction has its particles' places beside it
/// and a ghost behind it. `scale` turns a squared residual into a squared acceleration.
struct DescentView {
  double *u, *w;  ///< solution
  MotionRecord* direction;
  double *residual_x, *residual_z;
  const double *image_x, *image_z;
  const double *inverse_xx, *inverse_xz, *inverse_zz;  ///< of the 2 x 2 block of the diagonal
  const double* scale;
};

/// What a step of the conjugate gradients finds.
struct DescentSums {
  double product;  ///< residual . preconditioned
  double worst;    ///< largest squared acceleration [m2/s4]
};

/// Particles [begin, end) that may be near a place.
struct NearCandidates {
  const double *x, *z;  ///< of all particles [m]
  int begin, end;       ///< the candidates
  int self;             ///< never picked
  double at_x, at_z;    ///< the place [m]
  double distance2;     ///< squared, below which a candidate is near [m2]
  double period;        ///< of the domain along x [m]; 0 when not periodic
};

/// Particles that may be near one: [begin[k], end[k]) of the columns of cells before, own and
/// after.
struct NearRanges {
  std::int32_t begin[3], end[3];
};

/// What the rows of a step are picked from, until particles have moved too far (NeighborRows). The
/// neighbours of a group far from every body are among the particles of ranges; a body hides some,
/// so near one they are listed, as wall points are everywhere. Lists are in index, one after the
/// other for the particles of group g and of equal length, with the ghost behind the last: those of
/// fluid neighbours are [begin[g], wall_begin[g]), of wall points [wall_begin[g], end[g]).
struct NearView {
  const NearRanges* ranges;                      ///< [n_layers]
  const std::int32_t* layer;                     ///< [n_fluid] index into ranges
  const std::uint8_t* listed;                    ///< [n_groups] 1: the fluid neighbours are
  const std::int32_t *begin, *wall_begin, *end;  ///< [n_groups]
  const std::int32_t* index;
};

/// Where the rows of a step are written: RowView's arrays, [n_groups] each and as many indices as
/// may become necessary.
struct ReachedRows {
  std::int32_t *begin, *wall_begin, *end, *index;
  std::int32_t first;     ///< where the range's first group starts in index
  std::int32_t* scratch;  ///< [lanes room]
  std::int32_t room;      ///< for what one row is picked from, and a vector more
};

/// Everything that a pass sees.
struct FlowArrays {
  FlowConstants constants;
  FluidView fluid;
  WallView wall;
  RowView rows;
};

}  // namespace parapet::solver
