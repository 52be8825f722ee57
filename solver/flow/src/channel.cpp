#include "parapet/flow/channel.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace parapet::solver {
namespace {

void add_channel(Solids& solids, const Scene& scene, double margin) {
  // bed and back wall are unbounded: bodies without an outline
  solids.bodies.push_back({});
  solids.faces.push_back(make_face({0.0, 0.0}, {scene.domain_length + margin, 0.0}, 0, -1));
  solids.bodies.push_back({});
  solids.faces.push_back(make_face({0.0, scene.domain_height + margin}, {0.0, 0.0}, 1, -1));
}

// A random offset of every particle, to measure how far an answer depends on the lattice.
void jitter(std::vector<InitialParticle>& particles, const Numerics& numerics) {
  if (numerics.lattice_jitter == 0.0) return;
  std::mt19937_64 random(numerics.lattice_seed);
  const auto offset = [&] {
    // 53 random bits, the same on every standard library
    const double unit = static_cast<double>(random() >> 11) * 0x1.0p-53;
    return (2.0 * unit - 1.0) * numerics.lattice_jitter * numerics.spacing;
  };
  for (InitialParticle& p : particles) {
    p.x += offset();
    p.z += offset();
  }
}

}  // namespace

FlowSetup channel_setup(const Scene& scene, const Numerics& numerics, int threads) {
  FlowSetup setup;
  setup.numerics = numerics;
  setup.material = scene.material;
  setup.gravity = {scene.gravity * std::sin(scene.slope), -scene.gravity * std::cos(scene.slope)};
  setup.wall_slip = scene.wall_slip;
  setup.outlet_x = scene.domain_length;
  setup.ceiling_z = scene.domain_height;
  setup.n_barriers = 2 * static_cast<int>(scene.barriers.size());
  setup.threads = threads;
  // the paper's sound speed is constant
  setup.adapt_sound_speed =
      numerics.integrator == Integrator::implicit_viscosity && numerics.scheme == Scheme::corrected;
  add_channel(setup.solids, scene, 4.0 * numerics.smoothing_ratio * numerics.spacing);
  for (const SolidPolygon& solid : scene.solids) {
    add_outline(setup.solids, {solid.vertices.rbegin(), solid.vertices.rend()}, -1, false);
  }
  for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
    const int cell = 2 * static_cast<int>(k);
    const std::size_t first = setup.solids.faces.size();
    const Barrier& barrier = scene.barriers[k];
    const Vec2 foot{barrier.foot_x, 0.0}, stem = stem_direction(scene, barrier);
    setup.load_axes.push_back({foot, stem, barrier.height});
    setup.load_axes.push_back({foot + barrier.height * stem, {1.0, 0.0}, 0.0});
    if (barrier.deflector) {
      setup.load_axes.back().direction = deflector_direction(scene, *barrier.deflector);
      setup.load_axes.back().length = barrier.deflector->length;
    }
    add_outline(setup.solids, barrier_outline(scene, scene.barriers[k]), cell, true);
    if (!scene.barriers[k].deflector) continue;
    // between the stem's two faces: the plate's lower face, its tip and its upper face
    for (std::size_t f = first + 1; f + 1 < setup.solids.faces.size(); ++f) {
      setup.solids.faces[f].barrier = cell + 1;
    }
  }
  setup.particles = lattice_block(0.0, 0.0, scene.reservoir_length, scene.reservoir_height,
                                  numerics.spacing, scene.material.density);
  if (numerics.hydrostatic_start) {
    const double c2 = numerics.sound_speed * numerics.sound_speed;
    for (InitialParticle& p : setup.particles) {
      const double pressure =
          scene.material.density * -setup.gravity.z * (scene.reservoir_height - p.z);
      p.density += pressure / c2;
    }
  }
  jitter(setup.particles, numerics);
  return setup;
}

}  // namespace parapet::solver
