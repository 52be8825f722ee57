#include "parapet/solver/expected_cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parapet/flow/geometry.hpp"
#include "parapet/flow/rheology.hpp"
#include "parapet/flow/time_step.hpp"
#include "parapet/solver/thin_fluid.hpp"

namespace parapet::solver {
namespace {

double perimeter(const std::vector<Vec2>& outline) {
  double length = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    length += norm(outline[(k + 1) % outline.size()] - outline[k]);
  }
  return length;
}

double wall_length(const Scene& scene) {
  double length = scene.domain_length + scene.domain_height;
  for (const Barrier& barrier : scene.barriers)
    length += perimeter(barrier_outline(scene, barrier));
  for (const SolidPolygon& solid : scene.solids) length += perimeter(solid.vertices);
  return length;
}

// Most of a run is slower than the fall to the gauge, and the speed only adds to the sound's.
double usual_speed(const Scene& scene) {
  constexpr double share_of_fall = 0.25;
  return share_of_fall * std::sqrt(2.0 * scene.gravity * drop_to_gauge(scene));
}

// When the metrics are final, as far as the scene tells: twice the time of a slide without friction
// to the last gauge, and half the window of the rule. Measured: 1.1 to 1.6 s in the flume of the
// paper.
double usual_end(const Scene& scene, const RunOptions& options) {
  const bool early = options.settled.enabled && !options.until_rest;
  const double drive = scene.gravity * std::sin(scene.slope);
  if (!early || !(drive > 0.0)) return options.stop_time;
  const double gauge = scene.barriers.empty() ? scene.monitor_x : scene.barriers.back().foot_x;
  const double end = 2.0 * std::sqrt(2.0 * gauge / drive) + 0.5 * options.settled.window;
  return std::min(options.stop_time, std::max(end, options.settled.earliest_time));
}

// Whole steps cover the interval from sample to sample.
double expected_step(const Scene& scene, const Numerics& numerics, double interval) {
  const bool rk4 = numerics.integrator == Integrator::rk4_explicit;
  const bool thin = is_thin(numerics, scene.material), is_explicit = rk4 || thin;
  const double own_cfl = rk4 ? 0.6 : thin ? 0.5 : implicit_acoustic_cfl;
  // as Flow follows the flow, at the speed of its fast times
  Numerics fast = numerics;
  if (!rk4 && numerics.scheme == Scheme::corrected) {
    const double fastest = thin ? 3.5 : 2.5;  // no friction slows a thin fluid
    const double wanted = sound_over_flow * fastest * usual_speed(scene);
    fast.sound_speed =
        std::clamp(wanted, numerics.sound_speed_floor * numerics.sound_speed, numerics.sound_speed);
  }
  TimeStepInput input;
  input.smoothing_length = numerics.smoothing_ratio * numerics.spacing;
  input.max_speed = usual_speed(scene);
  input.max_acceleration = scene.gravity;
  if (is_explicit) {
    const double weight = scene.material.density * scene.gravity * std::cos(scene.slope);
    const double yield = yield_stress_under(scene.material, std::tan(scene.material.friction_angle),
                                            weight * scene.reservoir_height);
    input.max_viscosity = apparent_viscosity(scene.material, yield, 0.0, 1.0);
  }
  input.density = scene.material.density;
  input.acoustic_cfl = numerics.cfl_acoustic > 0.0 ? numerics.cfl_acoustic : own_cfl;
  return dividing_step(interval, stable_time_step(fast, input),
                       is_explicit ? 0.0 : implicit_step_excess);
}

}  // namespace

ExpectedCost expected_cost(const Scene& scene, const Numerics& given, const RunOptions& options) {
  const Numerics numerics = numerics_for(given, scene.material);
  ExpectedCost cost;
  const double dx = numerics.spacing;
  cost.particles = scene.reservoir_length * scene.reservoir_height / (dx * dx);
  const double reach = (2.0 + numerics.skin_ratio) * numerics.smoothing_ratio;  // in spacings
  const double row = std::numbers::pi * reach * reach;
  cost.neighbors = cost.particles * row;
  cost.wall_points = wall_length(scene) / dx * std::ceil(2.0 * numerics.smoothing_ratio);
  cost.samples = std::max(1.0, std::round(options.stop_time / options.series_interval));
  cost.end_time = usual_end(scene, options);
  cost.steps = cost.end_time / expected_step(scene, numerics, options.stop_time / cost.samples);
  // Measured: 14 MiB with 600 particles, 26 with 15,000, 66 with 60,000, and 33 with 15,000 whose
  // rows are 2.25 times as long (smoothing ratio 2).
  constexpr double program = 11.0 * 1024 * 1024, particle = 500.0, neighbor = 12.0, point = 300.0;
  constexpr double sample = 32.0, number = 8.0, columns = 10.0, columns_of_barrier = 7.0;
  const double row_of_series =
      sample + number * (columns + columns_of_barrier * static_cast<double>(scene.barriers.size()));
  cost.series_memory = cost.samples * row_of_series;
  cost.memory = program + particle * cost.particles + neighbor * cost.neighbors +
                point * cost.wall_points + cost.series_memory;
  return cost;
}

}  // namespace parapet::solver
