// Fluid at rest for 10 s in a rectangular tank and in a tank tilted by the channel's slope, with a
// stem and a deflector in it: spurious speeds, pressure and the force on every plate against
// hydrostatics. It tries the walls that everything else relies on: corners, plates, the pocket
// below a deflector and its tip. The fluid is as thin as water, so that nothing damps what the
// walls stir up; Table 1's debris for comparison.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "balance.hpp"
#include "cases.hpp"
#include "channel.hpp"
#include "flow_tools.hpp"
#include "parapet/reports/line_plot.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::Integrator;
using solver::Material;
using solver::Scene;
using solver::Vec2;

namespace {

constexpr double gravity = 9.81;                           // [m/s2]
constexpr double slope = 26.0 * std::numbers::pi / 180.0;  // of the channel's bed
constexpr double wall_top = 0.5;                           // of the side walls [m]

Material water() {
  Material m;
  m.density = 1000.0;
  m.yield_stress = 0.0;
  m.consistency = 1e-3;
  m.flow_index = 1.0;
  return m;
}

struct Tank {
  const char* key;
  const char* name;
  Material material;
  double slope;    // of the bed
  double length;   // of the bed, between walls normal to it [m]
  double surface;  // height of the surface above the upper corner of the bed, in the world [m]
  bool barrier;
  double spacing;
  double time;  // [s]
  Integrator integrator = Integrator::implicit_viscosity;
  double shifting = 1.0;  // share of the shifting velocity
};

constexpr double long_ = 0.40;

// Hydrostatics of a tank with the fluid's compressibility.
class Hydrostatics {
 public:
  // The surface follows from the mass that is in the tank.
  Hydrostatics(const Tank& tank, const FlowSetup& setup);

  double height(Vec2 p) const { return dot(up_, p); }
  double pressure(Vec2 p) const { return pressure_at(surface_ - height(p)); }
  double surface() const { return surface_; }
  double depth() const { return surface_ - bottom_; }
  double mass_center() const { return mass_center_; }  // height of it
  // Of the fluid on a face.
  Vec2 force(const solver::Face& face) const;

 private:
  // dp/dz = -(rho_0 + p/c2) g
  double pressure_at(double depth) const {
    return depth > 0.0 ? rho_0_ * c2_ * std::expm1(gravity * depth / c2_) : 0.0;
  }

  Vec2 up_;
  double rho_0_, c2_, surface_ = 0.0, bottom_ = 0.0, mass_center_ = 0.0;
};

bool in_tank(const Tank& tank, const solver::Solids& solids, Vec2 p) {
  if (p.x <= 0.0 || p.x >= tank.length || p.z <= 0.0) return false;
  for (const solver::Body& body : solids.bodies) {
    if (!body.outline.empty() && inside_polygon(body.outline, p)) return false;
  }
  return true;
}

Hydrostatics::Hydrostatics(const Tank& tank, const FlowSetup& setup)
    : up_{-std::sin(tank.slope), std::cos(tank.slope)},
      rho_0_(setup.material.density),
      c2_(setup.numerics.sound_speed * setup.numerics.sound_speed) {
  constexpr double cell = 1e-3;  // [m]
  bottom_ = height({tank.length, 0.0});
  std::vector<double> heights;
  for (double x = 0.5 * cell; x < tank.length; x += cell) {
    for (double z = 0.5 * cell; z < wall_top; z += cell) {
      if (in_tank(tank, setup.solids, {x, z})) heights.push_back(height({x, z}));
    }
  }
  double mass = 0.0;
  for (const solver::InitialParticle& p : setup.particles) mass += p.mass;
  double low = bottom_, high = wall_top;
  for (int k = 0; k < 40; ++k) {
    surface_ = 0.5 * (low + high);
    double sum = 0.0, moment = 0.0;
    for (const double h : heights) {
      if (h > surface_) continue;
      const double m = cell * cell * (rho_0_ + pressure_at(surface_ - h) / c2_);
      sum += m;
      moment += m * h;
    }
    mass_center_ = moment / sum;
    (sum < mass ? low : high) = surface_;
  }
}

Vec2 Hydrostatics::force(const solver::Face& face) const {
  constexpr int parts = 2000;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    sum += pressure(face.a + ((k + 0.5) / parts * face.length) * face.tangent);
  }
  return (-sum * face.length / parts) * face.normal;
}

