// Particles placed by hand in a level channel, so that channel axes are the world's.
#pragma once

#include <vector>

#include "gauges/gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// A stem normal to the bed at x = 1 m and 1 kg/m of released material of 1000 kg/m3.
struct LevelChannel {
  Scene scene;
  GaugeScene gauge;

  LevelChannel() {
    scene.slope = 0.0;
    scene.material.density = 1000.0;
    gauge.scene = &scene;
    gauge.lines = {{{1.0, 0.0}, {1.0, 0.0}}};
    gauge.gauge_x = 1.0;
    gauge.released_mass = 1.0;
    gauge.spacing = 0.005;
  }
  LevelChannel(const LevelChannel&) = delete;  // the gauge points at the scene
  LevelChannel& operator=(const LevelChannel&) = delete;

  const BarrierLine& line() const { return gauge.lines.front(); }
};

struct Placed {
  double x, z;  // [m]
  double mass;  // [kg/m]
  double u = 0.0, w = 0.0;
};

inline Fluid fluid_of(const std::vector<Placed>& placed) {
  std::vector<InitialParticle> particles;
  for (const Placed& p : placed) particles.push_back({p.x, p.z, p.u, p.w, 1000.0, p.mass});
  Fluid fluid;
  fluid.assign(particles);
  return fluid;
}

}  // namespace parapet::solver
