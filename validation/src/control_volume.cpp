#include "control_volume.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::validation {

using solver::Face;
using solver::Flow;
using solver::FlowConstants;
using solver::FlowSetup;
using solver::Fluid;
using solver::Vec2;

namespace {

// F of grad W = F r [1/m4]; 0 beyond the kernel's reach.
double gradient(const FlowConstants& constants, Vec2 r) {
  const double t = 1.0 - 0.5 * norm(r) * constants.kernel.inverse_h;
  return t > 0.0 && t < 1.0 ? -constants.kernel.f_scale * t * t * t : 0.0;
}

}  // namespace

ControlPlanes planes_around(const solver::Scene& scene, double spacing, double clearance) {
  double from = 1e9, to = -1e9;
  for (const Vec2 corner : barrier_outline(scene, scene.barriers.front())) {
    from = std::min(from, corner.x);
    to = std::max(to, corner.x);
  }
  return {spacing * std::floor((from - clearance) / spacing),
          spacing * std::ceil((to + clearance) / spacing)};
}

void with_control_volume(FlowSetup& setup, const ControlPlanes& planes) {
  setup.n_barriers = control_cells;
  std::vector<Face>& faces = setup.solids.faces;
  const Face bed = faces.front();
  faces.front() = solver::make_face(bed.a, {planes.from, 0.0}, bed.body, -1);
  faces.push_back(solver::make_face({planes.from, 0.0}, {planes.to, 0.0}, bed.body, bed_cell));
  faces.push_back(solver::make_face({planes.to, 0.0}, bed.b, bed.body, -1));
}

ControlVolume::ControlVolume(const Flow& flow, const ControlPlanes& planes)
    : planes_(planes), before_(static_cast<std::size_t>(flow.fluid().n)) {
  remember(flow);
  samples_.push_back({flow.time(), {}, {}});
  const double reach = 2.0 * flow.smoothing_length();
  const Face& bed = flow.solids().faces.front();
  for (std::size_t k = 0; k < flow.walls().size(); ++k) {
    const Face& face = flow.solids().faces[static_cast<std::size_t>(flow.walls().owner[k])];
    const double x = flow.walls().x[k];
    const double off = std::min(std::abs(x - planes_.from), std::abs(x - planes_.to));
    if (face.body == bed.body && off < reach) bed_points_.push_back(k);
  }
}

void ControlVolume::remember(const Flow& flow) {
  const Fluid& f = flow.fluid();
  for (Before& one : before_) one.inside = false;  // who has left is not inside
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    before_[static_cast<std::size_t>(f.id[i])] = {f.x[i], f.z[i], f.mass[i] * Vec2{f.u[i], f.w[i]},
                                                  inside(f.x[i])};
  }
}

// Places are those at which the step worked its forces out, pressures and viscosities those that it
// used; velocities are those after it, as in the implicit viscous step.
Vec2 ControlVolume::of_particles(const Flow& flow, const FlowConstants& constants) const {
  const Fluid& f = flow.fluid();
  const double reach = 2.0 * flow.smoothing_length();
  const double levelling = -2.0 * constants.mass_diffusivity / constants.even_volume;
  std::vector<std::size_t> in, out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Before& was = before_[static_cast<std::size_t>(f.id[i])];
    const double off = std::min(std::abs(was.x - planes_.from), std::abs(was.x - planes_.to));
    if (off < reach) (was.inside ? in : out).push_back(i);
  }
  Vec2 sum;
  for (const std::size_t i : in) {
    const Before& at_i = before_[static_cast<std::size_t>(f.id[i])];
    for (const std::size_t j : out) {
      const Before& at_j = before_[static_cast<std::size_t>(f.id[j])];
      const Vec2 r{at_i.x - at_j.x, at_i.z - at_j.z};
      const double weight = f.volume[i] * f.volume[j] * gradient(constants, r);
      if (weight == 0.0) continue;
      const Vec2 du{f.u[i] - f.u[j], f.w[i] - f.w[j]};
      const double pressure = -(f.pressure[j] + f.tic[i] * f.pressure[i]);
      const double viscous =
          4.0 * (f.pair_viscosity[i] + f.pair_viscosity[j]) * dot(du, r) / dot(r, r);
      sum = sum + (weight * (pressure + viscous)) * r;
      const Vec2 carried = f.density[i] * Vec2{f.shift_u[i], f.shift_w[i]} +
                           f.density[j] * Vec2{f.shift_u[j], f.shift_w[j]};
      const double taken =
          weight * (dot(carried, r) + levelling * (f.mass[j] - f.mass[i]));  // [kg/m/s]
      sum = sum + (0.5 * taken) * Vec2{f.u[i] + f.u[j], f.w[i] + f.w[j]};
    }
  }
  return sum;
}