// The barrier of the tilted tank: 100 mm with a 45 deg deflector, as in the channel.
Scene barrier_scene() {
  Scene scene;
  solver::Barrier barrier;
  barrier.foot_x = 0.22;
  barrier.deflector = solver::Deflector{.angle = std::numbers::pi / 4.0, .length = 0.065};
  scene.barriers = {barrier};
  return scene;
}

FlowSetup tank_setup(const Tank& tank) {
  FlowSetup setup;
  const double dx = tank.spacing;
  setup.numerics.spacing = dx;
  setup.numerics.integrator = tank.integrator;
  setup.numerics.shifting_factor = tank.shifting;
  setup.material = tank.material;
  setup.gravity = {gravity * std::sin(tank.slope), -gravity * std::cos(tank.slope)};
  const double depth = tank.surface + tank.length * std::sin(tank.slope);
  setup.numerics.sound_speed = 10.0 * std::sqrt(gravity * depth);
  add_wall(setup, {0.0, 0.0}, {tank.length, 0.0});
  add_wall(setup, {tank.length, 0.0}, {tank.length, wall_top});
  add_wall(setup, {0.0, wall_top}, {0.0, 0.0});
  if (tank.barrier) {
    const Scene scene = barrier_scene();
    add_outline(setup.solids, barrier_outline(scene, scene.barriers.front()), 0, true);
  }
  // every face is a load cell of its own
  setup.n_barriers = static_cast<int>(setup.solids.faces.size());
  for (int k = 0; k < setup.n_barriers; ++k) {
    setup.solids.faces[static_cast<std::size_t>(k)].barrier = k;
  }
  const double c2 = setup.numerics.sound_speed * setup.numerics.sound_speed;
  const Vec2 up{-std::sin(tank.slope), std::cos(tank.slope)};
  for (solver::InitialParticle p :
       solver::lattice_block(0.0, 0.0, tank.length, wall_top, dx, setup.material.density)) {
    const Vec2 at{p.x, p.z};
    const double below = tank.surface - dot(up, at);
    bool keep = below > 0.0 && in_tank(tank, setup.solids, at);
    for (const solver::Face& face : setup.solids.faces) {
      keep = keep && distance_to_segment(face.a, face.b, at) > 0.45 * dx;
    }
    if (!keep) continue;
    p.density += setup.material.density * gravity * below / c2;
    p.mass *= p.density / setup.material.density;
    setup.particles.push_back(p);
  }
  return setup;
}

// Moves the particles until they surround each other and fill the corners evenly: against
// sum grad W V, walls included, as far as the free surface does not reach (after Colagrossi et al.
// 2012), never closer to a wall than 0.4 dx. A lattice cut by oblique plates leaves gaps, which a
// fluid with a yield stress would keep.
void pack(FlowSetup& setup, const Tank& tank) {
  const Vec2 up{-std::sin(tank.slope), std::cos(tank.slope)};
  Flow flow{FlowSetup(setup)};
  flow.refresh();
  Fluid& f = flow.fluid();
  const double h = flow.smoothing_length(), dx = tank.spacing;
  for (int iteration = 0; iteration < 300; ++iteration) {
    flow.prepare_neighbors();
    flow.update_gradients();
    const solver::GradientSums sums = f.gradient_sums();
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      const Vec2 at{f.x[i], f.z[i]};
      if (tank.surface - dot(up, at) < 2.0 * h) continue;
      Vec2 step = (-0.15 * h * h) * Vec2{sums.normal_x[i], sums.normal_z[i]};
      const double size = norm(step), cap = 0.05 * dx;
      if (size > cap) step = (cap / size) * step;
      const Vec2 to = at + step;
      const bool clear = std::all_of(
          setup.solids.faces.begin(), setup.solids.faces.end(), [&](const solver::Face& face) {
            return distance_to_segment(face.a, face.b, to) >
                   std::min(0.4 * dx, distance_to_segment(face.a, face.b, at) - 1e-9);
          });
      if (!clear) continue;
      f.x[i] = to.x;
      f.z[i] = to.z;
    }
  }
  const double c2 = setup.numerics.sound_speed * setup.numerics.sound_speed;
  for (std::size_t i = 0; i < setup.particles.size(); ++i) {
    const Vec2 at{f.x[i], f.z[i]};
    const double below = tank.surface - dot(up, at);
    setup.particles[i] = {
        at.x, at.z, 0.0, 0.0, setup.material.density * (1.0 + gravity * below / c2), f.mass[i]};
  }
}

