#include "viscous_solve.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

double sum_in_order(const std::vector<double>& partial) {
  double sum = 0.0;
  for (const double p : partial) sum += p;
  return sum;
}

}  // namespace

void ViscousSolve::resize(std::size_t n, std::size_t slots) {
  bx_.resize(slots);
  bz_.resize(slots);
  for (auto* array : {&dxx_, &dxz_, &dzz_, &wxx_, &wxz_, &wzz_, &rhs_x_, &rhs_z_}) {
    array->resize(n);
  }
  const std::size_t padded = (n + lanes) / lanes * lanes;  // the ghost at n included
  for (auto* array : {&solution_, &residual_, &preconditioned_, &direction_, &image_,
                      &inverse_diagonal_, &inverse_off_, &scale_}) {
    array->assign(padded, Pair{0.0, 0.0});
  }
  const std::size_t blocks = (n + block_size - 1) / block_size;
  partial_.resize(blocks);
  largest_.resize(blocks);
}

ViscousView ViscousSolve::view(const Fluid& fluid, double dt) {
  return {bx_.data(),  bz_.data(),  dxx_.data(),   dxz_.data(),   dzz_.data(),       wxx_.data(),
          wxz_.data(), wzz_.data(), rhs_x_.data(), rhs_z_.data(), fluid.mass.data(), dt};
}

ViscousSolve::Outcome ViscousSolve::solve(const PassTable& passes, const FlowArrays& arrays,
                                          const Fluid& fluid, const std::vector<double>& u_star,
                                          const std::vector<double>& w_star, std::vector<double>& u,
                                          std::vector<double>& w, double dt,
                                          const Settings& settings) {
  const int n = fluid.n, threads = settings.threads;
  resize(at(n), n > 0 ? at(arrays.rows.end[n - 1]) : 0);
  const ViscousView v = view(fluid, dt);
  {
    const StageScope scope(settings.timer, Stage::viscous_matrix);
    for_blocks(n, threads,
               [&](int begin, int end) { passes.viscous_matrix(arrays, v, begin, end); });
  }

  const DescentView d{solution_.data(),    residual_.data(), preconditioned_.data(),
                      direction_.data(),   image_.data(),    inverse_diagonal_.data(),
                      inverse_off_.data(), scale_.data()};
  const auto descend = [&](double step, int begin, int end) {
    const DescentSums sums = passes.descend(d, step, begin, end);
    partial_[at(begin / block_size)] = sums.product;
    largest_[at(begin / block_size)] = sums.worst;
  };
  const auto residual_error = [&] {
    double worst = 0.0;
    for (const double l : largest_) worst = !(l <= worst) ? l : worst;
    return std::sqrt(worst);
  };

  for (std::size_t i = 0; i < at(n); ++i) solution_[i] = {u[i], w[i]};
  for_blocks(n, threads, [&](int begin, int end) {
    passes.viscous_product(arrays, v, solution_.data(), image_.data(), begin, end);
    for (std::size_t i = at(begin); i < at(end); ++i) {
      residual_[i] = {fluid.mass[i] * u_star[i] + rhs_x_[i] - image_[i].x,
                      fluid.mass[i] * w_star[i] + rhs_z_[i] - image_[i].z};
      // block-Jacobi
      const double inverse = 1.0 / (dxx_[i] * dzz_[i] - dxz_[i] * dxz_[i]);
      inverse_diagonal_[i] = {inverse * dzz_[i], inverse * dxx_[i]};
      inverse_off_[i] = {-inverse * dxz_[i], -inverse * dxz_[i]};
      const double scale = 1.0 / (fluid.mass[i] * dt);
      scale_[i] = {scale * scale, scale * scale};
    }
    descend(0.0, begin, end);
    passes.turn(d, 0.0, begin, end);
  });
  double rho = sum_in_order(partial_);
  Outcome outcome;
  while (!(residual_error() <= settings.tolerance)) {
    if (outcome.iterations >= settings.max_iterations || !std::isfinite(rho)) return outcome;
    ++outcome.iterations;
    for_blocks(n, threads, [&](int begin, int end) {
      partial_[at(begin / block_size)] =
          passes.viscous_product(arrays, v, direction_.data(), image_.data(), begin, end);
    });
    const double curvature = sum_in_order(partial_);
    if (!(curvature > 0.0)) return outcome;
    const double step = rho / curvature;
    for_blocks(n, threads, [&](int begin, int end) { descend(step, begin, end); });
    const double next = sum_in_order(partial_);
    const double beta = next / rho;
    rho = next;
    for_blocks(n, threads, [&](int begin, int end) { passes.turn(d, beta, begin, end); });
  }
  for (std::size_t i = 0; i < at(n); ++i) {
    u[i] = solution_[i].x;
    w[i] = solution_[i].z;
  }
  outcome.converged = true;
  return outcome;
}

}  // namespace parapet::solver
