// A heap of debris that slumps and stops: thin-layer theory to two orders, and the flow.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "case.hpp"
#include "parapet/solver/scene.hpp"
#include "particle_picture.hpp"

namespace parapet::validation::slumps {

using solver::Material;

constexpr double gravity = 9.81;     // [m/s2]
constexpr double volume = 0.06;      // [m2], the channel's reservoir
constexpr double front_depth = 0.2;  // the front is read at this share of the theory's h(0)

// Thin layer at rest: the bed carries tau_y everywhere, rho g h |h'| = tau_y. To the next order the
// layer also stretches: its normal stresses carry (pi/2) tau_y h, so that
// rho g h |h'| = tau_y (1 + pi/2 |h'|). `order` 0 or 1.
class Arrested {
 public:
  Arrested(const Material& m, int order)
      : a_(m.density * gravity / (2.0 * m.yield_stress)),
        b_(order == 0 ? 0.0 : 0.5 * std::numbers::pi) {
    // V = 2/3 a h0^3 - b/2 h0^2
    double low = 0.0, high = 10.0;
    for (int k = 0; k < 100; ++k) {
      h0_ = 0.5 * (low + high);
      (2.0 / 3.0 * a_ * h0_ * h0_ * h0_ - 0.5 * b_ * h0_ * h0_ < volume ? low : high) = h0_;
    }
  }
  double depth_at_wall() const { return h0_; }
  // Where the depth is h.
  double position(double h) const { return (a_ * h0_ - b_) * h0_ - (a_ * h - b_) * h; }
  // Depth at x, behind the front.
  double depth(double x) const {
    // a h^2 - b h = X(0) - x, the larger root
    const double rest = std::max(position(0.0) - x, 0.0);
    return (b_ + std::sqrt(b_ * b_ + 4.0 * a_ * rest)) / (2.0 * a_);
  }
  double front() const { return position(front_depth * h0_); }
  // At the same depth as that theory's front.
  double front_at(const Arrested& other) const { return position(front_depth * other.h0_); }

 private:
  double a_, b_, h0_ = 0.0;
};

// Viscosity only decides how fast the heap comes to rest. It flows with a large consistency first,
// so that inertia plays no part, and comes to rest with a small one.
struct Stage {
  double consistency;  // [Pa s^N]
  double time;         // [s]
};

struct Heap {
  const char* key;
  const char* name;
  double yield_stress;  // [Pa]
  std::vector<Stage> stages;
};

struct Slump {
  const Heap* heap;
  double cutoff;   // [1/s]
  double spacing;  // [m]
};

struct Outcome {
  std::vector<double> time, front;  // [s], [m]
  std::vector<double> x, depth;     // profile at the end [m]
  double front_speed = 0.0;         // over the last 5 s [m/s]
  double inertia = 0.0;             // largest rho u^2/2 over tau_y after the first stage
  double mass_change = 0.0, momentum_error = 0.0;
  double energy_lost = 0.0, dissipated = 0.0;  // [J/m]
  int inside = 0;
  std::vector<ParticlePanel> panels;
  std::vector<solver::Face> walls;
};

Material material_of(const Slump& slump);

Outcome computed(const Slump& slump, const CaseRun& run);

// rms of depth minus theory over the heap, relative to the theory's depth at the wall.
double profile_error(const Outcome& o, const Arrested& theory);

}  // namespace parapet::validation::slumps
