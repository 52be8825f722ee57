// Fluid at rest for 10 s in a rectangular tank and in a tank tilted by the channel's slope, with a
// stem and a deflector in it: spurious speeds, pressure and the force on every plate against
// hydrostatics. It tries the walls that everything else relies on: corners, plates, the pocket
// below a deflector and its tip. The fluid is as thin as water, so that nothing damps what the
// walls stir up; Table 1's debris for comparison.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"
#include "tank_flow.hpp"

namespace parapet::validation {

using solver::Integrator;
using solver::Material;
using tank_flows::Tank;
using tank_flows::TankRun;

namespace {

constexpr double slope = 26.0 * std::numbers::pi / 180.0;  // of the channel's bed
constexpr double long_ = 0.40;

Material water() {
  Material m;
  m.density = 1000.0;
  m.yield_stress = 0.0;
  m.consistency = 1e-3;
  m.flow_index = 1.0;
  return m;
}

// Largest value after the first half.
double late(const std::vector<double>& v) {
  return *std::max_element(v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
}
double late_rms(const std::vector<double>& v) {
  double sum = 0.0;
  const std::size_t from = v.size() / 2;
  for (std::size_t k = from; k < v.size(); ++k) sum += v[k] * v[k];
  return std::sqrt(sum / static_cast<double>(v.size() - from));
}

void add_tank(CaseRun& run, const Tank& tank, const TankRun& r) {
  const std::string key = tank.key;
  const auto add = [&](const char* name, const char* words, double value, const char* unit,
                       std::optional<double> upper, const char* reason, const char* explanation) {
    Measure m;
    m.key = fmt::format("{}_{}", key, name);
    m.what = fmt::format("{}: {}", tank.name, words);
    m.value = value;
    m.unit = fmt::format("{}", unit);
    m.upper = upper;
    m.reason = fmt::format("{}", reason);
    m.explanation = fmt::format("{}", explanation);
    run.add(m);
  };
  const bool thin = tank.material.yield_stress == 0.0;
  const char* shaken = "eddies from the start, which nothing damps";
  const char* still_why =
      "packed particles are uneven, and debris keeps that; less at 5 mm (last tank)";
  Measure lasted{.key = key + "_lasted",
                 .what = fmt::format("{}: time that the flow could be computed", tank.name),
                 .value = r.lasted,
                 .unit = "s",
                 .lower = tank.time - 1e-6,
                 .reason = "a fluid at rest stays at rest"};
  if (!r.failure.empty()) lasted.explanation = fmt::format("{}: {}", r.failure, shaken);
  run.add(lasted);
  if (tank.bare) {  // to be compared with each other
    add("speed", "largest speed in the second half, over sqrt(gH)", late(r.largest), "%", {}, "",
        "");
    add("pressure", "rms error of the pressure in the second half, over rho g H",
        late_rms(r.pressure_rms), "%", {}, "", "");
    return;
  }
  add("speed", "largest speed in the second half, over sqrt(gH)", late(r.largest), "%", 1.0,
      "spurious motion that is accepted in a fluid at rest", shaken);
  add("rms", "rms speed in the second half, over sqrt(gH)", late_rms(r.rms), "%", {}, "", "");
  add("pressure", "rms error of the pressure in the second half, over rho g H",
      late_rms(r.pressure_rms), "%", 1.0, "hydrostatics", thin ? shaken : still_why);
  add("pressure_largest", "largest error of the pressure in the second half, over rho g H",
      late(r.pressure_largest), "%", {}, "", "");
  add("inside", "particles inside walls", r.inside, "", 0.0, "a wall is a wall", shaken);
  add("momentum", "momentum not explained by gravity and wall forces", r.momentum_error, "%", 1.0,
      "share of the impulse of gravity", shaken);
  if (!r.failure.empty()) return;
  add("drift", "the centre of mass moves in the second half, over H", std::abs(r.drift), "%", 0.2,
      "a fifth of a per cent in half the time keeps the level within the limit of the pressure",
      shaken);
  if (tank.barrier) {
    add("plates", "force on a plate, largest error over the sum on all plates", r.plates, "%", 2.0,
        "pressure within 1 %, and corners shared between two plates", shaken);
    add("barrier", "force on the whole barrier, error over the sum on all plates", r.barrier, "%",
        2.0, "as for the plates", shaken);
  }
}

void draw_speeds(CaseRun& run, const std::vector<Tank>& tanks, const std::vector<TankRun>& runs) {
  reports::LinePlot plot;
  plot.title = "Largest spurious speed";
  plot.x_label = "time [s]";
  plot.y_label = "log10 of speed / sqrt(gH)";
  for (std::size_t k = 0; k < tanks.size(); ++k) {
    reports::PlotSeries s{
        tanks[k].name, runs[k].time, {}, reports::SeriesStyle::line, static_cast<int>(k)};
    for (const double u : runs[k].largest) s.y.push_back(std::log10(std::max(0.01 * u, 1e-6)));
    plot.series.push_back(s);
  }
  plot.width_px = 900;
  plot.height_px = 480;
  draw_line_plot(run.figure("speeds.png"), plot);
}

void draw_barriers(CaseRun& run, const std::vector<Tank>& tanks, const std::vector<TankRun>& runs,
                   bool speed) {
  ParticlePicture picture;
  picture.title = fmt::format("{} at the end", speed ? "Speed" : "Error of the pressure");
  picture.quantity = fmt::format("{}", speed ? "speed / sqrt(gH) [%]" : "error / rho g H [%]");
  picture.low = speed ? 0.0 : -6.0;
  picture.high = speed ? 2.0 : 6.0;
  for (std::size_t k = 0; k < tanks.size() && picture.panels.size() < 2; ++k) {
    if (!tanks[k].barrier) continue;
    picture.spacing = tanks[k].spacing;
    picture.walls = runs[k].walls;
    picture.panels.push_back(speed ? runs[k].speed : runs[k].pressure);
  }
  picture.window_from = {-0.01, -0.01};
  picture.window_to = {0.41, 0.3};
  picture.width_px = 680;
  draw(run, speed ? "speed.png" : "pressure.png", picture);
}

}  // namespace

void tanks(CaseRun& run) {
  const double time = run.full() ? 10.0 : 1.0;
  std::vector<Tank> list{
      {"debris", "rectangular tank, debris", Material{}, 0.0, 0.3, 0.2, false, 0.01, time},
      {"tilted", "tilted tank, water", water(), slope, long_, 0.08, false, 0.0075, time},
      {"barrier_debris", "tilted tank with barrier, debris", Material{}, slope, long_, 0.08, true,
       0.0075, time},
  };
  if (run.full()) {
    list.push_back({"water", "rectangular tank, water", water(), 0.0, 0.3, 0.2, false, 0.01, time});
    list.push_back({"unshifted", "rectangular tank, water, no shifting, 5 mm", water(), 0.0, 0.3,
                    0.2, false, 0.005, time, Integrator::implicit_viscosity, 0.0});
    list.push_back({"water_fine", "rectangular tank, water, 5 mm", water(), 0.0, 0.3, 0.2, false,
                    0.005, time});
    list.push_back({"barrier_water", "tilted tank with barrier, water", water(), slope, long_, 0.08,
                    true, 0.0075, time});
    list.push_back({"pierced_debris", "barrier that pierces the surface, debris", Material{}, slope,
                    long_, 0.035, true, 0.0075, time});
    // a foot and a thickness that fit the bed's points, and half a spacing off
    for (const bool fits : {true, false}) {
      Tank stem{fits ? "stem_on_grid" : "stem_off_grid",
                fits ? "flat tank with upright stem, water, stem on the bed's grid"
                     : "flat tank with upright stem, water, stem half a spacing off the grid",
                water(),
                0.0,
                long_,
                0.15,
                true,
                0.01,
                0.4 * time};
      stem.bare = true;
      stem.foot = fits ? 0.2 : 0.22;
      stem.thickness = fits ? 0.02 : 0.015;
      list.push_back(stem);
    }
    list.push_back({"debris_fine", "tilted tank with barrier, debris, 5 mm", Material{}, slope,
                    long_, 0.08, true, 0.005, 0.2 * time});
  }
  // both time integrations, a second of water
  const std::size_t n = list.size();
  std::vector<Tank> integrators;
  for (const Integrator integrator : {Integrator::implicit_viscosity, Integrator::rk4_explicit}) {
    integrators.push_back({"integrator", "rectangular tank, water", water(), 0.0, 0.3, 0.2, false,
                           0.01, run.full() ? 1.0 : 0.2, integrator});
  }
  std::vector<TankRun> runs(n), pair(2);
  std::vector<double> cost;
  for (const Tank& t : list) cost.push_back(t.time * 1e-6 / std::pow(t.spacing, 3.0));
  run.side_by_side(
      n + 2,
      [&](std::size_t k) {
        (k < n ? runs[k] : pair[k - n]) =
            tank_flows::computed(k < n ? list[k] : integrators[k - n], run);
      },
      cost);
  for (std::size_t k = 0; k < n; ++k) add_tank(run, list[k], runs[k]);
  run.add({.key = "integrators",
           .what = fmt::format("rectangular tank, water: rms speed, rk4_explicit minus "
                               "implicit_viscosity, over sqrt(gH), after {:.1f} s",
                               integrators.front().time),
           .value = pair[1].rms.back() - pair[0].rms.back(),
           .unit = "%",
           .lower = -0.1,
           .upper = 0.1,
           .reason = "both solve the same equations in space, so the spurious motion is the same"});
  draw_speeds(run, list, runs);
  draw_barriers(run, list, runs, false);
  draw_barriers(run, list, runs, true);
}

}  // namespace parapet::validation
