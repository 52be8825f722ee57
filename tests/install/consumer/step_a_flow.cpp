// A pool of debris at rest between walls, stepped with the installed particles: it must keep its
// mass, stay where it is and weigh on its bed.
#include <cmath>
#include <cstdio>

#include "parapet/flow/pairs.hpp"
#include "parapet/flow/totals.hpp"
#include "parapet/flow/walls.hpp"

int main() {
  using namespace parapet::solver;
  FlowSetup setup;
  setup.numerics.spacing = 0.02;
  setup.numerics.sound_speed = 15.0;
  setup.gravity = {0.0, -9.81};
  setup.particles = lattice_block(0.0, 0.0, 0.4, 0.1, 0.02, setup.material.density);
  add_wall(setup, {0.0, 0.0}, {0.4, 0.0});
  add_wall(setup, {0.0, 0.5}, {0.0, 0.0});
  add_wall(setup, {0.4, 0.0}, {0.4, 0.5});
  measure_all_walls(setup);

  Flow flow(setup);
  const Totals start = totals(flow);
  Vec2 impulse;
  while (flow.time() < 0.2) {
    if (const auto failure = flow.step(0.2 - flow.time())) {
      std::printf("%s\n", failure->reason.c_str());
      return 1;
    }
    for (const BarrierImpulse& felt : flow.take_impulses()) impulse = impulse + felt.force;
  }
  flow.evaluate();
  double sum = 0.0;  // of W V over the neighbours, mean over the particles
  const Kernel kernel = make_kernel(flow.smoothing_length(), setup.numerics.spacing);
  for_each_pair(flow, [&](std::size_t, std::size_t j, Vec2, double r) {
    sum += kernel.alpha * kernel_shape(r * kernel.inverse_h) * flow.fluid().volume[j];
  });
  sum /= flow.fluid().n;
  const Totals end = totals(flow);
  const double weight = 9.81 * start.mass;
  std::printf("%lld steps, mass %.6f kg/m, load %.3f of the weight, sum W V %.2f\n",
              static_cast<long long>(flow.statistics().steps), end.mass,
              -impulse.z / (0.2 * weight), sum);
  return std::abs(end.mass - start.mass) < 1e-9 && std::abs(-impulse.z / (0.2 * weight) - 1.0) < 0.1
             ? 0
             : 1;
}
