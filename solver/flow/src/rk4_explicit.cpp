// Explicit Runge-Kutta schemes over all of Eq. 6: the classic one of fourth order, which is the
// reference, and the midpoint rule, with which thin fluids are computed.
#include "parapet/flow/index.hpp"
#include "time_integrator.hpp"

namespace parapet::solver {
namespace {

// One array for each quantity of the state, or its rate of change.
struct State {
#define PARAPET_ARRAY(name, ...) std::vector<double> name;
  PARAPET_STATE_FIELDS(PARAPET_ARRAY)
#undef PARAPET_ARRAY
};

// Stages one after the other: each starts from the state before the step with the slope of the one
// before it, and the step takes their weighted mean.
struct Stages {
  int count;
  double to_next[4];  // share of the step from the start to the next stage
  double weight[4];
  int load_stage;  // whose forces the loads on the walls are taken from
  double acoustic_cfl;
};

constexpr Stages rk4{4, {0.5, 0.5, 1.0, 0.0}, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}, 0, 0.6};
constexpr Stages midpoint{2, {0.5, 0.0}, {0.0, 1.0}, 1, 0.5};

class RungeKutta final : public TimeIntegrator {
 public:
  explicit RungeKutta(const Stages& scheme) : scheme_(scheme) {}

  double default_acoustic_cfl() const override { return scheme_.acoustic_cfl; }
  bool explicit_viscosity() const override { return true; }

  std::optional<Failure> advance(Flow& flow, double dt) override {
    Fluid& f = flow.fluid();
    const std::size_t n = at(f.n);
#define PARAPET_START(name, ...) \
  start_.name = f.name;          \
  sum_.name.assign(n + 1, 0.0);
    PARAPET_STATE_FIELDS(PARAPET_START)
#undef PARAPET_START
    for (int stage = 0; stage < scheme_.count; ++stage) {
      if (stage > 0) {
        flow.find_reached_pairs();
        flow.update_pressure();
      }
      derive(flow, dt);
      if (stage == scheme_.load_stage) flow.measure_barrier_load(dt);
      add_to_sum(scheme_.weight[stage], n);
      if (stage + 1 < scheme_.count) place(f, slope_, scheme_.to_next[stage] * dt, n);
    }
    place(f, sum_, dt, n);
    return std::nullopt;
  }

 private:
  // slope_ = d(state)/dt at the fluid's present state. Every member must be worked out here.
  void derive(Flow& flow, double dt) {
    Fluid& f = flow.fluid();
    const std::size_t n = at(f.n);
    std::vector<double> x(n + 1, 0.0), z(n + 1, 0.0), u(n + 1, 0.0), w(n + 1, 0.0);
    flow.extrapolate_walls();
    flow.update_gradients(dt);
    flow.add_body_and_pressure_force(u, w);
    if (!flow.inviscid()) flow.add_viscous_force(u, w);
    flow.update_density_rate();
    for (std::size_t i = 0; i < n; ++i) {
      u[i] += f.exchange_x[i] / f.mass[i];
      w[i] += f.exchange_z[i] / f.mass[i];
      x[i] = f.u[i] + f.shift_u[i];
      z[i] = f.w[i] + f.shift_w[i];
    }
    slope_ = {.x = std::move(x),
              .z = std::move(z),
              .u = std::move(u),
              .w = std::move(w),
              .density = f.density_rate,
              .mass = f.mass_rate};
  }

  void add_to_sum(double weight, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
#define PARAPET_ADD(name, ...) sum_.name[i] += weight * slope_.name[i];
      PARAPET_STATE_FIELDS(PARAPET_ADD)
#undef PARAPET_ADD
    }
  }

  // fluid = start + dt slope.
  void place(Fluid& f, const State& slope, double dt, std::size_t n) const {
    for (std::size_t i = 0; i < n; ++i) {
#define PARAPET_PLACE(name, ...) f.name[i] = start_.name[i] + dt * slope.name[i];
      PARAPET_STATE_FIELDS(PARAPET_PLACE)
#undef PARAPET_PLACE
    }
  }

  const Stages& scheme_;
  State start_, slope_, sum_;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_rk4_explicit() {
  return std::make_unique<RungeKutta>(rk4);
}

std::unique_ptr<TimeIntegrator> make_midpoint() {
  return std::make_unique<RungeKutta>(midpoint);
}

}  // namespace parapet::solver
