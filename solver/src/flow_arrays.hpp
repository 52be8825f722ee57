// Views of everything the neighbour sums read and write. Plain pointers, so that the passes can be
// compiled once per instruction set without pulling in library code.
// Index n_fluid (n_wall) is a ghost far away: padding of the neighbour rows points at it.
#pragma once

#include <cstdint>

#include "kernel.hpp"

namespace parapet::solver {

// Neighbour rows: slots [begin, wall_begin) hold fluid neighbours of a fluid particle, slots
// [wall_begin, end) the wall points that it sees; both parts are padded to full vectors.
struct RowView {
  const std::int32_t* begin;             // [n_fluid]
  const std::int32_t* wall_begin;        // [n_fluid]
  const std::int32_t* end;               // [n_fluid]
  const std::int32_t* index;             // [n_slots]
  const std::int32_t* wall_point_begin;  // [n_active]: rows of wall points, fluid neighbours only
  const std::int32_t* wall_point_end;    // [n_active]
  const std::int32_t* wall_point_index;  // [n_wall_slots]
  const std::int32_t* active_wall;       // [n_active]: wall points that see fluid
  int n_active;
};

// What a pass wants of its neighbours, four values side by side: one load per neighbour instead of
// four. The records repeat the arrays; Fluid::pack fills them.
struct alignas(32) Record {
  double value[4];
};

// A vector in the plane, side by side.
struct alignas(16) Pair {
  double x, z;
};

struct FluidView {
  int n;
  const double *x, *z;      // position [m]
  const double *u, *w;      // velocity [m/s]
  const double* density;    // [kg/m3]
  const double* pressure;   // [Pa]
  const double* volume;     // m/rho [m2]
  const double* viscosity;  // apparent, with the quadrature correction of rheology.hpp [Pa s]
  const double *density_grad_x, *density_grad_z;  // renormalised [kg/m4]
  const double *shift_u, *shift_w;                // shifting velocity [m/s]
  const double* tic;     // +1, or -1 where the tensile-instability control acts
  const Record* motion;  // x, z, u, w
  const Record* state;   // volume, density, pressure, viscosity
  const Record* shift;   // shift_u, shift_w, density_grad_x, density_grad_z
};

struct WallView {
  int n;
  const double *x, *z;                // [m]
  const double* volume;               // [m2]
  const double *u, *w;                // velocity of the wall itself [m/s]
  const double *normal_x, *normal_z;  // of the face, into the fluid
  const double* depth;                // below the face [m]
  double* pressure;                   // extrapolated from the fluid [Pa]
  double *fluid_u, *fluid_w;          // fluid velocity interpolated at the point [m/s]
  const Record* place;                // x, z, volume, depth
  const Record* face;                 // u, w, normal_x, normal_z
  Record* state;                      // pressure, fluid_u, fluid_w, 0; the ghost's is zero
};

// Sums of the gradient pass, [n_fluid] each. B = sum (r_j - r_i) (x) grad W V_j.
struct GradientSums {
  double *fluid_bxx, *fluid_bxz, *fluid_bzz;  // over the fluid alone
  double *bxx, *bxz, *bzz;                    // over fluid and walls
  double *density_x, *density_z;              // sum (rho_j - rho_i) grad W V_j, fluid [kg/m4]
  double *ux, *uz, *wx, *wz;                  // sum (u_j - u_i) grad W V_j, both [1/s]
  double *shift_x, *shift_z;                  // sum of Eq. 9 without its factor, both [1/m]
  double* approach2;                          // sum (u_ij . r_ij)^2 |F| V_j/r^2 [1/s2]
  double *moment_pp, *moment_pq, *moment_qq;  // sum p^2, p q, q^2 |F| V_j/r^2 with p = x^2 - z^2,
                                              // q = 2 x z of r_ij, over what shears the particle
};

// What the density pass finds, [n_fluid] each.
struct ShiftedRates {
  double* density;                  // d rho/dt [kg/m3/s]
  double* mass;                     // dm/dt [kg/m/s]
  double *exchange_x, *exchange_z;  // m du/dt from the mass that shifting exchanges [N/m]
};

struct FlowConstants {
  Kernel kernel;
  double smoothing_length;      // h [m]
  double sound_speed;           // [m/s]
  double reference_density;     // [kg/m3]
  double density_diffusion;     // delta
  double gravity_x, gravity_z;  // [m/s2]
  double periodic_length;       // of the domain along x [m]; 0 when not periodic
  double even_volume;           // V_j of Eq. 9: dx^2 [m2]
  bool no_slip;
};

// Viscous matrix: slot s couples its pair by b b^T, b = sqrt(dt 8 eta_ij |F| V_i V_j) r_ij/r.
struct ViscousView {
  double *bx, *bz;                                  // [n_slots], fluid slots only
  double *diagonal_xx, *diagonal_xz, *diagonal_zz;  // [n_fluid] mass, pairs and walls
  double *wall_xx, *wall_xz, *wall_zz;              // [n_fluid] mass and walls alone
  double *rhs_x, *rhs_z;  // [n_fluid] momentum from the walls' lagged part
  const double* mass;     // [n_fluid]
  double dt;
};

// Vectors of the conjugate gradients; [n_fluid], padded with zeros to whole vectors. `scale` turns
// a squared residual into a squared acceleration, twice the same.
struct DescentView {
  Pair *solution, *residual, *preconditioned, *direction, *image;
  const Pair *inverse_diagonal, *inverse_off, *scale;  // of the 2 x 2 block: (xx, zz), (xz, xz)
};

struct DescentSums {
  double product;  // residual . preconditioned
  double worst;    // largest squared acceleration [m2/s4]
};

// Rows of the pairs within the support alone, for as long as no particle moves: the same shape as
// RowView's, of [n_fluid] and at most [n_slots].
struct ReachedRows {
  std::int32_t *begin, *wall_begin, *end, *index;
};

struct FlowArrays {
  FlowConstants constants;
  FluidView fluid;
  WallView wall;
  RowView rows;
};

}  // namespace parapet::solver
