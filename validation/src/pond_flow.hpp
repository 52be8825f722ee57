// A pond of debris behind a stem: the static limit of a thin layer, and the flow that settles to
// it.
#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "parapet/solver/scene.hpp"
#include "particle_picture.hpp"

namespace parapet::validation::ponds {

constexpr double bin = 0.02;  // over which depths are averaged [m]

// Depth against the distance s upstream of the stem, where it equals the stem's height. The layer
// is about to flow downstream and the bed carries tau_y: rho g cos a h dh/dx = rho g sin a h -
// tau_y, that is dh/dx = tan a (1 - h_c/h) with h_c = tau_y/(rho g sin a) and x downstream.
// `stretching`: 0 for the thin layer; +1 or -1 adds the normal stresses, (pi/2) tau_y h, of a layer
// that is drawn out or pressed together, the theory's next order.
class StaticLimit {
 public:
  StaticLimit(const solver::Scene& scene, double height, double length, double stretching = 0.0);
  double depth(double s) const;
  double volume() const;

 private:
  double length_;
  std::vector<double> depth_;
};

struct Pond {
  double height;   // of the stem [m]
  double length;   // from the back wall to the stem [m]
  double spacing;  // [m]
  double cutoff;   // [1/s]
  bool skimmed;    // what rises above the crest's level is taken away
};

struct Outcome {
  std::vector<double> time, volume;  // held [m2]
  std::vector<double> x, surface;    // depths at the end [m]
  double thrust = 0.0;               // on the stem, mean of the last 2 s [N/m]
  double depth_at_stem = 0.0;        // at the end [m]
  double speed = 0.0;                // largest upstream of the stem at the end [m/s]
  double mass_change = 0.0;
  int inside = 0;
  ParticlePanel panel;
  std::vector<solver::Face> walls;
};

solver::Scene scene_of(const Pond& pond);

Outcome computed(const Pond& pond, const CaseRun& run);

// A uniform layer a quarter deeper than h_c, in rows of particles: its speed at the surface over
// the exact one of Herschel-Bulkley flow. The sheared part below the plug is a fifth of the depth.
double layer_speed(int rows, const CaseRun& run);

}  // namespace parapet::validation::ponds
