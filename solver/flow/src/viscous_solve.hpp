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
  // The matrix takes viscosity, positions and the lagged wall velocities from `arrays`. The fluid's
  // motion records hold the search direction, whose places the product needs beside it: they are to
  // be packed again.
  Outcome solve(const PassTable& passes, const FlowArrays& arrays, Fluid& fluid,
                const std::vector<double>& u_star, const std::vector<double>& w_star,
                std::vector<double>& u, std::vector<double>& w, double dt,
                const Settings& settings);

 private:
  void resize(const FlowArrays& arrays);

  std::vector<float> strength_;
  std::vector<std::int32_t> begin_;  // [groups]
  std::vector<double> wxx_, wxz_, wzz_, dxx_, dxz_, dzz_, residual_x_, residual_z_, image_x_,
      image_z_, scale_;
  std::vector<double> partial_, largest_;
};

}  // namespace parapet::solver
