// Dam breaks repeated from different lattices, and what is read from them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case.hpp"
#include "dam_break_flow.hpp"
#include "lobovsky.hpp"

namespace parapet::validation {

// Equal dam breaks from different lattices; the first goes on to t* = 8.
struct Group {
  std::string key, name;
  DamBreak dam;
  std::vector<DamBreakRecord> runs = {};

  const DamBreakRecord& whole() const { return runs.front(); }
  double median(const std::function<double(const DamBreakRecord&)>& quantity) const;
};

// 7 ms: the median time in which the measured pressure of sensor 1 rises [t*]. Shorter is the noise
// of single particles that meet the wall at the sound speed of the computation.
double rise_window(const Lobovsky& m, double depth);

// Sensor 2 at the times of the published median and smoothed like it, on the pressure's arrival.
std::vector<double> sensor_2(const DamBreakRecord& r, const Lobovsky& m);

// RMS difference of sensor 2 from the measured median, t* = 2.6 to 5.5.
double decay_difference(const DamBreakRecord& r, const Lobovsky& m);

// Rows of the scorecard. `spacings` from coarse to fine; `no_slip`: walls with friction, which
// explains what walls without it miss.
void add_depths(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
                const Lobovsky& m);
void add_peaks(CaseRun& run, const std::vector<Group>& spacings, const Lobovsky& m);
void add_decay(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
               const Lobovsky& m);
void add_forces(CaseRun& run, const std::vector<Group>& spacings, const Lobovsky& m);
void add_high_dam(CaseRun& run, const Group& high, const Lobovsky& m);
void add_influences(CaseRun& run, const std::vector<const Group*>& groups, const Lobovsky& m);
void add_balances(CaseRun& run, const Group& finest);

// Figures.
void draw_depths(CaseRun& run, const Group& finest, const Lobovsky& m);
void draw_pressures(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
                    const Lobovsky& m);
void draw_flow(CaseRun& run, const Group& group);

}  // namespace parapet::validation