struct TankRun {
  std::vector<double> time, largest, rms;              // speeds over sqrt(gH) [%]
  std::vector<double> pressure_rms, pressure_largest;  // errors over rho g H [%]
  double drift = 0.0;    // of the centre of mass in the second half, over H [%]
  int inside = 0;        // particles inside walls
  double plates = 0.0;   // largest error of the force on a plate, see below [%]
  double barrier = 0.0;  // error of the force on the whole barrier [%]
  double mass_change = 0.0, momentum_error = 0.0;
  double lasted = 0.0;  // time until the flow failed [s]
  std::string failure;
  ParticlePanel speed, pressure;
  std::vector<solver::Face> walls;
};

// Errors of the forces over the sum of the forces' sizes on all plates of the barrier.
void compare_forces(TankRun& r, const Hydrostatics& still, const std::vector<Vec2>& forces) {
  Vec2 sum, exact_sum;
  double scale = 0.0, worst = 0.0;
  for (std::size_t k = 3; k < r.walls.size(); ++k) {
    const Vec2 exact = still.force(r.walls[k]);
    sum = sum + forces[k];
    exact_sum = exact_sum + exact;
    scale += norm(exact);
    worst = std::max(worst, norm(forces[k] - exact));
  }
  if (scale == 0.0) return;
  r.plates = 100.0 * worst / scale;
  r.barrier = 100.0 * norm(sum - exact_sum) / scale;
}

TankRun computed(const Tank& tank, const CaseRun& run) {
  FlowSetup setup = tank_setup(tank);
  if (tank.barrier) pack(setup, tank);
  const Hydrostatics still(tank, setup);
  const double depth = still.depth(), speed = std::sqrt(gravity * depth);
  const double scale = tank.material.density * gravity * depth;
  TankRun r;
  r.walls = setup.solids.faces;
  Flow flow(std::move(setup));
  Balance balance(flow);
  std::vector<solver::BarrierImpulse> half;
  double center_half = 0.0, center = 0.0;
  const auto sample = [&](Flow& now) {
    const Fluid& f = std::as_const(now).fluid();
    const auto n = static_cast<std::size_t>(f.n);
    double u2 = 0.0, largest = 0.0, p2 = 0.0, p_largest = 0.0, moment = 0.0, mass = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double s2 = f.u[i] * f.u[i] + f.w[i] * f.w[i];
      const double dp = std::abs(f.pressure[i] - still.pressure({f.x[i], f.z[i]}));
      u2 += s2;
      largest = std::max(largest, s2);
      p2 += dp * dp;
      p_largest = std::max(p_largest, dp);
      mass += f.mass[i];
      moment += f.mass[i] * still.height({f.x[i], f.z[i]});
    }
    const double count = static_cast<double>(n);
    r.time.push_back(now.time());
    r.largest.push_back(100.0 * std::sqrt(largest) / speed);
    r.rms.push_back(100.0 * std::sqrt(u2 / count) / speed);
    r.pressure_rms.push_back(100.0 * std::sqrt(p2 / count) / scale);
    r.pressure_largest.push_back(100.0 * p_largest / scale);
    r.inside = std::max(r.inside, now.particles_inside_walls());
    center = moment / mass;
    if (half.empty() && now.time() > 0.5 * tank.time - 1e-9) {
      half = balance.impulses();
      center_half = center;
    }
    r.lasted = now.time();
  };
  try {
    advance_sampled(flow, tank.time, 0.05, run, sample, &balance);
    std::vector<Vec2> forces;
    for (std::size_t k = 0; k < half.size(); ++k) {
      forces.push_back((2.0 / tank.time) * (balance.impulses()[k].force - half[k].force));
    }
    compare_forces(r, still, forces);
    r.drift = 100.0 * (center - center_half) / depth;
  } catch (const std::runtime_error& error) {
    r.failure = error.what();
    r.lasted = flow.time();
  }
  const Fluid& f = std::as_const(flow).fluid();
  r.speed = speed_panel(flow, tank.name);
  for (double& s : r.speed.quantity) s *= 100.0 / speed;
  r.pressure = r.speed;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    r.pressure.quantity[i] = 100.0 * (f.pressure[i] - still.pressure({f.x[i], f.z[i]})) / scale;
  }
  r.mass_change = balance.mass_change(flow);
  r.momentum_error = 100.0 * balance.momentum_error(flow);
  return r;
}

