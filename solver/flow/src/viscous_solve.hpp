// Implicit viscosity: (M + dt A) u = M u* by preconditioned conjugate gradients.
#pragma once

#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/flow/neighbor_rows.hpp"
#include "parapet/flow/pass_table.hpp"
#include "parapet/flow/stage_timer.hpp"

namespace parapet::solver {

class ViscousSolve {
 public:
  struct Settings {
    double tolerance;  // largest residual of any particle, as an acceleration [m/s2]
    int max_iterations;
    int threads;
    StageTimer* timer = nullptr;
  };
  struct Outcome {
    bool converged = false;
    int iterations = 0;
  };

  // Solves for the velocity after the viscous step. `u_star`, `w_star`: velocity after all other
  // forces; `u`, `w`: start guess in, solution out; arrays are [n + 1] with the ghost at rest.
  // The matrix takes viscosity, positions and the lagged wall velocities from `arrays`.
  Outcome solve(const PassTable& passes, const FlowArrays& arrays, const Fluid& fluid,
                const std::vector<double>& u_star, const std::vector<double>& w_star,
                std::vector<double>& u, std::vector<double>& w, double dt,
                const Settings& settings);

 private:
  void resize(std::size_t n, std::size_t slots);
  ViscousView view(const Fluid& fluid, double dt);

  std::vector<double> bx_, bz_, dxx_, dxz_, dzz_, wxx_, wxz_, wzz_, rhs_x_, rhs_z_;
  std::vector<Pair> solution_, residual_, preconditioned_, direction_, image_, inverse_diagonal_,
      inverse_off_, scale_;
  std::vector<double> partial_, largest_;
};

}  // namespace parapet::solver
