#include "run_readings.hpp"

#include <algorithm>

namespace parapet::solver {
namespace {

// Time at which a growing series first reaches a level, linear between samples; negative if never.
double passing_time(const std::vector<double>& time, const std::vector<double>& values,
                    double level) {
  for (std::size_t r = 1; r < values.size(); ++r) {
    if (values[r] >= level && values[r - 1] < level) {
      const double share = (level - values[r - 1]) / (values[r] - values[r - 1]);
      return time[r - 1] + share * (time[r] - time[r - 1]);
    }
  }
  return -1.0;
}

// The largest rise of a series after `from`: where it starts (the dip) and ends (the next peak).
struct Rise {
  std::size_t dip, peak;
  double height;
};

Rise largest_rise(const std::vector<double>& values, std::size_t from) {
  Rise best{from, from, 0.0};
  std::size_t dip = from;
  for (std::size_t r = from; r < values.size(); ++r) {
    if (values[r] < values[dip]) dip = r;
    if (values[r] - values[dip] > best.height) best = {dip, r, values[r] - values[dip]};
  }
  return best;
}

}  // namespace

FrontPassage front_passage(const GaugeScene& g, const std::vector<double>& time,
                           const std::vector<double>& front) {
  const bool open_channel = g.lines.empty();
  const double base = g.length(g.settings.front_base_ratio);
  const double place =
      open_channel ? g.gauge_x : g.gauge_x - g.length(g.settings.front_clearance_ratio);
  const double arrival = passing_time(time, front, place);
  const double from = passing_time(time, front, open_channel ? place - 0.5 * base : place - base);
  const double to = passing_time(time, front, open_channel ? place + 0.5 * base : place);
  FrontPassage passage;
  if (arrival >= 0.0) passage.arrival = arrival;
  if (from >= 0.0 && to > from) passage.speed = base / (to - from);
  return passage;
}

std::optional<EnergyPhases> energy_phases(const std::vector<double>& time,
                                          const std::vector<double>& energy, double latest_peak) {
  constexpr double noticeable_rise = 0.02;  // of the largest energy
  constexpr double plateau_share = 0.05;
  const double largest = *std::max_element(energy.begin(), energy.end());
  if (largest <= 0.0) return std::nullopt;
  std::size_t first = 0;
  for (std::size_t r = 0; r < energy.size() && time[r] <= latest_peak; ++r) {
    if (energy[r] > energy[first]) first = r;
  }
  EnergyPhases phases;
  phases.peak = energy[first];
  phases.peak_time = time[first];
  const Rise rise = largest_rise(energy, first);
  if (rise.height > noticeable_rise * largest) phases.rise = {energy[rise.dip], energy[rise.peak]};
  std::size_t plateau = energy.size();
  while (plateau > first && energy[plateau - 1] < plateau_share * largest) --plateau;
  if (plateau < energy.size()) phases.plateau_time = time[plateau];
  return phases;
}

double peak_loss_rate(const std::vector<double>& time, const std::vector<double>& retained,
                      double window) {
  const double enough = window * (1.0 - 1e-9);
  double peak = 0.0;
  std::size_t from = 0;
  for (std::size_t to = 1; to < time.size(); ++to) {
    while (from + 1 < to && time[to] - time[from + 1] >= enough) ++from;
    if (time[to] - time[from] < enough) continue;
    peak = std::max(peak, (retained[from] - retained[to]) / (time[to] - time[from]));
  }
  return peak;
}

}  // namespace parapet::solver
