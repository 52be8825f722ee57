// Pressures and forces at the wall of the dam break against the measurements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dam_break_groups.hpp"
#include "flow_tools.hpp"

namespace parapet::validation {

double Group::median(const std::function<double(const DamBreakRecord&)>& quantity) const {
  std::vector<double> values;
  for (const DamBreakRecord& r : runs) values.push_back(quantity(r));
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double rise_window(const Lobovsky& m, double depth) {
  return m.rise_time / std::sqrt(depth / gravity);
}

std::vector<double> sensor_2(const DamBreakRecord& r, const Lobovsky& m) {
  const double window = m.sensor_2.t[1] - m.sensor_2.t[0];
  std::vector<double> values;
  for (const double t : m.sensor_2.t) {
    values.push_back(r.pressure[1].mean_around(t - m.arrival_at_wall + r.arrival, 0.5 * window));
  }
  return values;
}

void add_peaks(CaseRun& run, const std::vector<Group>& spacings, const Lobovsky& m) {
  const Group& finest = spacings.back();
  const double window = rise_window(m, finest.dam.depth);
  run.add({.key = "arrival_wall",
           .what = fmt::format("rise of the pressure at the wall, {}: computed minus measured, t*",
                               finest.name),
           .value =
               finest.median([](const DamBreakRecord& r) { return r.arrival; }) - m.arrival_at_wall,
           .lower = -0.1,
           .upper = 0.1,
           .reason = "as for the depths"});
  const std::string tip =
      "single particles of the thin tip strike at the sound speed of the computation and the water "
      "rings after it";
  const std::string jet =
      "the computed jet is thin and smooth up here, the real one thick with air and spray";
  for (std::size_t s = 0; s < 4; ++s) {
    run.add(
        {.key = fmt::format("peak_{}", s + 1),
         .what = fmt::format("peak pressure at sensor {}, {}: median of {} runs, mean over 7 ms",
                             s + 1, finest.name, finest.runs.size()),
         .value = finest.median([&](const DamBreakRecord& r) { return r.peak(s, window); }),
         .lower = m.peaks[s].low,
         .upper = m.peaks[s].high,
         .reason = fmt::format("measured, 2.5 to 97.5 %; median {}", m.peaks[s].median),
         .explanation = s < 3 ? tip : jet});
  }
  for (std::size_t s = 0; s < 4; ++s) {
    for (const Group& g : spacings) {
      if (&g == &finest) continue;
      run.add({.key = fmt::format("peak_{}_{}", s + 1, g.key),
               .what = fmt::format("peak pressure at sensor {}, {}", s + 1, g.name),
               .value = g.median([&](const DamBreakRecord& r) { return r.peak(s, window); })});
    }
  }
  const auto peak_1 = [&](const DamBreakRecord& r) { return r.peak(0, window); };
  double low = peak_1(finest.runs[0]), high = low;
  for (const DamBreakRecord& r : finest.runs) {
    low = std::min(low, peak_1(r));
    high = std::max(high, peak_1(r));
  }
  run.add({.key = "peak_1_lowest",
           .what = fmt::format("sensor 1, {}: lowest peak of these runs", finest.name),
           .value = low});
  run.add({.key = "peak_1_highest",
           .what = fmt::format("sensor 1, {}: highest peak of these runs", finest.name),
           .value = high});
  run.add({.key = "peak_1_unfiltered",
           .what = fmt::format("sensor 1, {}: median peak without the mean over 7 ms", finest.name),
           .value = finest.median([](const DamBreakRecord& r) {
             double largest = 0.0;
             for (std::size_t k = 0; k < r.pressure[0].t.size(); ++k) {
               if (r.pressure[0].t[k] <= r.arrival + 1.0)
                 largest = std::max(largest, r.pressure[0].value[k]);
             }
             return largest;
           })});
}

double decay_difference(const DamBreakRecord& r, const Lobovsky& m) {
  const std::vector<double> all = sensor_2(r, m);
  std::vector<double> computed, median;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (m.sensor_2.t[k] < 2.55 || m.sensor_2.t[k] > 5.55) continue;
    computed.push_back(all[k]);
    median.push_back(m.sensor_2.middle[k]);
  }
  return rms_difference(computed, median);
}

void add_decay(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
               const Lobovsky& m) {
  const Group& finest = spacings.back();
  const Series measured{m.sensor_2.t, m.sensor_2.middle};
  double width = 0.0, count = 0.0;
  for (std::size_t k = 0; k < m.sensor_2.t.size(); ++k) {
    if (m.sensor_2.t[k] < 2.55 || m.sensor_2.t[k] > 5.55) continue;
    width += 0.5 * (m.sensor_2.high[k] - m.sensor_2.low[k]);
    count += 1.0;
  }
  const double late =
      finest.median([](const DamBreakRecord& r) { return r.arrival; }) - m.arrival_at_wall;
  const double early = finest.median([&](const DamBreakRecord& r) {
    return r.pressure[1].integral(r.arrival + 0.15, r.arrival + 0.55);
  }) / measured.integral(m.arrival_at_wall + 0.15, m.arrival_at_wall + 0.55);
  const double plateau = finest.whole().pressure[1].integral(4.0 + late, 5.0 + late);
  const double measured_plateau = measured.integral(4.0, 5.0);
  const double head = finest.whole().head.integral(4.0, 5.0);
  const std::string explanation = fmt::format(
      "no friction at the walls: the stream brings the head it has, {:.2f} at H4 in t* = 4 to 5 "
      "and "
      "more at the wall since it slows down, where {:.2f} was measured. With no-slip walls ({}) it "
      "is "
      "{:.2f}, and the RMS difference {:.2f}",
      head, measured_plateau, no_slip.name, no_slip.whole().pressure[1].integral(4.0, 5.0),
      decay_difference(no_slip.whole(), m));
  run.add({.key = "decay_early",
           .what = fmt::format("sensor 2, {}, t* = 2.6 to 3: mean pressure over that of the "
                               "measured median",
                               finest.name),
           .value = early,
           .lower = 0.85,
           .upper = 1.15,
           .reason = "the measured band is 13 to 18 % wide on either side here",
           .explanation = "no friction: the pressure goes with the square of the front's speed, "
                          "which is above the measured (see there)"});
  run.add({.key = "decay_rms",
           .what = fmt::format("sensor 2, {}, t* = 2.6 to 5.5: RMS difference from the median",
                               finest.name),
           .value = decay_difference(finest.whole(), m),
           .upper = width / count,
           .reason = "the mean half width of the measured band",
           .explanation = explanation});
  run.add({.key = "plateau",
           .what = fmt::format("sensor 2, {}, t* = 4 to 5: mean pressure", finest.name),
           .value = plateau});
  run.add(
      {.key = "plateau_measured", .what = "the same, measured median", .value = measured_plateau});
  run.add(
      {.key = "head",
       .what = fmt::format("head (h + u^2/2g)/H of the stream at H4, {}, t* = 4 to 5", finest.name),
       .value = head});
}

void add_forces(CaseRun& run, const std::vector<Group>& spacings, const Lobovsky& m) {
  for (const Group& g : spacings) {
    run.add({.key = fmt::format("force_{}", &g == &spacings.back() ? "finest" : g.key),
             .what = fmt::format(
                 "peak force on the wall over rho g H^2, {}: median, mean over 7 ms", g.name),
             .value = g.median([&](const DamBreakRecord& r) {
               return r.peak_force(rise_window(m, g.dam.depth));
             })});
  }
  const auto impulse = [](const DamBreakRecord& r) {
    return r.impulse.at(r.arrival + 1.0) - r.impulse.at(r.arrival);
  };
  const double finest = spacings.back().median(impulse);
  const double coarser = spacings[spacings.size() - 2].median(impulse);
  run.add({.key = "impulse",
           .what = fmt::format("impulse on the wall in one t* after the arrival, {}",
                               spacings.back().name),
           .value = finest});
  run.add({.key = "impulse_change",
           .what = "the same: change from the next coarser spacing",
           .value = 100.0 * (finest / coarser - 1.0),
           .unit = "%",
           .lower = -5.0,
           .upper = 5.0,
           .reason = "the arriving momentum does not depend on the peaks: the limit of the depths",
           .explanation = "a finer tip is thinner: less water arrives in the first unit of time"});
}

void add_high_dam(CaseRun& run, const Group& g, const Lobovsky& m) {
  const double unit = std::sqrt(g.dam.depth / gravity), p = water_density * gravity * g.dam.depth;
  const double low = m.peaks[0].low / m.peaks[0].median, high = m.peaks[0].high / m.peaks[0].median;
  const std::string reason =
      "the measured spread of sensor 1 about its median at 0.3 m; none is "
      "published for 0.6 m";
  run.add({.key = "high_peak",
           .what = fmt::format("H = 0.6 m, {}: peak at sensor 1 over the measured median", g.name),
           .value = g.median([&](const DamBreakRecord& r) {
             return r.peak(0, rise_window(m, g.dam.depth));
           }) / m.peak_1_high_dam,
           .lower = low,
           .upper = high,
           .reason = reason,
           .explanation = "as for the peaks at 0.3 m"});
  const double time = (m.rise_time + m.decay_time) / unit;
  run.add({.key = "high_impulse",
           .what = fmt::format("H = 0.6 m, {}: impulse of sensor 1 over rise and decay time, over "
                               "the measured median",
                               g.name),
           .value = g.median([&](const DamBreakRecord& r) {
             return r.pressure[0].integral(r.arrival, r.arrival + time) * p * unit;
           }) / m.impulse,
           .lower = low,
           .upper = high,
           .reason = reason,
           .explanation = "as for the peaks at 0.3 m"});
}

}  // namespace parapet::validation
