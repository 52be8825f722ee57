// What gauges need to know of the scene, worked out once.
#pragma once

#include <vector>

#include "parapet/flow/geometry.hpp"
#include "parapet/solver/gauge_settings.hpp"

namespace parapet::solver {

// A barrier's line: through its foot, along its stem, without end.
struct BarrierLine {
  Vec2 foot;
  Vec2 downstream;                                                   // unit normal
  double offset(Vec2 p) const { return dot(p - foot, downstream); }  // positive downstream [m]
};

struct GaugeScene {
  const Scene* scene = nullptr;
  std::vector<BarrierLine> lines;
  std::vector<BarrierLine> edges;  // parallel, through the last edge that guides the flow
  double gauge_x = 0.0;            // first foot, or the monitored place [m]
  double released_mass = 0.0;      // [kg/m]
  double spacing = 0.0;            // [m]
  GaugeSettings settings;
  EventUnits units = event_units(Scene{}, GaugeSettings{});

  double length(double ratio) const { return ratio * units.length; }  // [m]
  double time(double ratio) const { return ratio * units.time; }      // [s]
  double speed(double ratio) const { return ratio * units.speed; }    // [m/s]
};

}  // namespace parapet::solver
