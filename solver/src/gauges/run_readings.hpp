// What was measured in a run, worked out once at its end: the metrics are read off it.
#pragma once

#include <optional>
#include <vector>

#include "barrier_load.hpp"
#include "launch.hpp"

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

// `met` is the time at which the flow meets the first barrier [s], negative in an open channel.
// Nothing when nothing moved.
std::optional<EnergyPhases> energy_phases(const std::vector<double>& time,
                                          const std::vector<double>& energy, double met);

// Time at which the front passes a place, and its speed there; each where it was seen.
struct FrontPassage {
  std::optional<double> arrival, speed;  // [s], [m/s]
};

// Front speed over 0.1 m: centred on the gauge of an open channel, ending 0.15 m upstream of a
// barrier's foot, where neither the stem nor a deflector is in the way yet.
FrontPassage front_passage(const std::vector<double>& time, const std::vector<double>& front,
                           double gauge_x, bool open_channel);

// Largest rate at which `retained` (a share) falls over at least 20 ms [1/s].
double peak_loss_rate(const std::vector<double>& time, const std::vector<double>& retained);

struct DeepestFlow {
  double depth, time;  // [m], [s]
};

struct BarrierReadings {
  double retained = 0.0;          // share of the released mass, at the end
  double run_up = 0.0;            // largest [m]
  std::optional<double> arrival;  // [s]
  PeakLoad peak;
};

struct RunReadings {
  double gravity = 0.0, slope = 0.0;  // [m/s2], [rad]
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
  std::vector<BarrierReadings> barriers;
};

}  // namespace parapet::solver
