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

void ViscousSolve::resize(const FlowArrays& arrays) {
  const int n = arrays.fluid.n;
  begin_.clear();
  std::int32_t slots = 0;
  for (std::size_t g = 0; g < at(groups_of(n)); ++g) {
    begin_.push_back(slots);
    slots += arrays.rows.wall_begin[g] - arrays.rows.begin[g];
  }
  strength_.resize(at(slots));
  for (auto* array : {&wxx_, &wxz_, &wzz_, &dxx_, &dxz_, &dzz_, &residual_x_, &residual_z_,
                      &image_x_, &image_z_, &scale_}) {
    array->resize(at(n));
  }
  const std::size_t blocks = at((n + block_size - 1) / block_size);
  partial_.resize(blocks);
  largest_.resize(blocks);
}

ViscousSolve::Outcome ViscousSolve::solve(const PassTable& passes, const FlowArrays& arrays,
                                          Fluid& fluid, const std::vector<double>& u_star,
                                          const std::vector<double>& w_star, std::vector<double>& u,
                                          std::vector<double>& w, double dt,
                                          const Settings& settings) {
  const int n = fluid.n, threads = settings.threads;
  resize(arrays);
  // the matrix leaves the walls' part of the right-hand side where the residual will be
  const ViscousView v{strength_.data(),   begin_.data(),      wxx_.data(), wxz_.data(),
                      wzz_.data(),        dxx_.data(),        dxz_.data(), dzz_.data(),
                      residual_x_.data(), residual_z_.data(), dt};
  {
    const StageScope scope(settings.timer, Stage::viscous_matrix);
    for_blocks(n, threads,
               [&](int begin, int end) { passes.viscous_matrix(arrays, v, begin, end); });
  }

  const DescentView d{u.data(),           w.data(),        fluid.motion.data(), residual_x_.data(),
                      residual_z_.data(), image_x_.data(), image_z_.data(),
                      dxx_.data(),  // from now on the inverse
                      dxz_.data(),        dzz_.data(),     scale_.data()};
  const auto product = [&](int begin, int end) {
    return passes.viscous_product(arrays, v, fluid.motion.data(), image_x_.data(), image_z_.data(),
                                  begin, end);
  };
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

  for (std::size_t i = 0; i < at(n); ++i) {
    fluid.motion[i].u = u[i];
    fluid.motion[i].w = w[i];
  }
  for_blocks(n, threads, [&](int begin, int end) {
    product(begin, end);
    for (std::size_t i = at(begin); i < at(end); ++i) {
      const double mass = fluid.mass[i];
      residual_x_[i] += mass * u_star[i] - image_x_[i];
      residual_z_[i] += mass * w_star[i] - image_z_[i];
      // block-Jacobi
      const double inverse = 1.0 / (dxx_[i] * dzz_[i] - dxz_[i] * dxz_[i]);
      const double xx = dxx_[i];
      dxx_[i] = inverse * dzz_[i];
      dxz_[i] = -inverse * dxz_[i];
      dzz_[i] = inverse * xx;
      scale_[i] = 1.0 / (mass * dt * mass * dt);
    }
  });
  for_blocks(n, threads, [&](int begin, int end) {
    descend(0.0, begin, end);
    passes.turn(d, 0.0, begin, end);
  });
  double rho = sum_in_order(partial_);
  Outcome outcome;
  while (!(residual_error() <= settings.tolerance)) {
    if (outcome.iterations >= settings.max_iterations || !std::isfinite(rho)) return outcome;
    ++outcome.iterations;
    for_blocks(n, threads,
               [&](int begin, int end) { partial_[at(begin / block_size)] = product(begin, end); });
    const double curvature = sum_in_order(partial_);
    if (!(curvature > 0.0)) return outcome;
    const double step = rho / curvature;
    for_blocks(n, threads, [&](int begin, int end) { descend(step, begin, end); });
    const double next = sum_in_order(partial_);
    const double beta = next / rho;
    rho = next;
    for_blocks(n, threads, [&](int begin, int end) { passes.turn(d, beta, begin, end); });
  }
  outcome.converged = true;
  return outcome;
}

}  // namespace parapet::solver
