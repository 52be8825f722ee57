// The fluid's particles: one aligned array per quantity, and everything computed from them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flow_arrays.hpp"

namespace parapet::solver {

// One particle at release.
struct InitialParticle {
  double x, z;     // [m]
  double u, w;     // [m/s]
  double density;  // [kg/m3]
  double mass;     // [kg/m]
};

// Arrays are [n + 1]: the last entry is the ghost that pads neighbour rows.
struct Fluid {
  int n = 0;
  std::vector<double> x, z, u, w, density, mass;       // state
  std::vector<double> pressure, volume;                // from the equation of state
  std::vector<double> viscosity, shear_rate;           // rheology (Eq. 13-15)
  std::vector<double> quadrature;                      // correction of the viscous sum
  std::vector<double> pair_viscosity;                  // viscosity x quadrature
  std::vector<double> lambda, closeness;               // eigenvalue (Eq. 10), trace
  std::vector<double> shift_u, shift_w;                // Eq. 9-11
  std::vector<double> tic;                             // tensile-instability control: 1 or -1
  std::vector<double> density_rate, mass_rate;         // Eq. 6-7, with the shifting
  std::vector<double> exchange_x, exchange_z;          // momentum that comes with the mass
  std::vector<double> density_grad_x, density_grad_z;  // Eq. 8
  std::vector<double> sums[18];                        // of the gradient pass
  std::vector<double> viscous_ax, viscous_az;          // viscous acceleration of the last solve
  std::vector<Record> motion, state, shift;            // packed, see FluidView
  std::vector<std::int32_t> id;                        // of the particle at release

  void assign(std::span<const InitialParticle> particles);
  // Reorders the state (not what is computed from it): new particle k is old order[k].
  void permute(std::span<const std::int32_t> order);
  // Removes the particles of these ascending indices, keeping the order of the others.
  void remove(std::span<const std::int32_t> indices);
  // Brings the records of [begin, end) up to date with the arrays; the ghost's with end = n + 1.
  void pack(int begin, int end);
  void pack_motion(int begin, int end);
  void pack_state(int begin, int end);
  void pack_shift(int begin, int end);
  FluidView view() const;
  GradientSums gradient_sums();

 private:
  void set_ghost();
  std::vector<std::vector<double>*> arrays();  // all but the sums and the ids
  std::vector<double> scratch_;
  std::vector<std::int32_t> scratch_id_;
};

}  // namespace parapet::solver
