// What a flow does with its walls: loads on the barriers, the contact rule, and the count of
// particles where none may be.
#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/flow/index.hpp"
#include "parapet/flow/stage_timer.hpp"
#include "wall_contact.hpp"

namespace parapet::solver {
namespace {

// Where the moments of a solid are taken about: its foot, or the start of an unbounded wall.
Vec2 moment_center(const Solids& solids, const Face& face) {
  const std::vector<Vec2>& outline = solids.bodies[at(face.body)].outline;
  return outline.empty() ? face.a : outline.front();
}

}  // namespace

void Flow::measure_barrier_load(double dt) {
  if (impulses_.empty()) return;
  const StageScope scope(setup_.timer, Stage::wall_load);
  pack(&Fluid::pack_motion);
  const FlowArrays a = packed_arrays();
  const std::int32_t* active = a.rows.active_wall;
  auto first = static_cast<int>(
      std::lower_bound(active, active + a.rows.n_active, first_barrier_point_) - active);
  first -= first % lanes;  // a whole group
  load_x_.resize(at(a.rows.n_active));
  load_z_.resize(at(a.rows.n_active));
  for_blocks(a.rows.n_active - first, threads(), [&](int begin, int end) {
    passes_.wall_load(a, load_x_.data(), load_z_.data(), first + begin, first + end);
  });
  for (int s = first; s < a.rows.n_active; ++s) {
    const auto k = at(active[s]);
    const Face& face = setup_.solids.faces[at(walls_.owner[k])];
    if (face.barrier < 0) continue;
    BarrierImpulse& impulse = impulses_[at(face.barrier)];
    const Vec2 force{load_x_[at(s)], load_z_[at(s)]};
    const Vec2 arm = Vec2{walls_.x[k], walls_.z[k]} - moment_center(setup_.solids, face);
    impulse.force = impulse.force + dt * force;
    add_to_strip(face.barrier, {walls_.x[k], walls_.z[k]}, dt * force);
    impulse.moment -= dt * cross(arm, force);  // clockwise is downstream
  }
}

std::vector<BarrierImpulse> Flow::take_impulses() {
  std::vector<BarrierImpulse> taken(impulses_.size());
  taken.swap(impulses_);
  return taken;
}

std::vector<Vec2> Flow::take_strip_impulses() {
  std::vector<Vec2> taken(strip_impulses_.size());
  taken.swap(strip_impulses_);
  return taken;
}

void Flow::add_to_strip(int load_cell, Vec2 place, Vec2 impulse) {
  if (at(load_cell) >= setup_.load_axes.size()) return;
  const int strip = setup_.load_axes[at(load_cell)].strip(place, setup_.numerics.spacing);
  if (strip < 0) return;
  Vec2& sum = strip_impulses_[at(first_strip_[at(load_cell)] + strip)];
  sum = sum + impulse;
}

int LoadAxis::strips(double spacing) const {
  // as many as there are wall points along a face of this length
  return static_cast<int>(std::ceil(length / spacing - 1e-6));
}

int LoadAxis::strip(Vec2 place, double spacing) const {
  const int last = strips(spacing) - 1;
  const double along = std::floor(dot(place - start, direction) / spacing);
  return std::min(static_cast<int>(std::max(along, 0.0)), last);
}

void Flow::stop_at_walls() {
  const StageScope scope(setup_.timer, Stage::wall_contact);
  const WallContact contact{setup_.solids.faces, 0.02 * setup_.numerics.spacing};
  for (int i = 0; i < fluid_.n; ++i) {
    if (!rows_.touches_wall(i)) continue;
    const auto k = at(i);
    const Vec2 before{x_before_[k], z_before_[k]};
    if (rows_.clear_of_faces(i, before, {fluid_.x[k], fluid_.z[k]})) continue;
    const std::vector<int>& faces = rows_.faces_near(before);
    ParticleMotion motion{before, {fluid_.x[k], fluid_.z[k]}, {fluid_.u[k], fluid_.w[k]}};
    const int face = contact.apply(motion, faces);
    if (face < 0) continue;
    ++now_.statistics.wall_contacts;
    const int barrier = setup_.solids.faces[at(face)].barrier;
    if (barrier >= 0) {
      const Vec2 lost = Vec2{fluid_.u[k], fluid_.w[k]} - motion.velocity;
      BarrierImpulse& impulse = impulses_[at(barrier)];
      const Vec2 foot = moment_center(setup_.solids, setup_.solids.faces[at(face)]);
      impulse.force = impulse.force + fluid_.mass[k] * lost;
      add_to_strip(barrier, motion.after, fluid_.mass[k] * lost);
      impulse.moment -= fluid_.mass[k] * cross(motion.after - foot, lost);
    }
    fluid_.x[k] = motion.after.x;
    fluid_.z[k] = motion.after.z;
    fluid_.u[k] = motion.velocity.x;
    fluid_.w[k] = motion.velocity.z;
  }
}

int Flow::particles_inside_walls() const {
  int inside = 0;
  for (std::size_t i = 0; i < at(fluid_.n); ++i) {
    const Vec2 p{fluid_.x[i], fluid_.z[i]};
    bool bad = false;
    for (const Face& face : setup_.solids.faces) {
      if (!setup_.solids.bodies[at(face.body)].outline.empty()) continue;
      bad = bad || dot(p - face.a, face.normal) <= 0.0;  // unbounded walls are whole half planes
    }
    for (const Body& body : setup_.solids.bodies) {
      bad = bad || (!body.outline.empty() && inside_polygon(body.outline, p));
    }
    inside += bad;
  }
  return inside;
}

}  // namespace parapet::solver