// Largest value after the first half.
double late(const std::vector<double>& v) {
  return *std::max_element(v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
}
double late_rms(const std::vector<double>& v) {
  double sum = 0.0;
  const std::size_t from = v.size() / 2;
  for (std::size_t k = from; k < v.size(); ++k) sum += v[k] * v[k];
  return std::sqrt(sum / static_cast<double>(v.size() - from));
}

void add_tank(CaseRun& run, const Tank& tank, const TankRun& r) {
  const std::string key = tank.key;
  const auto add = [&](const char* name, const char* words, double value, const char* unit,
                       std::optional<double> upper, const char* reason, const char* explanation) {
    Measure m;
    m.key = fmt::format("{}_{}", key, name);
    m.what = fmt::format("{}: {}", tank.name, words);
    m.value = value;
    m.unit = fmt::format("{}", unit);
    m.upper = upper;
    m.reason = fmt::format("{}", reason);
    m.explanation = fmt::format("{}", explanation);
    run.add(m);
  };
  const bool thin = tank.material.yield_stress == 0.0;
  const char* shaken = tank.barrier
                           ? "at convex corners wall points come into sight and vanish one by one; "
                             "each jump is a force of several times the weight"
                           : "sound and eddies that the start stirs up and nothing damps; shifting "
                             "presses particles against the walls unnoticed by the density";
  const char* still_why =
      "a lattice of h/dx = 1.33 that nothing moves carries 0.979 of a "
      "pressure gradient, whatever the spacing";
  Measure lasted{.key = key + "_lasted",
                 .what = fmt::format("{}: time that the flow could be computed", tank.name),
                 .value = r.lasted,
                 .unit = "s",
                 .lower = tank.time - 1e-6,
                 .reason = "a fluid at rest stays at rest"};
  if (!r.failure.empty()) lasted.explanation = fmt::format("{}: {}", r.failure, shaken);
  run.add(lasted);
  add("speed", "largest speed in the second half, over sqrt(gH)", late(r.largest), "%", 1.0,
      "what a fluid at rest may stir up", shaken);
  add("rms", "rms speed in the second half, over sqrt(gH)", late_rms(r.rms), "%", {}, "", "");
  add("pressure", "rms error of the pressure in the second half, over rho g H",
      late_rms(r.pressure_rms), "%", 1.0, "hydrostatics", thin ? shaken : still_why);
  add("pressure_largest", "largest error of the pressure in the second half, over rho g H",
      late(r.pressure_largest), "%", {}, "", "");
  add("inside", "particles inside walls", r.inside, "", 0.0, "a wall is a wall", shaken);
  add("momentum", "momentum not explained by gravity and wall forces", r.momentum_error, "%", 1.0,
      "share of the impulse of gravity", shaken);
  if (!r.failure.empty()) return;
  add("drift", "the centre of mass moves in the second half, over H", std::abs(r.drift), "%", 0.2,
      "a fifth of a per cent in half the time keeps the level within what the pressure may err",
      shaken);
  if (tank.barrier) {
    add("plates", "force on a plate, largest error over the sum on all plates", r.plates, "%", 2.0,
        "pressure within 1 %, and corners shared between two plates", shaken);
    add("barrier", "force on the whole barrier, error over the sum on all plates", r.barrier, "%",
        2.0, "as for the plates", shaken);
  }
}

void draw_speeds(CaseRun& run, const std::vector<Tank>& tanks, const std::vector<TankRun>& runs) {
  reports::LinePlot plot;
  plot.title = "Largest spurious speed";
  plot.x_label = "time [s]";
  plot.y_label = "log10 of speed / sqrt(gH)";
  for (std::size_t k = 0; k < tanks.size(); ++k) {
    reports::PlotSeries s{
        tanks[k].name, runs[k].time, {}, reports::SeriesStyle::line, static_cast<int>(k)};
    for (const double u : runs[k].largest) s.y.push_back(std::log10(std::max(0.01 * u, 1e-6)));
    plot.series.push_back(s);
  }
  plot.width_px = 900;
  plot.height_px = 480;
  draw_line_plot(run.figure("speeds.png"), plot);
}

void draw_barriers(CaseRun& run, const std::vector<Tank>& tanks, const std::vector<TankRun>& runs,
                   bool speed) {
  ParticlePicture picture;
  picture.title = fmt::format("{} at the end", speed ? "Speed" : "Error of the pressure");
  picture.quantity = fmt::format("{}", speed ? "speed / sqrt(gH) [%]" : "error / rho g H [%]");
  picture.low = speed ? 0.0 : -3.0;
  picture.high = speed ? 2.0 : 3.0;
  for (std::size_t k = 0; k < tanks.size() && picture.panels.size() < 2; ++k) {
    if (!tanks[k].barrier) continue;
    picture.spacing = tanks[k].spacing;
    picture.walls = runs[k].walls;
    picture.panels.push_back(speed ? runs[k].speed : runs[k].pressure);
  }
  picture.window_from = {-0.01, -0.01};
  picture.window_to = {0.41, 0.3};
  picture.width_px = 900;
  draw(run, speed ? "speed.png" : "pressure.png", picture);
}

}  // namespace

