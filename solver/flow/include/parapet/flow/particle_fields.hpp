/// The tables of the particle store. Whatever treats all quantities of a particle alike is
/// generated from them: the arrays with their size and first values, what sorting and removal carry
/// along, the records that are packed for the neighbour sums, the views that the sums see and the
/// stages of the Runge-Kutta scheme. A new quantity is one line here; it cannot be forgotten
/// anywhere else.
#pragma once

namespace parapet::solver {

/// Where the ghost stands that pads the neighbour rows: no kernel reaches it [m].
constexpr double far_away = 1e6;

/// How long the values of a quantity are good for.
enum class Lifetime {
  state,    ///< for ever: the time integrations advance it
  lasting,  ///< worked out now and then, and read until it is worked out again
  present,  ///< worked out from the state after every sorting, before anything reads it
  passing   ///< a sum or a rate, read only in the step that has worked it out
};

/// Particles are sorted by cell when the neighbour rows are built; what survives goes with them.
constexpr bool survives_sorting(Lifetime lifetime) {
  return lifetime == Lifetime::state || lifetime == Lifetime::lasting;
}

/// When particles leave the domain, those behind them move up; what survives goes with them.
constexpr bool survives_removal(Lifetime lifetime) {
  return lifetime != Lifetime::passing;
}

}  // namespace parapet::solver

// clang-format off

// FIELD(name, lifetime, first value of every particle, value of the ghost). The first value of the
// state comes from the released particles.
#define PARAPET_STATE_FIELDS(FIELD)                                                                \
  FIELD(x,              state,   0.0, far_away) /* along the bed [m]                            */ \
  FIELD(z,              state,   0.0, far_away) /* normal to it [m]                             */ \
  FIELD(u,              state,   0.0, 0.0)      /* velocity along x [m/s]                       */ \
  FIELD(w,              state,   0.0, 0.0)      /* velocity along z [m/s]                       */ \
  FIELD(density,        state,   0.0, 1.0)      /* [kg/m3]                                      */ \
  FIELD(mass,           state,   0.0, 0.0)      /* [kg/m]                                       */

#define PARAPET_DERIVED_FIELDS(FIELD)                                                              \
  FIELD(pressure,       present, 0.0, 0.0)      /* equation of state, Eq. 2 [Pa]                */ \
  FIELD(volume,         present, 0.0, 0.0)      /* mass over density [m2]                       */ \
  FIELD(lambda,         lasting, 1.0, 0.0)      /* smallest eigenvalue of B, Eq. 10             */ \
  FIELD(closeness,      lasting, 2.0, 0.0)      /* trace of B                                   */ \
  FIELD(density_grad_x, lasting, 0.0, 0.0)      /* renormalised gradient, Eq. 8 [kg/m4]         */ \
  FIELD(density_grad_z, lasting, 0.0, 0.0)      /*                                              */ \
  FIELD(shift_u,        lasting, 0.0, 0.0)      /* shifting velocity, Eq. 9-11 [m/s]            */ \
  FIELD(shift_w,        lasting, 0.0, 0.0)      /*                                              */ \
  FIELD(tic,            lasting, 0.0, 0.0)      /* tensile-instability control: 1, or -1 acting */ \
  FIELD(shear_rate,     lasting, 0.0, 0.0)      /* Eq. 13 [1/s]                                 */ \
  FIELD(viscosity,      lasting, 0.0, 0.0)      /* apparent, Eq. 14-15 [Pa s]                   */ \
  FIELD(quadrature,     lasting, 0.0, 0.0)      /* correction of the viscous pair sum           */ \
  FIELD(pair_viscosity, lasting, 0.0, 0.0)      /* viscosity x quadrature: of the sum [Pa s]    */ \
  FIELD(viscous_ax,     lasting, 0.0, 0.0)      /* viscous acceleration of the last solve       */ \
  FIELD(viscous_az,     lasting, 0.0, 0.0)      /* [m/s2]                                       */

