// Reference time integration: the classic fourth-order Runge-Kutta scheme over all of Eq. 6.
#include "time_integrator.hpp"

namespace parapet::solver {
namespace {

struct State {
  std::vector<double> x, z, u, w, density, mass;
};

class Rk4Explicit final : public TimeIntegrator {
 public:
  double default_acoustic_cfl() const override { return 0.6; }
  bool explicit_viscosity() const override { return true; }

  std::optional<Failure> advance(Flow& flow, double dt) override {
    Fluid& f = flow.fluid();
    start_ = {f.x, f.z, f.u, f.w, f.density, f.mass};
    static constexpr double next_stage[] = {0.5, 0.5, 1.0, 0.0};
    static constexpr double weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const auto n = static_cast<std::size_t>(f.n);
    for (auto* a : {&sum_.x, &sum_.z, &sum_.u, &sum_.w, &sum_.density, &sum_.mass})
      a->assign(n + 1, 0.0);
    for (int stage = 0; stage < 4; ++stage) {
      if (stage > 0) {
        flow.find_reached_pairs();
        flow.update_pressure();
      }
      derive(flow, dt);
      if (stage == 0) flow.measure_barrier_load(dt);
      accumulate(sum_, weight[stage], n);
      if (stage < 3) place(f, slope_, next_stage[stage] * dt, n);
    }
    place(f, sum_, dt, n);
    return std::nullopt;
  }

 private:
  // slope_ = d(state)/dt at the fluid's present state.
  void derive(Flow& flow, double dt) {
    Fluid& f = flow.fluid();
    const auto n = static_cast<std::size_t>(f.n);
    for (auto* a : {&slope_.u, &slope_.w}) a->assign(n + 1, 0.0);
    flow.extrapolate_walls();
    flow.update_gradients(dt);
    flow.add_body_and_pressure_force(slope_.u, slope_.w);
    if (!flow.inviscid()) flow.add_viscous_force(slope_.u, slope_.w);
    flow.update_density_rate();
    slope_.density = f.density_rate;
    slope_.mass = f.mass_rate;
    slope_.x.resize(n + 1);
    slope_.z.resize(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
      slope_.u[i] += f.exchange_x[i] / f.mass[i];
      slope_.w[i] += f.exchange_z[i] / f.mass[i];
      slope_.x[i] = f.u[i] + f.shift_u[i];
      slope_.z[i] = f.w[i] + f.shift_w[i];
    }
  }

  void accumulate(State& sum, double weight, std::size_t n) const {
    for (std::size_t i = 0; i < n; ++i) {
      sum.x[i] += weight * slope_.x[i];
      sum.z[i] += weight * slope_.z[i];
      sum.u[i] += weight * slope_.u[i];
      sum.w[i] += weight * slope_.w[i];
      sum.density[i] += weight * slope_.density[i];
      sum.mass[i] += weight * slope_.mass[i];
    }
  }

  // fluid = start + dt slope.
  void place(Fluid& f, const State& slope, double dt, std::size_t n) const {
    for (std::size_t i = 0; i < n; ++i) {
      f.x[i] = start_.x[i] + dt * slope.x[i];
      f.z[i] = start_.z[i] + dt * slope.z[i];
      f.u[i] = start_.u[i] + dt * slope.u[i];
      f.w[i] = start_.w[i] + dt * slope.w[i];
      f.density[i] = start_.density[i] + dt * slope.density[i];
      f.mass[i] = start_.mass[i] + dt * slope.mass[i];
    }
  }

  State start_, slope_, sum_;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_rk4_explicit() {
  return std::make_unique<Rk4Explicit>();
}

}  // namespace parapet::solver
