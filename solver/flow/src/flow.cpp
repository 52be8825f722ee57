#include "parapet/flow/flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "parapet/flow/index.hpp"
#include "parapet/flow/rheology.hpp"
#include "parapet/flow/shifting.hpp"
#include "parapet/flow/stage_timer.hpp"
#include "parapet/flow/time_step.hpp"
#include "parapet/solver/thin_fluid.hpp"
#include "time_integrator.hpp"
#include "viscous_solve.hpp"

namespace parapet::solver {
namespace {

// |rho/rho_0 - 1| beyond this is no longer this fluid. A jet that closes a corner is compressed by
// a quarter for a millisecond (impact speed over sound speed, reflected from both walls).
constexpr double density_limit = 0.5;

constexpr double speed_limit = 0.5;      // of the sound speed: weak compressibility is lost
constexpr double shortest_step = 1e-10;  // [s]

// Fluid is seen around a corner of a solid within so many spacings of it. In tanks of water with
// plates of 0.5 to 2 dx the largest speeds fall from one spacing to 1.5, and do not change much
// beyond.
constexpr double around_corners = 1.5;

constexpr double kept_share = 0.95;  // a sound speed is kept until one below this share will do

FlowSetup checked(FlowSetup setup) {
  std::string text;
  for (const std::string& error : setup_errors(setup)) text += (text.empty() ? "" : "; ") + error;
  if (!text.empty()) throw std::invalid_argument(text);
  setup.numerics = numerics_for(setup.numerics, setup.material);
  return setup;
}

std::unique_ptr<TimeIntegrator> integrator_for(const Numerics& numerics, bool thin) {
  if (numerics.integrator == Integrator::rk4_explicit) return make_rk4_explicit();
  return thin ? make_midpoint() : make_implicit_viscosity(numerics.steps_per_solve);
}

}  // namespace

Flow::Flow(FlowSetup setup)
    : setup_(checked(std::move(setup))),
      thin_(is_thin(setup_.numerics, setup_.material)),
      damps_sound_(damps_sound(setup_.numerics, setup_.material)),
      passes_(setup_.passes ? *setup_.passes : best_passes(setup_.numerics.scheme)),
      walls_(lay_out_walls(setup_.solids, setup_.numerics.spacing, 2.0 * smoothing_length())),
      rows_(setup_.solids, walls_, 2.0 * smoothing_length(),
            setup_.numerics.skin_ratio * smoothing_length(),
            as_published() ? 0.0 : around_corners * setup_.numerics.spacing, setup_.periodic_length,
            &passes_),
      viscous_(std::make_unique<ViscousSolve>()),
      integrator_(integrator_for(setup_.numerics, thin_)),
      impulses_(at(setup_.n_barriers)) {
  int strips = 0;
  for (const LoadAxis& axis : setup_.load_axes) {
    first_strip_.push_back(strips);
    strips += axis.strips(setup_.numerics.spacing);
  }
  strip_impulses_.resize(at(strips));
  kernel_ = make_kernel(smoothing_length(), setup_.numerics.spacing);
  if (!as_published()) kernel_.f_scale /= lattice_moment(kernel_, setup_.numerics.spacing);
  now_.sound_speed =
      setup_.start_sound_speed > 0.0 ? setup_.start_sound_speed : setup_.numerics.sound_speed;
  fluid_.assign(setup_.particles);
  for (const InitialParticle& p : setup_.particles) released_mass_ += p.mass;
  std::vector<InitialParticle>().swap(setup_.particles);  // the fluid has them now
  const std::size_t n = walls_.size();
  first_barrier_point_ = static_cast<int>(n);
  for (std::size_t k = n; k-- > 0;) {
    if (setup_.solids.faces[at(walls_.owner[k])].barrier >= 0) {
      first_barrier_point_ = static_cast<int>(k);
    }
  }
  now_.max_acceleration = norm(setup_.gravity);
}

Flow::~Flow() = default;

bool Flow::takes_over_pairs() const {
  return integrator_->keeps_pairs() && now_.statistics.steps % 2 != 0;
}

FlowState Flow::state() const {
  FlowState state{now_, integrator_->clock(), departures_, fluid_.compact(), {}, {}, {}, {}};
  if (rows_.valid()) {
    state.built_x = rows_.built_x();
    state.built_z = rows_.built_z();
    if (takes_over_pairs()) {
      state.picked_x = x_before_;
      state.picked_z = z_before_;
    }
  }
  return state;
}

void Flow::resume(const FlowState& state) {
  now_ = state.progress;
  departures_ = state.departures;
  integrator_->set_clock(state.clock);
  fluid_ = state.fluid;
  fluid_.expand();
  rows_.invalidate();
  if (state.built_x.empty()) return;
  // The rows as they were: built where the particles stood then, which leaves them in their order.
  std::vector<double> x = fluid_.x, z = fluid_.z;
  const auto place = [&](const std::vector<double>& at_x, const std::vector<double>& at_z) {
    std::copy(at_x.begin(), at_x.end(), fluid_.x.begin());
    std::copy(at_z.begin(), at_z.end(), fluid_.z.begin());
  };
  place(state.built_x, state.built_z);
  rows_.build(fluid_, threads());
  if (!state.picked_x.empty()) {
    place(state.picked_x, state.picked_z);
    find_reached_pairs();
  }
  fluid_.x = std::move(x);
  fluid_.z = std::move(z);
  pack(&Fluid::pack);
}

std::optional<Failure> Flow::check_state() {
  const double rho_0 = setup_.material.density;
  double speed2 = 0.0, flow_speed2 = 0.0, compression = 0.0;
  bool finite = true;
  for (std::size_t i = 0; i < at(fluid_.n); ++i) {
    const double s2 = fluid_.u[i] * fluid_.u[i] + fluid_.w[i] * fluid_.w[i];
    speed2 = std::max(speed2, s2);
    if (!is_spray(fluid_.lambda[i])) flow_speed2 = std::max(flow_speed2, s2);
    compression = std::max(compression, std::abs(fluid_.density[i] / rho_0 - 1.0));
    finite = finite && std::isfinite(s2 + fluid_.density[i] + fluid_.x[i] + fluid_.z[i]);
  }
  now_.max_speed = std::sqrt(speed2);
  now_.flow_speed = std::sqrt(flow_speed2);
  if (!finite) return Failure{StopReason::not_a_number, "a particle's state is not a number"};
  now_.statistics.max_speed = std::max(now_.statistics.max_speed, now_.max_speed);
  now_.statistics.max_density_error = std::max(now_.statistics.max_density_error, compression);
  if (now_.max_speed > speed_limit * setup_.numerics.sound_speed) {
    return Failure{StopReason::runaway_speed, "a particle moves at " +
                                                  std::to_string(now_.max_speed) +
                                                  " m/s, more than half the sound speed"};
  }
  if (compression > density_limit) {
    return Failure{StopReason::density_range, "a density is " +
                                                  std::to_string(100.0 * compression) +
                                                  " % away from the reference density"};
  }
  return std::nullopt;
}

// Slow flows need no fast sound. The pressures stay as they are, so the densities change.
void Flow::follow_flow() {
  const double most = setup_.numerics.sound_speed;
  const double least = setup_.numerics.sound_speed_floor * most;
  const double wanted = std::clamp(sound_over_flow * now_.flow_speed, least, most);
  const bool enough = wanted <= now_.sound_speed;
  if (enough && wanted > kept_share * now_.sound_speed && wanted > least) return;
  if (wanted == now_.sound_speed) return;
  const double stretch = (now_.sound_speed * now_.sound_speed) / (wanted * wanted);
  const double rho_0 = setup_.material.density;
  for (std::size_t i = 0; i < at(fluid_.n); ++i) {
    fluid_.density[i] = rho_0 + stretch * (fluid_.density[i] - rho_0);
    fluid_.density_grad_x[i] *= stretch;
    fluid_.density_grad_z[i] *= stretch;
  }
  pack(&Fluid::pack_shift);
  now_.sound_speed = wanted;
}

void Flow::remove_departed() {
  std::vector<std::int32_t> leaving;
  for (int i = 0; i < fluid_.n; ++i) {
    const auto k = at(i);
    if (setup_.periodic_length > 0.0) {
      if (fluid_.x[k] < 0.0) fluid_.x[k] += setup_.periodic_length;
      if (fluid_.x[k] >= setup_.periodic_length) fluid_.x[k] -= setup_.periodic_length;
    }
    if (fluid_.x[k] > setup_.outlet_x || fluid_.z[k] > setup_.ceiling_z) {
      leaving.push_back(i);
      departures_.push_back({fluid_.id[k], fluid_.mass[k], fluid_.x[k]});
      now_.left_mass += fluid_.mass[k];
    }
  }
  if (leaving.empty()) return;
  fluid_.remove(leaving);
  rows_.invalidate();
}

std::optional<Failure> Flow::step(double longest) {
  const StageScope scope(setup_.timer, Stage::step_control);
  if (now_.statistics.steps == 0) {
    update_pressure();
    if (auto failure = check_state()) return failure;
  }
  if (setup_.adapt_sound_speed) follow_flow();
  renew_neighbors(takes_over_pairs());
  update_pressure();
  double max_viscosity = 0.0;
  if (integrator_->explicit_viscosity() && !inviscid()) {
    // thinning debris is thickest at rest, thickening debris where it shears most
    const Material& m = setup_.material;
    double pressure = 0.0;
    if (m.friction_angle > 0.0) {
      for (const double p : fluid_.pressure) pressure = std::max(pressure, p);
    }
    const double yield = yield_stress_under(m, std::tan(m.friction_angle), pressure);
    max_viscosity = apparent_viscosity(m, yield, 0.0, 1.0);
    for (const double eta : fluid_.pair_viscosity) max_viscosity = std::max(max_viscosity, eta);
  }
  const double own_cfl = integrator_->default_acoustic_cfl();
  const double cfl = setup_.numerics.cfl_acoustic > 0.0 ? setup_.numerics.cfl_acoustic : own_cfl;
  const TimeStepInput input{smoothing_length(), now_.max_speed,          now_.max_acceleration,
                            max_viscosity,      setup_.material.density, cfl};
  Numerics numerics = setup_.numerics;
  numerics.sound_speed = now_.sound_speed;
  const double stable = stable_time_step(numerics, input);
  if (!(stable > shortest_step)) {
    return Failure{StopReason::time_step_collapse,
                   "the stable time step fell to " + std::to_string(stable) + " s"};
  }
  // samples fall on their times; who asks for longer steps than usual gets none that exceed them
  const double dt =
      dividing_step(longest, stable, cfl > own_cfl ? 0.0 : integrator_->most_excess());
  if (setup_.timer) {
    setup_.timer->count_step(deciding_limit(numerics, input), dt, stable);
  }
  x_before_ = fluid_.x;
  z_before_ = fluid_.z;
  const std::vector<double>& u = fluid_.u;
  const std::vector<double>& w = fluid_.w;
  u_before_ = u;
  w_before_ = w;
  {
    const StageScope advance(setup_.timer, Stage::integrate);
    if (auto failure = integrator_->advance(*this, dt)) return failure;
  }
  stop_at_walls();
  if (auto failure = check_state()) return failure;
  double a2 = 0.0;
  for (std::size_t i = 0; i < at(fluid_.n); ++i) {
    const double du = u[i] - u_before_[i], dw = w[i] - w_before_[i];
    a2 = std::max(a2, du * du + dw * dw);
  }
  now_.max_acceleration = std::sqrt(a2) / dt;
  remove_departed();
  now_.time += dt;
  now_.time_step = dt;
  ++now_.statistics.steps;
  return std::nullopt;
}

}  // namespace parapet::solver
