// What was measured in a run, worked out once at its end: the metrics are read off it.
#pragma once

#include <optional>
#include <vector>

#include "backflow.hpp"
#include "barrier_load.hpp"
#include "instant.hpp"
#include "launch.hpp"
#include "parapet/solver/approach.hpp"

namespace parapet::solver {

// The three phases of the kinetic energy in the window: it accumulates until the flow meets the
// barrier, falls in the interaction, rises again with the overflow, and ends in a plateau.
struct EnergyPhases {
  struct Rise {
    double minimum, overflow_peak;  // [J/m]
  };
  double peak = 0.0, peak_time = 0.0;  // [J/m], [s]
  std::optional<Rise> rise;            // the largest after the peak, where it is noticeable
  std::optional<double> plateau_time;  // [s]
};

// `latest_peak` is the time up to which the first peak is looked for [s].
// Nothing when nothing moved.
std::optional<EnergyPhases> energy_phases(const std::vector<double>& time,
                                          const std::vector<double>& energy, double latest_peak);

// Time at which the front passes a place, and its speed there; each where it was seen.
struct FrontPassage {
  std::optional<double> arrival, speed;  // [s], [m/s]
};

// Front speed over front_base: centred on the gauge of an open channel, ending front_clearance
// upstream of a barrier's foot, where neither the stem nor a deflector is in the way yet.
FrontPassage front_passage(const GaugeScene& g, const std::vector<double>& time,
                           const std::vector<double>& front);

// Largest rate at which `retained` (a share) falls over at least `window` [1/s].
double peak_loss_rate(const std::vector<double>& time, const std::vector<double>& retained,
                      double window);

struct DeepestFlow {
  double depth, time;  // [m], [s]
};

// What a barrier holds.
struct HeldDebris {
  DeadZone dead_zone;
  Ramp ramp;
};

// What happened upstream of a barrier since the flow met it.
struct HeldEvents {
  std::optional<double> dead_zone_onset;  // [s]
  Backflow backflow;                      // the largest share, the largest speed
};

struct BarrierReadings {
  double retained = 0.0;          // share of the released mass, at the end
  double run_up = 0.0;            // largest [m]
  std::optional<double> arrival;  // [s]
  BarrierLoads loads;
  std::optional<double> load_height;   // along the stem, where the design load acts [m]
  std::optional<double> impulse;       // over impulse_time from the arrival on [N s/m]
  std::optional<BarrierLoad> at_rest;  // mean over the end of a run until rest
  HeldEvents events;
  std::optional<HeldDebris> held;    // at the end; not while the run goes on
  std::optional<Approach> approach;  // where it is known
};

struct RunReadings {
  GaugeSettings settings;
  double event_length = 0.0;          // H0 [m]
  double spacing = 0.0;               // of the particles [m]
  double particles = 0.0;             // released
  bool unfinished = false;            // the run ended while metrics could still change
  double gravity = 0.0, slope = 0.0;  // [m/s2], [rad]
  double density = 0.0;               // of the material [kg/m3]
  double released_volume = 0.0;       // [m3/m]
  FrontPassage front;
  std::optional<EnergyPhases> energy;
  std::optional<DeepestFlow> deepest;  // in an open channel

  // From here on: with a barrier.
  double first_foot_x = 0.0;               // [m]
  std::optional<double> deflector_length;  // of the first barrier [m]
  double peak_loss_rate = 0.0;             // over the first barrier's line [1/s]
  double dead_zone_length = 0.0;           // [m]
  std::optional<LaunchGauge::Impact> impact;
  std::optional<LaunchGauge::Launch> launch;
  std::optional<LaunchGauge::Sheet> sheet;
  std::optional<InstantReadings> instant;  // at reading_time
  bool instant_wanted = false;
  std::vector<BarrierReadings> barriers;
};

}  // namespace parapet::solver
