// The sums of the scheme against the fields and derivatives that they stand for, with the solver's
// own passes: the kernel's unity, renormalised gradients of linear fields, the density diffusion of
// a hydrostatic column, and the viscous force against div(2 eta S) of a manufactured flow with
// constant, varying and Herschel-Bulkley viscosity (viscous_operator.cpp). The last settles what
// Eq. 6 of the source paper leaves open: alpha = 8 belongs to the pair term (u_ij . r_ij) grad
// W/r^2; with the printed (r_ij . grad W) u_ij/r^2 the same alpha makes the fluid four times too
// viscous.
#include "operators.hpp"

#include <fmt/format.h>

#include <string>
#include <tuple>
#include <utility>

#include "cases.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/flow/kernel.hpp"
#include "parapet/flow/pairs.hpp"
#include "settled_particles.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::InitialParticle;
using solver::Vec2;

FlowSetup operator_block(int across, double smoothing, bool settled) {
  FlowSetup setup;
  const double dx = operator_side / across, margin = std::ceil(3.0 * smoothing + 2.0) * dx;
  setup.numerics.spacing = dx;
  setup.numerics.smoothing_ratio = smoothing;
  setup.material.density = 1000.0;
  setup.material.yield_stress = 0.0;
  setup.material.flow_index = 1.0;
  setup.material.consistency = 1.0;
  setup.wall_slip = solver::WallSlip::free_slip;
  setup.periodic_length = operator_side;
  if (settled) {
    add_periodic_wall(setup, operator_side, -margin, true);
    add_periodic_wall(setup, operator_side, operator_side + margin, false);
  }
  setup.particles = solver::lattice_block(0.0, -margin, operator_side, operator_side + 2.0 * margin,
                                          dx, setup.material.density);
  if (settled) settle(setup);
  return setup;
}

namespace {

struct Unity {
  double sum = 0.0;       // rms of sum W V - 1
  double gradient = 0.0;  // rms of h |sum grad W V|
  double moment = 0.0;    // rms of the entries of B - 1
};

Unity unity(int across, double smoothing, bool settled) {
  Flow flow(operator_block(across, smoothing, settled));
  flow.evaluate();
  const Fluid& f = std::as_const(flow).fluid();
  const double h = flow.smoothing_length();
  const solver::Kernel kernel = solver::make_kernel(h, operator_side / across);
  std::vector<double> sum(f.x.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = kernel.alpha * f.volume[i];
  std::vector<Vec2> gradient(sum.size());
  for_each_pair(flow, [&](std::size_t i, std::size_t j, Vec2 r_ij, double r) {
    sum[i] += kernel.alpha * solver::kernel_shape(r / h) * f.volume[j];
    const double falloff = std::max(1.0 - 0.5 * r / h, 0.0);
    const double factor = -kernel.f_scale * falloff * falloff * falloff * f.volume[j];
    gradient[i] = gradient[i] + factor * r_ij;
  });
  const solver::GradientSumArrays sums = flow.gradient_sums();
  const solver::GradientSums& s = sums.view;
  return {rms(f, [&](std::size_t i) { return sum[i] - 1.0; }),
          h * rms(f, [&](std::size_t i) { return norm(gradient[i]); }), rms(f, [&](std::size_t i) {
            return std::hypot(s.bxx[i] - 1.0, s.bxz[i], s.bzz[i] - 1.0);
          })};
}

// Integral of W over its support, by the trapezoidal rule in r.
double kernel_integral() {
  const solver::Kernel k = solver::make_kernel(1.0, 0.75);
  constexpr int steps = 4000;
  double sum = 0.0;
  for (int i = 1; i < steps; ++i) {
    const double r = 2.0 * i / steps;
    sum += k.alpha * solver::kernel_shape(r) * 2.0 * std::numbers::pi * r * 2.0 / steps;
  }
  return sum;
}

void add_unity(CaseRun& run) {
  run.add({.key = "kernel_integral",
           .what = "integral of the kernel less 1",
           .value = kernel_integral() - 1.0,
           .lower = -1e-6,
           .upper = 1e-6,
           .reason = "normalised; the rest is the error of the quadrature with 4000 steps"});
  const Unity lattice = unity(32, 1.33, false), settled = unity(32, 1.33, true);
  for (const auto& [u, key, where] : {std::tuple{lattice, "lattice", "square lattice"},
                                      {settled, "settled", "settled particles"}}) {
    run.add({.key = fmt::format("unity_{}", key),
             .what = fmt::format("{}, h = 1.33 dx: sum W V less 1, rms", where),
             .value = 100.0 * u.sum,
             .unit = "%",
             .upper = 2.0,
             .reason = "a sixth of the weight of one neighbour, 12 %"});
    run.add({.key = fmt::format("unity_gradient_{}", key),
             .what = fmt::format("{}: h times sum grad W V, rms", where),
             .value = 100.0 * u.gradient,
             .unit = "%"});
    run.add({.key = fmt::format("moment_{}", key),
             .what = fmt::format("{}: first moments B less the unit tensor, rms", where),
             .value = 100.0 * u.moment,
             .unit = "%"});
  }
  // towards the integral: more neighbours, the same support
  std::vector<double> ratio{1.0, 1.33, 2.0, 2.66, 4.0}, inverse, error;
  for (const double h : ratio) {
    inverse.push_back(1.0 / h);
    error.push_back(unity(24, h, false).sum);
  }
  run.add({.key = "unity_order",
           .what = "square lattice: order of sum W V - 1 in dx/h, h/dx from 1 to 4",
           .value = fitted_order(inverse, error),
           .lower = 4.5,
           .reason = "the kernel's spectrum falls with the fifth power of the wave number"});
}

// Settled particles with free surfaces all around.
FlowSetup free_block(int across) {
  FlowSetup setup = operator_block(across, 1.33, true);
  setup.solids = {};
  setup.periodic_length = 0.0;
  return setup;
}

void add_linear_fields(CaseRun& run, int across) {
  FlowSetup setup = free_block(across);
  for (InitialParticle& p : setup.particles) {
    p.density += 30.0 * p.x - 20.0 * p.z;
    p.u = 2.0 * p.x + 3.0 * p.z;
    p.w = 5.0 * p.x - 2.0 * p.z;
  }
  Flow flow(std::move(setup));
  flow.evaluate();
  const Fluid& f = std::as_const(flow).fluid();
  const double exact = std::sqrt(80.0);  // 2 S:S = 2 (4 + 4) + (3 + 5)^2
  double gradient = 0.0, shear = 0.0;
  const double inside = 4.0 * flow.smoothing_length();
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    gradient =
        std::max(gradient, std::hypot(f.density_grad_x[i] - 30.0, f.density_grad_z[i] + 20.0));
    if (looked_at(f, i) && std::min(f.x[i], operator_side - f.x[i]) > inside)
      shear = std::max(shear, std::abs(f.shear_rate[i] / exact - 1.0));
  }
  run.add({.key = "linear_density",
           .what = "settled particles and free surfaces: largest error of the gradient of a linear "
                   "density, over the gradient",
           .value = gradient / std::hypot(30.0, 20.0),
           .upper = 1e-9,
           .reason = "exact by construction of Eq. 8; rounding of densities near 1000"});
  run.add(
      {.key = "linear_velocity",
       .what = "settled particles, inside: largest error of the shear rate of a linear flow",
       .value = 100.0 * shear,
       .unit = "%",
       .upper = 1.0,
       .reason =
           "exact where the support is complete; the scheme treats it as complete from 97 % on"});
}

void add_density_diffusion(CaseRun& run, int across) {
  FlowSetup setup = free_block(across);
  for (InitialParticle& p : setup.particles) p.density += 20.0 * (operator_side - p.z);
  Flow flow(std::move(setup));
  flow.evaluate();
  Fluid& f = flow.fluid();
  flow.update_density_rate();
  const std::vector<double> rate = f.density_rate;
  std::fill(f.density_grad_x.begin(), f.density_grad_x.end(), 0.0);
  std::fill(f.density_grad_z.begin(), f.density_grad_z.end(), 0.0);
  f.pack(0, f.n);  // the sums read the neighbours' gradients from the records
  flow.update_density_rate();
  const std::vector<double>& plain = f.density_rate;
  double largest = 0.0, largest_plain = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    largest = std::max(largest, std::abs(rate[i]));
    largest_plain = std::max(largest_plain, std::abs(plain[i]));
  }
  run.add({.key = "hydrostatic",
           .what = "hydrostatic density, settled particles and free surfaces: largest density "
                   "diffusion over that without the gradients of Eq. 7",
           .value = largest / largest_plain,
           .upper = 1e-9,
           .reason = "zero for linear densities by construction of Eq. 7; rounding"});
}

