// Overflow of the first barrier: who passes its edge, how fast and whereto, and where it lands.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// All of it is judged by mass: the impact is when impact_mass_share of the released mass has landed
// and its place the median of the first launch_mass_share, so that single droplets decide nothing.
// The launch is what that same mass did when it passed the edge.
class LaunchGauge {
 public:
  struct Impact {
    double time;           // [s]
    double x;              // [m]
    double landing_speed;  // [m/s]
  };
  struct Launch {
    double speed;   // of the mean momentum [m/s]
    double angle;   // against the world's horizontal, positive upwards [rad]
    double height;  // mean height above the bed when passing the edge [m]
    double x;       // mean place of that [m]
  };

  // The sheet over the last edge while its discharge, a mean over discharge_time, is largest.
  struct Sheet {
    double speed;      // of the mean momentum [m/s]
    double thickness;  // across that momentum: discharge over speed [m]
  };

  explicit LaunchGauge(const GaugeScene& g) : g_(g) {}
  // After every time step.
  void observe(const Fluid& fluid, double time);
  // Nothing when too little has landed.
  std::optional<Impact> impact() const;
  std::optional<Launch> launch() const;
  // Nothing when less than impact_mass_share of the released mass has passed the edge.
  std::optional<Sheet> sheet() const;
  double landed_share() const { return landed_mass_ / g_.released_mass; }
  // Whether what is in the air beyond the first barrier can still change impact and launch: the
  // first launch_mass_share have not all landed, and with it there would be enough of them.
  bool landing(const Fluid& fluid) const;

 private:
  struct Passage {
    double x, z, u, w;
  };
  struct Passed {
    double time, mass;
    Vec2 momentum;
  };
  struct Discharge {
    double mass = 0.0;
    Vec2 momentum;
  };
  struct Landing {
    double time, mass, x, speed;
    std::int32_t id;
  };

  std::vector<Landing> first_landings() const;
  void watch_sheet(double time);
  double impact_mass() const { return g_.settings.impact_mass_share * g_.released_mass; }
  double place_mass() const { return g_.settings.launch_mass_share * g_.released_mass; }

  const GaugeScene& g_;
  std::vector<char> passed_, landed_;   // [n_released]
  std::vector<Passage> passages_;       // [n_released], where passed
  std::vector<double> approach_speed_;  // [n_released], negative until near the bed
  std::vector<Landing> landings_;
  std::deque<Passed> lately_;  // within discharge_time
  Discharge largest_;
  double passed_mass_ = 0.0;
  double landed_mass_ = 0.0;
};

}  // namespace parapet::solver
