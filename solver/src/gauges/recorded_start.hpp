// What a recorder knows of a flow that has not reached anything it looks at: the same for every
// arrangement of barriers.
#pragma once

#include <cstdint>
#include <vector>

#include "gauge_scene.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::solver {

// How far a recorder, and the flow, look upstream: nothing there depends on the barriers.
struct GaugeSight {
  // @param reach of the neighbour rows, skin included [m]
  GaugeSight(const GaugeScene& gauge, double reach);
  // Whether all of a box that reaches from the back wall and the bed to (x, z) is out of sight.
  bool clear(double x, double z) const;

 private:
  std::vector<BarrierLine> lines_;
  double nearest_x_, margin_;  // [m]
};

struct RecordedStart {
  struct Sample {
    double time;                              // [s]
    double kinetic_energy, potential_energy;  // [J/m]
    double front_x;                           // [m]
    double max_speed;                         // [m/s]
    double left_mass;                         // [kg/m]
    std::int64_t inside_walls;                // particles
    double spray_share;                       // of the mass
    double density_error;                     // of the bulk
  };
  struct Step {
    double length, end;  // [s]
  };
  struct Reach {
    double x, z;  // the largest of any particle, not necessarily of the same one [m]
  };
  std::vector<Sample> samples;
  std::vector<Step> steps;
  std::vector<Reach> reaches;  // up to each sample, since the one before

  bool unseen(const GaugeSight& sight) const;
};

// What every recorder reads alike.
RecordedStart::Sample channel_sample(const GaugeScene& g, const Flow& flow);

}  // namespace parapet::solver
