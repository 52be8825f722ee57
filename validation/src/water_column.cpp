// Collapse of a column of water twice as high as its base, against the measurements of Martin and
// Moyce (1952, Phil. Trans. R. Soc. A 244:312-324, Tables 2 and 6): the front along the floor and
// the height at the back wall.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "embedded.hpp"
#include "flow_tools.hpp"
#include "parapet/reports/line_plot.hpp"
#include "particle_picture.hpp"
#include "water.hpp"

namespace parapet::validation {
namespace {

constexpr double base = 0.05715;  // a [m]: 2 1/4 inches
constexpr double depth = 2.0 * base;
constexpr int pictured_across = 40;

struct Curve {
  std::vector<double> time, value;
};

struct Measured {
  Curve front, height;
};

Measured measured() {
  const auto json = nlohmann::json::parse(embedded_text("martin_moyce_1952.json"));
  const auto column = [&](const char* what, const char* key) {
    return json.at(what).at(key).get<std::vector<double>>();
  };
  return {{column("front", "T"), column("front", "Z")},
          {column("height", "tau"), column("height", "H")}};
}

// One spacing. Front against T = n t sqrt(g/a), height against tau = t sqrt(g/a).
struct Collapse {
  Series front, height;
  double mass_change = 0.0, momentum_error = 0.0, numerical_share = 0.0;
  std::vector<ParticlePanel> panels;
  std::vector<solver::Face> walls;
};

WaterTank tank_of(int across_depth) {
  WaterTank tank;
  tank.column_length = base;
  tank.column_depth = depth;
  tank.length = 18.0 * base;  // the front would need twice the time to reach its end
  tank.wall_height = 1.5 * depth;
  tank.spacing = depth / across_depth;
  tank.sound_speed = 20.0 * std::sqrt(gravity * depth);
  tank.viscosity = viscosity_of_alpha(tank, 0.01);
  return tank;
}

Collapse collapse(int across_depth, double shifting, bool with_pictures, const CaseRun& run) {
  WaterTank tank = tank_of(across_depth);
  tank.shifting = shifting;
  solver::Flow flow(water_setup(tank));
  Balance balance(flow);
  Collapse result;
  result.walls = flow.solids().faces;
  const double unit = std::sqrt(base / gravity);  // [s]
  const double available = available_energy(tank);
  std::vector<double> pictured = with_pictures ? std::vector{0.8, 1.6, 2.8} : std::vector<double>{};
  double next = 0.0;
  follow(flow, 5.3 * unit, run, balance, [&](solver::Flow& f) {
    const double tau = f.time() / unit;
    if (tau < next) return;
    next += 0.02;
    result.front.add(std::sqrt(2.0) * tau, front_position(f, 5e-4) / base);
    result.height.add(tau, depth_at(f, 0.05 * base, 0.1 * base, 0.2 * depth) / depth);
    if (!pictured.empty() && tau >= pictured.front()) {
      result.panels.push_back(speed_panel(f, fmt::format("t sqrt(g/a) = {:.1f}", tau)));
      pictured.erase(pictured.begin());
    }
  });
  result.mass_change = balance.mass_change(flow);
  result.momentum_error = balance.momentum_error(flow);
  result.numerical_share = balance.numerical_share(flow, available);
  return result;
}

double rms_at_delay(const Series& computed, const Curve& table, double delay) {
  std::vector<double> values;
  for (const double t : table.time) values.push_back(computed.at(t - delay));
  return rms_difference(values, table.value);
}

// The delay of the table's clock behind the computed one that brings the two closest.
double fitted_delay(const Series& computed, const Curve& table) {
  double best = 0.0, least = rms_at_delay(computed, table, 0.0);
  for (int k = -400; k <= 400; ++k) {
    const double delay = 0.0025 * k, rms = rms_at_delay(computed, table, delay);
    if (rms < least) {
      least = rms;
      best = delay;
    }
  }
  return best;
}

// What one quantity of one spacing is held against.
struct Limits {
  double rms_shifted, delay;
  const char *reason_rms, *reason_delay;
};

void add_rows(CaseRun& run, const char* key, const char* name, const char* time, const Curve& table,
              const Series& computed, int across, const Limits* limits) {
  const double delay = fitted_delay(computed, table);
  const std::string level = limits ? std::string("finest") : fmt::format("{}", across);
  run.add({.key = fmt::format("{}_raw_{}", key, level),
           .what = fmt::format("{}, {} particles over the depth: RMS difference on the table's own "
                               "clock",
                               name, across),
           .value = rms_at_delay(computed, table, 0.0)});
  Measure shift{.key = fmt::format("{}_delay_{}", key, level),
                .what = fmt::format("{}, {} over the depth: delay of the table's clock that fits "
                                    "best, in {}",
                                    name, across, time),
                .value = delay};
  Measure rms{
      .key = fmt::format("{}_shifted_{}", key, level),
      .what = fmt::format("{}, {} over the depth: RMS difference after that delay", name, across),
      .value = rms_at_delay(computed, table, delay)};
  if (limits) {
    shift.lower = -limits->delay;
    shift.upper = limits->delay;
    shift.reason = limits->reason_delay;
    rms.upper = limits->rms_shifted;
    rms.reason = limits->reason_rms;
  }
  run.add(shift);
  run.add(rms);
}

void plot(CaseRun& run, const char* file, const char* title, const char* x, const char* y,
          const Curve& table, const std::vector<Collapse>& runs, const std::vector<int>& across,
          Series Collapse::*quantity) {
  reports::LinePlot p;
  p.title = title;
  p.x_label = x;
  p.y_label = y;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Series& s = runs[k].*quantity;
    p.series.push_back({fmt::format("{} over the depth", across[k]), s.t, s.value,
                        reports::SeriesStyle::line, static_cast<int>(k) + 1});
  }
  p.series.push_back(
      {"Martin and Moyce 1952", table.time, table.value, reports::SeriesStyle::markers, 0});
  p.x_limits = {0.0, 1.05 * table.time.back()};
  p.y_limits = {0.0, 1.25 * std::max(table.value.back(), 1.0)};
  p.width_px = 800;
  p.height_px = 480;
  draw_line_plot(run.figure(file), p);
}

}  // namespace

