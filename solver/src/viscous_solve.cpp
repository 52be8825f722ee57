#include "viscous_solve.hpp"

#include <algorithm>
#include <cmath>

#include "index.hpp"
#include "parallel.hpp"

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
  for (auto* array : {&dxx_, &dxz_, &dzz_, &wxx_, &wxz_, &wzz_, &rhs_x_, &rhs_z_, &rx_, &rz_, &yx_,
                      &yz_, &sx_, &sz_}) {
    array->resize(n);
  }
  px_.assign(n + 1, 0.0);
  pz_.assign(n + 1, 0.0);
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

  // Block-Jacobi: z = D^-1 r; returns the partial sums of r.z and the largest acceleration error.
  const auto precondition = [&](int begin, int end) {
    double product = 0.0, worst = 0.0;
    for (std::size_t i = at(begin); i < at(end); ++i) {
      const double inverse = 1.0 / (dxx_[i] * dzz_[i] - dxz_[i] * dxz_[i]);
      sx_[i] = inverse * (dzz_[i] * rx_[i] - dxz_[i] * rz_[i]);
      sz_[i] = inverse * (dxx_[i] * rz_[i] - dxz_[i] * rx_[i]);
      product += rx_[i] * sx_[i] + rz_[i] * sz_[i];
      const double scale = 1.0 / (fluid.mass[i] * dt);
      worst = std::max(worst, (rx_[i] * rx_[i] + rz_[i] * rz_[i]) * (scale * scale));
    }
    partial_[at(begin / block_size)] = product;
    largest_[at(begin / block_size)] = worst;
  };
  const auto residual_error = [&] {
    double worst = 0.0;
    for (const double l : largest_) worst = std::max(worst, l);
    return std::sqrt(worst);
  };

  for_blocks(n, threads, [&](int begin, int end) {
    passes.viscous_product(arrays, v, u.data(), w.data(), yx_.data(), yz_.data(), begin, end);
    for (std::size_t i = at(begin); i < at(end); ++i) {
      rx_[i] = fluid.mass[i] * u_star[i] + rhs_x_[i] - yx_[i];
      rz_[i] = fluid.mass[i] * w_star[i] + rhs_z_[i] - yz_[i];
    }
    precondition(begin, end);
    std::copy_n(sx_.begin() + begin, end - begin, px_.begin() + begin);
    std::copy_n(sz_.begin() + begin, end - begin, pz_.begin() + begin);
  });
  double rho = sum_in_order(partial_);
  Outcome outcome;
  while (!(residual_error() <= settings.tolerance)) {
    if (outcome.iterations >= settings.max_iterations || !std::isfinite(rho)) return outcome;
    ++outcome.iterations;
    for_blocks(n, threads, [&](int begin, int end) {
      passes.viscous_product(arrays, v, px_.data(), pz_.data(), yx_.data(), yz_.data(), begin, end);
      double product = 0.0;
      for (std::size_t i = at(begin); i < at(end); ++i) {
        product += px_[i] * yx_[i] + pz_[i] * yz_[i];
      }
      partial_[at(begin / block_size)] = product;
    });
    const double curvature = sum_in_order(partial_);
    if (!(curvature > 0.0)) return outcome;
    const double step = rho / curvature;
    for_blocks(n, threads, [&](int begin, int end) {
      for (std::size_t i = at(begin); i < at(end); ++i) {
        u[i] += step * px_[i];
        w[i] += step * pz_[i];
        rx_[i] -= step * yx_[i];
        rz_[i] -= step * yz_[i];
      }
      precondition(begin, end);
    });
    const double next = sum_in_order(partial_);
    const double beta = next / rho;
    rho = next;
    for_blocks(n, threads, [&](int begin, int end) {
      for (std::size_t i = at(begin); i < at(end); ++i) {
        px_[i] = sx_[i] + beta * px_[i];
        pz_[i] = sz_[i] + beta * pz_[i];
      }
    });
  }
  outcome.converged = true;
  return outcome;
}

}  // namespace parapet::solver
