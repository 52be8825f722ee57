// Uniform flow of Table 1's debris down the channel's slope, 42 mm deep: surface speed, discharge
// and profile against the exact solution of a Herschel-Bulkley fluid, started from the exact
// profile, from half of it and from rest. In the steady state gravity's power goes into viscous
// dissipation, which is compared too.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "balance.hpp"
#include "cases.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::Material;

namespace {

constexpr double depth = 0.042;  // [m]
constexpr double slope = 26.0 * std::numbers::pi / 180.0;
constexpr double gravity = 9.81;      // [m/s2]
constexpr double sound_speed = 10.0;  // [m/s]; 16 times the fastest flow, 15 sqrt(g cos a h)
constexpr double average_over = 0.3;  // the last seconds of a run

// h_s = h - tau_y/(rho g sin a) is sheared, A = (rho g sin a/K)^(1/N), m = 1 + 1/N:
// u_s = N/(N+1) A h_s^m, u = u_s [1 - (1 - z/h_s)^m], q = u_s [h - N h_s/(2 N + 1)].
struct Exact {
  double sheared, power, surface_speed, discharge;
  explicit Exact(const Material& m) {
    const double drive = m.density * gravity * std::sin(slope), n = m.flow_index;
    sheared = depth - m.yield_stress / drive;
    power = 1.0 + 1.0 / n;
    surface_speed =
        n / (n + 1.0) * std::pow(drive / m.consistency, 1.0 / n) * std::pow(sheared, power);
    discharge = surface_speed * (depth - n * sheared / (2.0 * n + 1.0));
  }
  double speed(double z) const {
    return surface_speed * (z < sheared ? 1.0 - std::pow(1.0 - z / sheared, power) : 1.0);
  }
};

struct Start {
  const char* key;
  const char* name;
  double share;  // of the exact profile
  double time;   // by which the flow is uniform [s]
};

constexpr Start exact_start{"exact", "from the exact profile", 1.0, 1.5};
constexpr Start half_start{"half", "from half of it", 0.5, 2.5};
constexpr Start rest_start{"rest", "from rest", 0.0, 3.0};

constexpr int finer = 28;  // particles across, one start only

struct Inclined {
  int across;
  Start start;
};

struct Outcome {
  std::vector<double> time, surface, discharge;  // over the exact values
  std::vector<double> z, u;                      // at the end
  double surface_error = 0.0, discharge_error = 0.0, profile_error = 0.0;
  double power_error = 0.0;  // dissipation over the power of gravity, minus 1
  double mass_change = 0.0, momentum_error = 0.0;
  int inside = 0;
};

Outcome computed(const Inclined& inclined, const CaseRun& run) {
  const Material material;
  const Exact exact(material);
  FlowSetup setup;
  const double dx = depth / inclined.across, length = 12.0 * dx;
  setup.numerics.spacing = dx;
  setup.numerics.sound_speed = sound_speed;
  setup.numerics.cg_tolerance = 1e-3;
  setup.material = material;
  setup.gravity = {gravity * std::sin(slope), -gravity * std::cos(slope)};
  setup.periodic_length = length;
  add_periodic_wall(setup, length, 0.0, true);
  measure_all_walls(setup);
  setup.particles = solver::lattice_block(0.0, 0.0, length, depth, dx, material.density);
  for (solver::InitialParticle& p : setup.particles) {
    p.u = inclined.start.share * exact.speed(p.z);
    p.density -= material.density * setup.gravity.z * (depth - p.z) / (sound_speed * sound_speed);
  }
  Flow flow(std::move(setup));
  Balance balance(flow);
  Outcome out;
  double square = 0.0, size = 0.0, averaged = 0.0, dissipated = 0.0, worked = 0.0;
  const auto sample = [&](Flow& now) {
    const Fluid& f = std::as_const(now).fluid();
    const bool counts = now.time() > inclined.start.time - average_over;
    double discharge = 0.0, surface = 0.0;
    int top = 0;
    out.z.clear();
    out.u.clear();
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      discharge += f.mass[i] * f.u[i] / (material.density * length);
      if (f.z[i] > depth - 0.25 * depth) {  // the plug is 0.44 of the depth
        surface += f.u[i];
        ++top;
      }
      out.z.push_back(1e3 * f.z[i]);
      out.u.push_back(f.u[i]);
      if (counts) {
        const double u = exact.speed(f.z[i]);
        square += (f.u[i] - u) * (f.u[i] - u);
        size += u * u;
      }
    }
    surface /= top;
    out.time.push_back(now.time());
    out.surface.push_back(surface / exact.surface_speed);
    out.discharge.push_back(discharge / exact.discharge);
    out.inside += now.particles_inside_walls();
    if (!counts) return;
    averaged += 1.0;
    out.surface_error += out.surface.back() - 1.0;
    out.discharge_error += out.discharge.back() - 1.0;
    dissipated += totals(now).dissipation;
    worked += material.density * gravity * std::sin(slope) * discharge * length;
  };
  advance_sampled(flow, inclined.start.time, 0.02, run, sample, &balance);
  out.surface_error *= 100.0 / averaged;
  out.discharge_error *= 100.0 / averaged;
  out.profile_error = 100.0 * std::sqrt(square / size);
  out.power_error = 100.0 * (dissipated / worked - 1.0);
  out.mass_change = balance.mass_change(flow);
  out.momentum_error = 100.0 * balance.momentum_error(flow);
  return out;
}

