// Default time integration, with two clocks. Pressure and density follow the sound by symplectic
// Euler: pressure sees the old positions and densities, density the new velocities, which is stable
// up to dt omega = 2 with one visit of each term per step. On a lattice that is 1.36 h/c with the
// density diffusion; where an impact crowds the particles it is less. Nothing else in the flow
// changes as fast as sound: every few steps a longer one follows for the gradients (density,
// strain rate, shifting) and the viscosity, which is solved implicitly over the whole time since
// the last solve. In between the viscous acceleration found last stands in for it; the solve takes
// that loan back, so that its result does not depend on it.
#include <algorithm>

#include "parapet/flow/time_step.hpp"
#include "time_integrator.hpp"

namespace parapet::solver {
namespace {

class ImplicitViscosity final : public TimeIntegrator {
 public:
  explicit ImplicitViscosity(int steps_per_solve)
      : steps_per_solve_(steps_per_solve), clock_{.steps = steps_per_solve - 1} {}

  double default_acoustic_cfl() const override { return implicit_acoustic_cfl; }
  double most_excess() const override { return implicit_step_excess; }
  bool explicit_viscosity() const override { return false; }
  // In one step a pair comes within reach by a tenth of h at most, where the kernel's gradient is
  // 1e-4 of its largest.
  bool keeps_pairs() const override { return true; }
  IntegrationClock clock() const override { return clock_; }
  void set_clock(const IntegrationClock& clock) override { clock_ = clock; }

  std::optional<Failure> advance(Flow& flow, double dt) override {
    const auto n = static_cast<std::size_t>(flow.fluid().n);
    for (auto* a : {&ax_, &az_}) a->assign(n + 1, 0.0);
    flow.extrapolate_walls();
    const bool solve = ++clock_.steps >= steps_per_solve_;
    if (solve) flow.update_gradients(steps_per_solve_ * dt);
    flow.add_body_and_pressure_force(ax_, az_);
    if (flow.inviscid() || !solve) {
      accelerate(flow.fluid(), dt);
    } else if (!solve_viscosity(flow, dt)) {
      return Failure{StopReason::viscous_solver,
                     "the conjugate gradients of the viscous step did not converge"};
    }
    if (solve) clock_.steps = 0;
    flow.measure_barrier_load(dt);
    flow.update_density_rate();
    move(flow.fluid(), dt);
    return std::nullopt;
  }

 private:
  void accelerate(Fluid& f, double dt) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      f.u[i] += dt * (ax_[i] + f.viscous_ax[i]);
      f.w[i] += dt * (az_[i] + f.viscous_az[i]);
    }
    clock_.since_solve += dt;
  }

  bool solve_viscosity(Flow& flow, double dt) {
    Fluid& f = flow.fluid();
    const auto n = static_cast<std::size_t>(f.n);
    for (auto* a : {&u_, &w_}) a->resize(n + 1);
    const double interval = clock_.since_solve + dt;
    // the velocity after all other forces takes the place of their acceleration
    std::vector<double>&u_star = ax_, &w_star = az_;
    for (std::size_t i = 0; i < n; ++i) {
      u_star[i] = f.u[i] - clock_.since_solve * f.viscous_ax[i] + dt * ax_[i];
      w_star[i] = f.w[i] - clock_.since_solve * f.viscous_az[i] + dt * az_[i];
      u_[i] = u_star[i] + interval * f.viscous_ax[i];
      w_[i] = w_star[i] + interval * f.viscous_az[i];
    }
    if (!flow.solve_viscosity(u_star, w_star, u_, w_, interval)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      f.viscous_ax[i] = (u_[i] - u_star[i]) / interval;
      f.viscous_az[i] = (w_[i] - w_star[i]) / interval;
    }
    std::copy_n(u_.begin(), n, f.u.begin());
    std::copy_n(w_.begin(), n, f.w.begin());
    clock_.since_solve = 0.0;
    return true;
  }

  static void move(Fluid& f, double dt) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      f.mass[i] += dt * f.mass_rate[i];
      f.u[i] += dt * f.exchange_x[i] / f.mass[i];
      f.w[i] += dt * f.exchange_z[i] / f.mass[i];
      f.density[i] += dt * f.density_rate[i];
      f.x[i] += dt * (f.u[i] + f.shift_u[i]);
      f.z[i] += dt * (f.w[i] + f.shift_w[i]);
    }
  }

  int steps_per_solve_;
  IntegrationClock clock_;
  std::vector<double> ax_, az_, u_, w_;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_implicit_viscosity(int steps_per_solve) {
  return std::make_unique<ImplicitViscosity>(steps_per_solve);
}

}  // namespace parapet::solver
