#include "settled_particles.hpp"

#include <random>
#include <utility>

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::InitialParticle;

namespace {

void jitter_particles(FlowSetup& setup, double jitter) {
  std::mt19937_64 random(20240517);
  const auto offset = [&] {
    // 53 random bits, the same on every standard library
    const double unit = static_cast<double>(random() >> 11) * 0x1.0p-53;
    return (2.0 * unit - 1.0) * jitter * setup.numerics.spacing;
  };
  for (InitialParticle& p : setup.particles) {
    p.x += offset();
    p.z += offset();
  }
}

}  // namespace

void settle(FlowSetup& setup, double jitter, int steps) {
  jitter_particles(setup, jitter);
  Flow flow(setup);
  const double h = flow.smoothing_length(), length = setup.periodic_length;
  for (int step = 0; step < steps; ++step) {
    Fluid& f = flow.fluid();
    for (std::size_t i = 0; length > 0.0 && i < static_cast<std::size_t>(f.n); ++i) {
      if (f.x[i] < 0.0) f.x[i] += length;
      if (f.x[i] >= length) f.x[i] -= length;
    }
    flow.evaluate();
    const solver::GradientSumArrays sums = flow.gradient_sums();
    // about a third of the largest factor that does not overshoot
    const double factor = -0.1 * h * h;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      f.x[i] += factor * sums.view.shift_x[i];
      f.z[i] += factor * sums.view.shift_z[i];
    }
  }
  const Fluid& f = std::as_const(flow).fluid();
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    InitialParticle& p = setup.particles[static_cast<std::size_t>(f.id[i])];
    p.x = f.x[i];
    p.z = f.z[i];
  }
}

}  // namespace parapet::validation