void add_gradient_order(CaseRun& run, const std::vector<int>& across) {
  std::vector<double> dx, error;
  for (const int n : across) {
    FlowSetup setup = operator_block(n, 1.33, true);
    for (InitialParticle& p : setup.particles)
      p.density += std::sin(operator_wave * p.x) * std::cos(operator_wave * p.z);
    Flow flow(std::move(setup));
    flow.evaluate();
    const Fluid& f = std::as_const(flow).fluid();
    dx.push_back(operator_side / n);
    error.push_back(rms(f,
                        [&](std::size_t i) {
                          const double x = operator_wave * f.x[i], z = operator_wave * f.z[i];
                          return std::hypot(
                              f.density_grad_x[i] - operator_wave * std::cos(x) * std::cos(z),
                              f.density_grad_z[i] + operator_wave * std::sin(x) * std::sin(z));
                        }) /
                    (operator_wave * std::numbers::sqrt2 / 2.0));
  }
  run.add({.key = "gradient",
           .what = fmt::format("settled particles, {} across: gradient of a density wave of length "
                               "L, relative L2 error",
                               across.back()),
           .value = 100.0 * error.back(),
           .unit = "%"});
  run.add({.key = "gradient_order",
           .what = "order of that error over the spacings",
           .value = fitted_order(dx, error),
           .lower = 0.9,
           .reason = "exact for linear fields, so first order on any particles"});
}

}  // namespace

void operators(CaseRun& run) {
  const std::vector<int> across = run.full() ? std::vector{16, 32, 64, 128} : std::vector{16, 32};
  run.alone([&] {
    add_unity(run);
    add_linear_fields(run, 32);
    add_density_diffusion(run, 32);
    add_gradient_order(run, across);
  });
  add_viscous_operator(run, across);
}

}  // namespace parapet::validation
