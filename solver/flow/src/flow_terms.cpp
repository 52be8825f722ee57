// The terms of the equations, each a loop over all particles or wall points.
#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "parapet/flow/as_published.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/flow/index.hpp"
#include "parapet/flow/rheology.hpp"
#include "parapet/flow/shifting.hpp"
#include "parapet/flow/stage_timer.hpp"
#include "parapet/solver/thin_fluid.hpp"
#include "viscous_solve.hpp"

namespace parapet::solver {
namespace {

// Spray is not stretched below rho_0 by more than this share of it, at the largest sound speed.
// Less than the compression of material at rest, and it would swell with every bounce.
constexpr double spray_stretch = 0.001;

// Shifting evens out the places like a diffusion of h u_max; kept unchanged for too long it
// overshoots. A share of dx that a particle may cover at u_max meanwhile: without a bound, runs
// that kept it for three steps went well, for four they ran away (up to 0.26 and 0.35 dx at 0.1
// c_s).
constexpr double farthest_shift = 0.15;

// Diffusivity of the masses over h u_max, the scale of the shifting (Eq. 9), whose exchange drives
// them apart: in the tank of water with a barrier they deviate by 5.0 % after 10 s without it,
// by 2.9 % with it. 0.2 leaves 2.4 %, and shortens the run-out of the thin slump by 1.4 %.
constexpr double mass_levelling = 0.05;

// A thin fluid is shifted so many times as strongly, as long as its coefficient covers no more than
// this share of dx in a step at u_max, and at least as strongly as any other. Vortices at Re 1000
// still go well with 0.34.
constexpr double thin_shifting = 3.0;
constexpr double farthest_thin_shift = 0.2;

// How many times as strong shifting is that is kept for `interval` at this speed.
double strength_of_shifting(bool thin, double covered, double spacing) {
  if (!thin) return 1.0;
  return std::clamp(farthest_thin_shift * spacing / covered, 1.0, thin_shifting);
}

}  // namespace

double Flow::smoothing_length() const {
  return setup_.numerics.smoothing_ratio * setup_.numerics.spacing;
}

bool Flow::inviscid() const {
  const Material& m = setup_.material;
  return m.yield_stress == 0.0 && m.consistency == 0.0 && m.friction_angle == 0.0;
}

bool Flow::as_published() const {
  return setup_.numerics.scheme == Scheme::as_published;
}

FlowArrays Flow::arrays() {
  pack(&Fluid::pack);
  return packed_arrays();
}

void Flow::pack(void (Fluid::*records)(int, int)) {
  for_blocks(fluid_.n, threads(), [&](int begin, int end) { (fluid_.*records)(begin, end); });
}

FlowArrays Flow::packed_arrays() {
  const Numerics& numerics = setup_.numerics;
  FlowConstants c;
  c.kernel = kernel_;
  c.smoothing_length = smoothing_length();
  c.sound_speed = now_.sound_speed;
  c.reference_density = setup_.material.density;
  c.density_diffusion = numerics.density_diffusion;
  c.gravity_x = setup_.gravity.x;
  c.gravity_z = setup_.gravity.z;
  c.periodic_length = setup_.periodic_length;
  c.even_volume = numerics.spacing * numerics.spacing;
  c.mass_diffusivity =
      numerics.shifting_factor * mass_levelling * smoothing_length() * now_.max_speed;
  c.no_slip = setup_.wall_slip == WallSlip::no_slip;
  return {c, fluid_.view(), walls_.view(), step_rows_.view(rows_)};
}

void Flow::prepare_neighbors() {
  renew_neighbors(false);
}

void Flow::renew_neighbors(bool keep_pairs) {
  const StageScope check(setup_.timer, Stage::neighbor_check);
  const bool outdated = rows_.outdated(fluid_);
  if (outdated) {
    const StageScope build(setup_.timer, Stage::neighbor_rows);
    rows_.build(fluid_, threads());
    pack(&Fluid::pack);  // the particles stand in another order now
    ++now_.statistics.neighbor_builds;
  }
  if (outdated || !keep_pairs) {
    find_reached_pairs();
  } else {
    pack(&Fluid::pack_motion);
  }
  if (!outdated || setup_.timer == nullptr) return;
  const StageScope profiling(setup_.timer, Stage::profiling);
  setup_.timer->set_pairs(count_pairs(arrays()));
}

void Flow::find_reached_pairs() {
  pack(&Fluid::pack_motion);
  step_rows_.pick(passes_, packed_arrays(), rows_, threads());
}

void Flow::update_pressure() {
  const StageScope scope(setup_.timer, Stage::equation_of_state);
  const double c2 = now_.sound_speed * now_.sound_speed;
  const double rho_0 = setup_.material.density;
  if (as_published()) {
    published_pressure(fluid_, c2, rho_0, setup_.numerics.background_pressure);
    pack(&Fluid::pack_state);
    return;
  }
  const double bulk = sound_damping * smoothing_length() * now_.sound_speed;
  const double most = setup_.numerics.sound_speed;
  const double thinnest_spray = 1.0 - spray_stretch * (most * most / c2);
  for (std::size_t i = 0; i < at(fluid_.n); ++i) {
    if (is_alone(fluid_.closeness[i])) fluid_.density[i] = rho_0;
    fluid_.pressure[i] = c2 * (fluid_.density[i] - rho_0);
    if (damps_sound_) fluid_.pressure[i] += bulk * fluid_.density_rate[i];
    if (is_spray(fluid_.lambda[i]) && fluid_.pressure[i] < 0.0) {
      fluid_.pressure[i] = 0.0;
      fluid_.density[i] = std::max(fluid_.density[i], thinnest_spray * rho_0);
    } else if (damps_sound_ && fluid_.pressure[i] < 0.0 && rows_.valid() &&
               rows_.touches_wall(static_cast<int>(i))) {
      fluid_.pressure[i] = 0.0;
    }
    fluid_.volume[i] = fluid_.mass[i] / fluid_.density[i];
  }
  pack(&Fluid::pack_state);
}

void Flow::extrapolate_walls() {
  const StageScope scope(setup_.timer, Stage::wall_boundary);
  pack(&Fluid::pack_motion);
  const FlowArrays a = packed_arrays();
  for_blocks(a.rows.n_active, threads(),
             [&](int begin, int end) { passes_.extrapolate_walls(a, begin, end); });
}

void Flow::update_gradients(double interval) {
  const StageScope scope(setup_.timer, Stage::gradients);
  const FlowArrays a = packed_arrays();
  const double stable = farthest_shift * setup_.numerics.spacing;
  const double covered = interval * now_.max_speed;
  const bool too_far = covered > stable;
  const double strength =
      strength_of_shifting(thin_, too_far ? stable : covered, setup_.numerics.spacing);
  const ShiftingSettings settings{smoothing_length(),
                                  too_far ? stable / interval : now_.max_speed,
                                  strength * setup_.numerics.shifting_factor,
                                  a.constants.no_slip,
                                  setup_.numerics.background_pressure,
                                  still_rate2(setup_.material)};
  const auto finish = as_published() ? finish_published_gradients : finish_gradients;
  for_blocks(fluid_.n, threads(), [&](int begin, int end) {
    const GradientSumArrays sums(end - begin);
    passes_.gradient_sums(a, sums.view, begin, end);
    finish(fluid_, sums.view, settings, setup_.material, begin, end);
  });
  if (as_published()) {
    for_blocks(fluid_.n, threads(),
               [&](int begin, int end) { project_shift_at_surface(fluid_, a, begin, end); });
  }
  // only now: meanwhile other particles were looking at the old viscosities
  pack(&Fluid::pack_state);
  pack(&Fluid::pack_shift);
}

GradientSumArrays Flow::gradient_sums() {
  GradientSumArrays sums(fluid_.n);
  passes_.gradient_sums(arrays(), sums.view, 0, fluid_.n);
  return sums;
}

void Flow::add_body_and_pressure_force(std::vector<double>& ax, std::vector<double>& az) {
  const StageScope scope(setup_.timer, Stage::pressure_force);
  const FlowArrays a = packed_arrays();
  for_blocks(fluid_.n, threads(), [&](int begin, int end) {
    passes_.pressure_force(a, ax.data(), az.data(), begin, end);
    for (std::size_t i = at(begin); i < at(end); ++i) {
      ax[i] += setup_.gravity.x - setup_.central_force * fluid_.x[i];
      az[i] += setup_.gravity.z - setup_.central_force * fluid_.z[i];
    }
  });
}

void Flow::add_viscous_force(std::vector<double>& ax, std::vector<double>& az) {
  const StageScope scope(setup_.timer, Stage::viscous_force);
  const FlowArrays a = packed_arrays();
  for_blocks(fluid_.n, threads(), [&](int begin, int end) {
    passes_.viscous_force(a, ax.data(), az.data(), begin, end);
  });
}

bool Flow::solve_viscosity(const std::vector<double>& u_star, const std::vector<double>& w_star,
                           std::vector<double>& u, std::vector<double>& w, double dt) {
  const StageScope scope(setup_.timer, Stage::conjugate_gradients);
  const ViscousSolve::Settings settings{setup_.numerics.cg_tolerance,
                                        setup_.numerics.cg_max_iterations, threads(), setup_.timer};
  const auto outcome =
      viscous_->solve(passes_, packed_arrays(), fluid_, u_star, w_star, u, w, dt, settings);
  pack(&Fluid::pack_motion);
  now_.statistics.cg_iterations += outcome.iterations;
  if (setup_.timer) setup_.timer->add_visits(Stage::conjugate_gradients, outcome.iterations);
  return outcome.converged;
}

void Flow::update_density_rate() {
  const StageScope scope(setup_.timer, Stage::density_rate);
  pack(&Fluid::pack_motion);
  const FlowArrays a = packed_arrays();
  const ShiftedRates rates = fluid_.rates();
  for_blocks(fluid_.n, threads(),
             [&](int begin, int end) { passes_.density_rate(a, rates, begin, end); });
}

void Flow::evaluate() {
  prepare_neighbors();
  update_pressure();
  extrapolate_walls();
  update_gradients(0.0);
}

// Looking must not change what comes: the densities that update_pressure limits stay as they are,
// for the step would scale them first where the sound speed follows the flow.
void Flow::refresh() {
  const std::vector<double> density = fluid_.density;
  update_pressure();
  if (now_.statistics.steps == 0) {
    evaluate();
  } else {
    fluid_.density = density;
  }
}

}  // namespace parapet::solver