void draw_profile(CaseRun& run, const Outcome& finest, const Outcome& coarsest, double fine_mm,
                  double coarse_mm) {
  const Exact exact{Material{}};
  reports::LinePlot plot;
  plot.title = fmt::format("Uniform flow down 26 deg, {:.0f} mm deep", 1e3 * depth);
  plot.x_label = "velocity along the bed [m/s]";
  plot.y_label = "height above the bed [mm]";
  reports::PlotSeries line{"exact", {}, {}, reports::SeriesStyle::line, 1};
  for (int k = 0; k <= 200; ++k) {
    line.x.push_back(exact.speed(depth * k / 200.0));
    line.y.push_back(1e3 * depth * k / 200.0);
  }
  const auto markers = [](const Outcome& o, double mm, int color) {
    return reports::PlotSeries{fmt::format("particles, {:.3g} mm", mm), o.u, o.z,
                               reports::SeriesStyle::markers, color};
  };
  plot.series = {markers(coarsest, coarse_mm, 2), markers(finest, fine_mm, 0), line};
  plot.width_px = 800;
  plot.height_px = 520;
  draw_line_plot(run.figure("profile.png"), plot);
}

void draw_starts(CaseRun& run, const std::vector<const Outcome*>& outcomes,
                 const std::vector<Start>& starts) {
  reports::LinePlot plot;
  plot.title = fmt::format("Discharge over the exact one");
  plot.x_label = "time [s]";
  plot.y_label = "q / q exact [-]";
  for (std::size_t k = 0; k < starts.size(); ++k) {
    plot.series.push_back({starts[k].name, outcomes[k]->time, outcomes[k]->discharge,
                           reports::SeriesStyle::line, static_cast<int>(k)});
  }
  plot.width_px = 800;
  plot.height_px = 420;
  draw_line_plot(run.figure("starts.png"), plot);
}

}  // namespace

void uniform_flow(CaseRun& run) {
  // 5.25, 3 and 2 mm, and 1.5 mm to see where the errors go; quick: the coarsest two
  const std::vector<int> levels = run.full() ? std::vector{8, 14, 21} : std::vector{8, 14};
  std::vector<Inclined> list;
  if (run.full()) list.push_back({finer, half_start});
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    list.push_back({*level, half_start});
    if (!run.full()) continue;
    list.push_back({*level, exact_start});
    list.push_back({*level, rest_start});
  }
  std::vector<Outcome> outcomes(list.size());
  std::vector<double> cost;
  for (const Inclined& i : list) cost.push_back(1e-4 * i.start.time * std::pow(i.across, 2.0));
  run.side_by_side(
      list.size(), [&](std::size_t k) { outcomes[k] = computed(list[k], run); }, cost);

  const auto find = [&](int across, const Start& start) -> const Outcome& {
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (list[k].across == across && std::string_view(list[k].start.key) == start.key)
        return outcomes[k];
    }
    throw std::logic_error("no such flow");
  };
  const std::vector<Start> starts =
      run.full() ? std::vector{exact_start, half_start, rest_start} : std::vector{half_start};
  int inside = 0;
  double momentum = 0.0, mass = 0.0;
  for (const Start& start : starts) {
    std::vector<double> spacings, errors;
    std::vector<int> across_all = levels;
    if (run.full() && std::string_view(start.key) == half_start.key) across_all.push_back(finer);
    for (const int across : across_all) {
      const Outcome& o = find(across, start);
      const double mm = 1e3 * depth / across;
      const auto add = [&](const char* what, const char* key, double value) {
        Measure m;
        m.key = fmt::format("{}_{}_{}", key, start.key, across);
        m.what = fmt::format("{}, {:.3g} mm, {}", what, mm, start.name);
        m.value = value;
        m.unit = fmt::format("%");
        if (across == 21) {
          m.lower = -2.0;
          m.upper = 2.0;
          m.reason = "the sheared layer is 12 particles thick, the scheme of second order";
        }
        run.add(m);
      };
      add("surface speed, error", "surface", o.surface_error);
      add("discharge, error", "discharge", o.discharge_error);
      run.add({.key = fmt::format("profile_{}_{}", start.key, across),
               .what = fmt::format("velocity profile, L2 error, {:.3g} mm, {}", mm, start.name),
               .value = o.profile_error,
               .unit = "%"});
      spacings.push_back(mm);
      errors.push_back(o.profile_error);
      inside += o.inside;
      momentum = std::max(momentum, o.momentum_error);
      mass = std::max(mass, std::abs(o.mass_change));
    }
    if (levels.size() > 2) {
      run.add({.key = fmt::format("order_{}", start.key),
               .what = fmt::format("order of convergence of the profile, {}", start.name),
               .value = fitted_order(spacings, errors)});
    }
  }
  const Outcome& finest = find(levels.back(), half_start);
  run.add({.key = "power",
           .what = fmt::format("viscous dissipation over the power of gravity, minus 1, {:.3g} mm",
                               1e3 * depth / levels.back()),
           .value = finest.power_error,
           .unit = "%",
           .lower = -2.0,
           .upper = 2.0,
           .reason = "a steady flow has no other sink; the rest is the scheme's"});
  run.add({.key = "mass",
           .what = "largest change of the mass",
           .value = mass,
           .upper = 1e-12,
           .reason = "particles keep their mass; the sum rounds"});
  run.add({.key = "momentum",
           .what = "largest momentum not explained by gravity and bed force",
           .value = momentum,
           .unit = "%",
           .upper = 1.0,
           .reason = "share of the impulse of gravity; the bed carries all of it in the end"});
  run.add({.key = "inside",
           .what = "particles below the bed",
           .value = static_cast<double>(inside),
           .upper = 0.0,
           .reason = "a wall is a wall"});
  draw_profile(run, finest, find(levels.front(), half_start), 1e3 * depth / levels.back(),
               1e3 * depth / levels.front());
  std::vector<const Outcome*> shown;
  for (const Start& start : starts) shown.push_back(&find(levels.back(), start));
  draw_starts(run, shown, starts);
}

}  // namespace parapet::validation