void water_column(CaseRun& run) {
  const std::vector<int> across = run.full() ? std::vector{20, 40, 80} : std::vector{10, 20, 40};
  std::vector<Collapse> runs(across.size());
  const std::size_t last = runs.size() - 1;
  Collapse unshifted;  // at the middle spacing, to see what the momentum owes to the shifting
  run.side_by_side(
      runs.size() + 1,
      [&](std::size_t k) {
        if (k == runs.size()) {
          unshifted = collapse(across[last - 1], 0.0, false, run);
          return;
        }
        const std::size_t level = last - k;  // the dearest first
        runs[level] = collapse(across[level], 1.0, across[level] == pictured_across, run);
      },
      run.full() ? std::vector{18.0, 2.5, 0.4, 2.5} : std::vector{2.5, 0.4, 0.1, 0.4});
  const Measured table = measured();
  const Limits front{0.11, 0.43, "the table reads the front in steps of 0.22",
                     "the longest time between two readings of the table, its first: the time "
                     "origin is not known better"};
  const Limits height{0.05, 0.43,
                      "as for the depths of dam_break; the table reads in steps of 0.055",
                      "as for the front"};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    add_rows(run, "front", "front Z", "T", table.front, runs[k].front, across[k],
             k == last ? &front : nullptr);
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    add_rows(run, "height", "height H", "tau", table.height, runs[k].height, across[k],
             k == last ? &height : nullptr);
  }
  const Collapse& finest = runs.back();
  const double spread = std::abs(runs[last].front.at(3.0) - runs[last - 1].front.at(3.0));
  run.add({.key = "front_convergence",
           .what = "front Z at T = 3: change between the two finest spacings",
           .value = spread,
           .upper = 0.11,
           .reason = "less than the resolution of the table"});
  const auto speed = [](const Series& s) { return (s.at(3.2) - s.at(2.4)) / 0.8; };
  Series tabled{table.front.time, table.front.value};
  run.add({.key = "front_speed",
           .what = "front, T = 2.4 to 3.2: dZ/dT computed over measured",
           .value = speed(finest.front) / speed(tabled),
           .lower = 0.85,
           .upper = 1.15,
           .reason = "two readings of half a step of 0.22 over the 1.3 between them"});
  run.add({.key = "mass",
           .what = "change of the mass",
           .value = finest.mass_change,
           .lower = -1e-12,
           .upper = 1e-12,
           .reason = "particles exchange equal and opposite masses; rounding of the sum"});
  const auto add_momentum = [&](const std::string& key, const std::string& of, double error) {
    run.add(
        {.key = key,
         .what = "momentum not explained by gravity and wall forces, " + of,
         .value = 100.0 * error,
         .unit = "%",
         .upper = 1.0,
         .reason =
             "share of the impulse of gravity; pair forces (except those of the "
             "tensile-instability control) and what shifting exchanges are equal and opposite"});
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    add_momentum(k == last ? std::string("momentum_finest") : fmt::format("momentum_{}", across[k]),
                 fmt::format("{} over the depth", across[k]), runs[k].momentum_error);
  }
  add_momentum("momentum_unshifted",
               fmt::format("{} over the depth, without shifting", across[last - 1]),
               unshifted.momentum_error);
  const auto add_energy = [&](const std::string& key, const std::string& of, double share) {
    run.add({.key = key,
             .what = "energy lost but not dissipated by viscosity, share of what the column has "
                     "above the state at rest, " +
                     of,
             .value = 100.0 * share,
             .unit = "%",
             .lower = -0.5,
             .upper = 3.0,
             .reason = "no breaking here: density diffusion and shifting must take little energy "
                       "and give none",
             .explanation = "the row without shifting shows its share"});
  };
  add_energy("energy", fmt::format("{} over the depth", across.back()), finest.numerical_share);
  add_energy("energy_coarser", fmt::format("{} over the depth", across[last - 1]),
             runs[last - 1].numerical_share);
  add_energy("energy_unshifted",
             fmt::format("{} over the depth, without shifting", across[last - 1]),
             unshifted.numerical_share);
  plot(run, "front.png", "Front of the collapsing column", "T = n t sqrt(g/a)", "Z = z/a",
       table.front, runs, across, &Collapse::front);
  plot(run, "height.png", "Height at the back wall", "tau = t sqrt(g/a)", "H = eta/(n^2 a)",
       table.height, runs, across, &Collapse::height);
  const auto pictured =
      std::ranges::find_if(runs, [](const Collapse& c) { return !c.panels.empty(); });
  ParticlePicture picture;
  picture.title = fmt::format("Column of water, {} particles over the depth", pictured_across);
  picture.quantity = fmt::format("speed [m/s]");
  picture.low = 0.0;
  picture.high = 2.0;
  picture.spacing = depth / pictured_across;
  picture.walls = pictured->walls;
  picture.window_from = {-0.1 * base, -0.1 * base};
  picture.window_to = {6.0 * base, 2.1 * base};
  picture.panels = pictured->panels;
  picture.columns = 1;
  picture.width_px = 700;
  draw(run, "flow.png", picture);
}

}  // namespace parapet::validation
