// What Lobovsky et al. measured in dam breaks of water (2014, J. Fluids Struct. 48:407-434).
#pragma once

#include <array>
#include <vector>

namespace parapet::validation {

// Measured values at increasing times t* = t sqrt(g/H), with their lowest and highest.
struct MeasuredBand {
  std::vector<double> t, low, middle, high;
};

struct MeasuredPeak {
  double median, low, high;  // over the repeated runs: 2.5 and 97.5 % for the latter two
};

struct MeasuredLevel {
  double x = 0.0;  // of the gauge [m]
  MeasuredBand depth;
  double arrival_low = 0.0, arrival_high = 0.0;  // t*; 0: wet from the start
};

// Everything without dimension: depths over H, pressures over rho g H.
struct Lobovsky {
  double tank_length, reservoir_length;        // [m]
  std::array<double, 4> sensor_z;              // of the pressure sensors in the far wall [m]
  std::array<MeasuredLevel, 4> levels;         // H = 0.3 m
  std::vector<double> front_t, front_x;        // H = 0.3 m, x from the gate over H
  std::array<MeasuredPeak, 4> peaks;           // H = 0.3 m
  MeasuredBand sensor_2;                       // H = 0.3 m; middle: the median
  std::vector<double> sensor_1_t, sensor_1_p;  // H = 0.3 m, one run
  double arrival_at_wall = 0.0;                // of the pressures, H = 0.3 m [t*]
  double peak_1_high_dam = 0.0;                // sensor 1, H = 0.6 m, median
  double rise_time = 0.0, decay_time = 0.0;    // of that peak, medians [s]
  double impulse = 0.0;                        // of that peak, median [Pa s]

  // By how much the clock of front and depths runs behind that of the pressures [t*]: the front's
  // last slope goes on to the wall, the pressures rise there.
  double clock_difference(double depth) const;
};

Lobovsky read_lobovsky();

}  // namespace parapet::validation