// What the density pass finds.
#define PARAPET_RATE_FIELDS(FIELD)                                                                 \
  FIELD(density_rate,   lasting, 0.0, 0.0)      /* d rho/dt, Eq. 6-7 with shifting [kg/m3/s]    */ \
  FIELD(mass_rate,      passing, 0.0, 0.0)      /* dm/dt that shifting exchanges [kg/m/s]       */ \
  FIELD(exchange_x,     passing, 0.0, 0.0)      /* m du/dt that comes with that mass [N/m]      */ \
  FIELD(exchange_z,     passing, 0.0, 0.0)      /*                                              */

// What the gradient pass finds: sums over the neighbours j of particle i, r = r_j - r_i,
// u = u_j - u_i and so on. B = sum r (x) grad W V_j. F = W'/r. p = x^2 - z^2 and q = 2 x z of r.
#define PARAPET_GRADIENT_SUMS(SUM)                                                                 \
  SUM(fluid_bxx)      /* B over the fluid alone                                                */ \
  SUM(fluid_bxz)      /*                                                                       */ \
  SUM(fluid_bzz)      /*                                                                       */ \
  SUM(bxx)            /* B over fluid and walls                                                */ \
  SUM(bxz)            /*                                                                       */ \
  SUM(bzz)            /*                                                                       */ \
  SUM(density_x)      /* sum rho grad W V_j over the fluid [kg/m4]                             */ \
  SUM(density_z)      /*                                                                       */ \
  SUM(ux)             /* sum u grad W V_j over fluid and walls [1/s]                           */ \
  SUM(uz)             /*                                                                       */ \
  SUM(wx)             /* sum w grad W V_j over fluid and walls [1/s]                           */ \
  SUM(wz)             /*                                                                       */ \
  SUM(shift_x)        /* Eq. 9 without its factor, fluid and walls                             */ \
  SUM(shift_z)        /* [1/m]                                                                 */ \
  SUM(approach2)      /* sum (u . r)^2 |F| V_j/r^2 [1/s2], over what                           */ \
  SUM(moment_pp)      /* shears i: the fluid, and walls without slip                           */ \
  SUM(moment_pq)      /* sum (p^2, p q, q^2) |F| V_j/r^2, over the                             */ \
  SUM(moment_qq)      /* same                                                                    */

#define PARAPET_PARTICLE_FIELDS(FIELD) \
  PARAPET_STATE_FIELDS(FIELD)          \
  PARAPET_DERIVED_FIELDS(FIELD)        \
  PARAPET_RATE_FIELDS(FIELD)

// RECORD(name, type, four fields). What the sums want of a neighbour lies side by side as well: one
// load per neighbour instead of four.
#define PARAPET_PARTICLE_RECORDS(RECORD)                                  \
  RECORD(motion, MotionRecord, x, z, u, w)                                \
  RECORD(state, StateRecord, volume, density, pressure, pair_viscosity)   \
  RECORD(shift, ShiftRecord, shift_u, shift_w, density_grad_x, density_grad_z)

// FIELD(name, value of the ghost) of a wall point, and its records.
#define PARAPET_WALL_FIELDS(FIELD)                                                 \
  FIELD(x,        far_away) /* [m]                                              */ \
  FIELD(z,        far_away) /* [m]                                              */ \
  FIELD(volume,   0.0)      /* [m2]                                             */ \
  FIELD(u,        0.0)      /* velocity of the wall itself [m/s]                */ \
  FIELD(w,        0.0)      /*                                                  */ \
  FIELD(normal_x, 0.0)      /* of the face that it belongs to, into the fluid   */ \
  FIELD(normal_z, 0.0)      /*                                                  */ \
  FIELD(depth,    0.0)      /* below that face [m]                              */

#define PARAPET_WALL_RECORDS(RECORD)                  \
  RECORD(place, PlaceRecord, x, z, volume, depth)     \
  RECORD(face, FaceRecord, u, w, normal_x, normal_z)

// clang-format on