void tanks(CaseRun& run) {
  const double time = run.full() ? 10.0 : 1.0;
  std::vector<Tank> list{
      {"debris", "rectangular tank, debris", Material{}, 0.0, 0.3, 0.2, false, 0.01, time},
      {"tilted", "tilted tank, water", water(), slope, long_, 0.08, false, 0.0075, time},
      {"barrier_debris", "tilted tank with barrier, debris", Material{}, slope, long_, 0.08, true,
       0.0075, time},
  };
  if (run.full()) {
    list.push_back({"water", "rectangular tank, water", water(), 0.0, 0.3, 0.2, false, 0.01, time});
    list.push_back({"unshifted", "rectangular tank, water, no shifting", water(), 0.0, 0.3, 0.2,
                    false, 0.01, time, Integrator::implicit_viscosity, 0.0});
    list.push_back({"water_fine", "rectangular tank, water, 5 mm", water(), 0.0, 0.3, 0.2, false,
                    0.005, time});
    list.push_back({"barrier_water", "tilted tank with barrier, water", water(), slope, long_, 0.08,
                    true, 0.0075, time});
    list.push_back({"pierced_debris", "barrier that pierces the surface, debris", Material{}, slope,
                    long_, 0.035, true, 0.0075, time});
    list.push_back({"debris_fine", "tilted tank with barrier, debris, 5 mm", Material{}, slope,
                    long_, 0.08, true, 0.005, 0.2 * time});
  }
  // both time integrations, a second of water
  const std::size_t n = list.size();
  std::vector<Tank> integrators;
  for (const Integrator integrator : {Integrator::implicit_viscosity, Integrator::rk4_explicit}) {
    integrators.push_back({"integrator", "rectangular tank, water", water(), 0.0, 0.3, 0.2, false,
                           0.01, run.full() ? 1.0 : 0.2, integrator});
  }
  std::vector<TankRun> runs(n), pair(2);
  std::vector<double> cost;
  for (const Tank& t : list) cost.push_back(t.time * 1e-6 / std::pow(t.spacing, 3.0));
  run.side_by_side(
      n + 2,
      [&](std::size_t k) {
        (k < n ? runs[k] : pair[k - n]) = computed(k < n ? list[k] : integrators[k - n], run);
      },
      cost);
  for (std::size_t k = 0; k < n; ++k) add_tank(run, list[k], runs[k]);
  run.add({.key = "integrators",
           .what = fmt::format("rectangular tank, water: rms speed, rk4_explicit minus "
                               "implicit_viscosity, over sqrt(gH), after {:.1f} s",
                               integrators.front().time),
           .value = pair[1].rms.back() - pair[0].rms.back(),
           .unit = "%",
           .lower = -0.1,
           .upper = 0.1,
           .reason = "both solve the same equations in space; what is stirred up is the same"});
  draw_speeds(run, list, runs);
  draw_barriers(run, list, runs, false);
  draw_barriers(run, list, runs, true);
}

}  // namespace parapet::validation
