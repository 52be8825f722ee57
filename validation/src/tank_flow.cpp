#include "tank_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "balance.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation::tank_flows {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::Scene;
using solver::Vec2;

namespace {

constexpr double gravity = 9.81;  // [m/s2]
constexpr double wall_top = 0.5;  // of the side walls [m]

// Hydrostatics of a tank with the fluid's compressibility. A barrier that pierces the surface makes
// two basins of it.
class Hydrostatics {
 public:
  // The surfaces follow from the mass that is in each basin.
  Hydrostatics(const Tank& tank, const FlowSetup& setup);

  double height(Vec2 p) const { return dot(up_, p); }
  double pressure(Vec2 p) const { return pressure_at(surface_[basin(p)] - height(p)); }
  double depth() const { return std::max(surface_[0], surface_[1]) - bottom_; }
  double mass_center() const { return mass_center_; }  // height of it
  // Mass that the particle's basin should have up to the tank's surface, over what it has.
  double filling(Vec2 p) const { return filling_[basin(p)]; }
  // Of the fluid on a face.
  Vec2 force(const solver::Face& face) const;

 private:
  // 1: beyond the stem or above the deflector of a barrier that divides the tank.
  std::size_t basin(Vec2 p) const {
    if (!divided_) return 0;
    const bool beside_stem = height(p) < height(crest_);
    return dot(p - crest_, beside_stem ? downstream_ : upper_) > 0.0 ? 1 : 0;
  }
  // dp/dz = -(rho_0 + p/c2) g
  double pressure_at(double depth) const {
    return depth > 0.0 ? rho_0_ * c2_ * std::expm1(gravity * depth / c2_) : 0.0;
  }

  Vec2 up_;
  double rho_0_, c2_, bottom_ = 0.0, mass_center_ = 0.0;
  bool divided_ = false;
  Vec2 crest_, downstream_, upper_;  // of the barrier, and where its faces beyond look to
  std::array<double, 2> surface_;    // heights
  std::array<double, 2> filling_;
};

// The barrier of a tank: 100 mm, as in the channel with a 45 deg deflector or bare.
Scene barrier_scene(const Tank& tank) {
  Scene scene;
  scene.slope = tank.slope;
  solver::Barrier barrier;
  barrier.foot_x = tank.foot;
  barrier.thickness = tank.thickness;
  if (!tank.bare) {
    barrier.deflector = solver::Deflector{.angle = std::numbers::pi / 4.0, .length = 0.065};
  }
  scene.barriers = {barrier};
  return scene;
}

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
  if (tank.barrier && !tank.bare) {
    const Scene scene = barrier_scene(tank);
    const solver::Barrier& barrier = scene.barriers.front();
    const Vec2 stem = stem_direction(scene, barrier);
    const Vec2 plate = deflector_direction(scene, *barrier.deflector);
    crest_ = Vec2{barrier.foot_x, 0.0} + barrier.height * stem;
    downstream_ = {stem.z, -stem.x};
    upper_ = {plate.z, -plate.x};
    divided_ = height(crest_ + barrier.deflector->length * plate) > tank.surface;
  }
  std::array<std::vector<double>, 2> heights;
  for (double x = 0.5 * cell; x < tank.length; x += cell) {
    for (double z = 0.5 * cell; z < wall_top; z += cell) {
      const Vec2 p{x, z};
      if (in_tank(tank, setup.solids, p)) heights[basin(p)].push_back(height(p));
    }
  }
  std::array<double, 2> mass{};
  for (const solver::InitialParticle& p : setup.particles) mass[basin({p.x, p.z})] += p.mass;
  double all_moment = 0.0;
  for (std::size_t b = 0; b < mass.size(); ++b) {
    struct Below {
      double mass = 0.0, moment = 0.0;
    };
    const auto below = [&](double surface) {
      Below sum;
      for (const double h : heights[b]) {
        if (h > surface) continue;
        const double m = cell * cell * (rho_0_ + pressure_at(surface - h) / c2_);
        sum.mass += m;
        sum.moment += m * h;
      }
      return sum;
    };
    double low = bottom_, high = wall_top;
    Below still;
    for (int k = 0; k < 40; ++k) {
      surface_[b] = 0.5 * (low + high);
      still = below(surface_[b]);
      (still.mass < mass[b] ? low : high) = surface_[b];
    }
    all_moment += still.moment;
    filling_[b] = mass[b] > 0.0 ? below(tank.surface).mass / mass[b] : 1.0;
  }
  mass_center_ = all_moment / (mass[0] + mass[1]);
}

Vec2 Hydrostatics::force(const solver::Face& face) const {
  constexpr int parts = 2000;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    sum += pressure(face.a + ((k + 0.5) / parts * face.length) * face.tangent +
                    1e-6 * face.normal);  // in the basin that the face looks into
  }
  return (-sum * face.length / parts) * face.normal;
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
    const Scene scene = barrier_scene(tank);
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
// the sum of Eq. 9, walls included, as far as the free surface does not reach (after Colagrossi et
// al. 2012), never closer to a wall than 0.4 dx. A lattice cut by oblique plates leaves gaps, which
// a fluid with a yield stress would keep. Afterwards the particles share the mass of the whole
// tank: those cut out of the lattice have 2 % less, and would stand higher than their mass says.
void pack(FlowSetup& setup, const Tank& tank) {
  const Vec2 up{-std::sin(tank.slope), std::cos(tank.slope)};
  Flow flow{FlowSetup(setup)};
  flow.refresh();
  Fluid& f = flow.fluid();
  const double h = flow.smoothing_length(), dx = tank.spacing;
  for (int iteration = 0; iteration < 300; ++iteration) {
    flow.prepare_neighbors();
    flow.extrapolate_walls();
    flow.update_gradients(0.0);
    const solver::GradientSumArrays sums = flow.gradient_sums();
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      const Vec2 at{f.x[i], f.z[i]};
      if (tank.surface - dot(up, at) < 2.0 * h) continue;
      Vec2 step = (-0.15 * h * h) * Vec2{sums.view.shift_x[i], sums.view.shift_z[i]};
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
  const Hydrostatics packed(tank, setup);
  for (solver::InitialParticle& p : setup.particles) p.mass *= packed.filling({p.x, p.z});
}

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

}  // namespace

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

}  // namespace parapet::validation::tank_flows