// A bed point acts through the face that the line of sight crosses; there is one of each face that
// reaches so far.
Vec2 ControlVolume::of_bed(const Flow& flow, const FlowConstants& constants) const {
  const Fluid& f = flow.fluid();
  const solver::WallPoints& walls = flow.walls();
  const double reach = 2.0 * flow.smoothing_length(), lowest = 0.2 * flow.smoothing_length();
  Vec2 sum;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Before& was = before_[static_cast<std::size_t>(f.id[i])];
    const double off = std::min(std::abs(was.x - planes_.from), std::abs(was.x - planes_.to));
    if (off > reach || was.z > reach || was.z <= 0.0) continue;
    for (const std::size_t k : bed_points_) {
      const Vec2 r{was.x - walls.x[k], was.z - walls.z[k]};
      const double weight = f.volume[i] * walls.volume[k] * gradient(constants, r);
      if (weight == 0.0) continue;
      const bool through_inside = inside(was.x - r.x * was.z / r.z);
      const Face& face = flow.solids().faces[static_cast<std::size_t>(walls.owner[k])];
      if ((face.barrier == bed_cell) != through_inside || through_inside == was.inside) continue;
      const double above = std::max(was.z, lowest);
      const double ratio = (above + walls.depth[k]) / above;
      const double pressure = -(walls.pressure[k] + std::max(0.0, f.tic[i] * f.pressure[i]));
      const double viscous = constants.no_slip ? 8.0 * f.pair_viscosity[i] * ratio *
                                                     dot({f.u[i], f.w[i]}, r) / dot(r, r)
                                               : 0.0;
      const Vec2 force = (weight * (pressure + viscous)) * r;
      sum = was.inside ? sum + force : sum - force;
    }
  }
  return sum;
}

void ControlVolume::add_step(Flow& flow) {
  const double dt = flow.last_time_step();
  const Fluid& f = flow.fluid();
  const auto impulses = flow.take_impulses();
  const FlowConstants constants = flow.arrays().constants;
  // what the forces did to those that were inside when the step began
  Vec2 change;
  double mass = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Before& was = before_[static_cast<std::size_t>(f.id[i])];
    if (!was.inside) continue;
    change = change + f.mass[i] * Vec2{f.u[i], f.w[i]} - was.momentum;
    mass += f.mass[i];
  }
  const Vec2 balance = (dt * mass) * flow.setup().gravity + dt * of_particles(flow, constants) +
                       dt * of_bed(flow, constants) - impulses[bed_cell].force - change;
  const Sample& last = samples_.back();
  samples_.push_back({flow.time(),
                      last.measured + impulses[stem_cell].force + impulses[deflector_cell].force,
                      last.balance + balance});
  remember(flow);
}

ControlVolume::Mean ControlVolume::largest_mean(double window) const {
  Mean largest{0.0, {}, {}};
  std::size_t first = 0;
  for (std::size_t last = 1; last < samples_.size(); ++last) {
    while (first + 1 < last && samples_[last].time - samples_[first + 1].time >= window) ++first;
    const double span = samples_[last].time - samples_[first].time;
    if (span < window * (1.0 - 1e-9)) continue;
    const Vec2 mean = (1.0 / span) * (samples_[last].measured - samples_[first].measured);
    if (norm(mean) <= norm(largest.measured)) continue;
    largest = {samples_[last].time, mean,
               (1.0 / span) * (samples_[last].balance - samples_[first].balance)};
  }
  return largest;
}

}  // namespace parapet::validation
