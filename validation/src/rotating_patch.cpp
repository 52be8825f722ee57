// A square patch of fluid without viscosity that rotates freely (Colagrossi 2005; Le Touze et al.
// 2013): the corners are thrown out into four arms and the middle is under tension, which tears
// schemes with tensile instability apart. At the start u = omega x r, and the pressure solves
// laplace(p) = 2 rho omega^2 with p = 0 on the free surface, whose series is known. Nothing acts
// from outside: mass, momentum and angular momentum must stay. A corner starts with no pressure
// gradient (the pressure vanishes along both its sides), so it flies straight at first: its
// distance from the middle is sqrt(1 + omega^2 t^2) times that of the start.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/reports/line_plot.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {
namespace {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;

constexpr double side = 1.0;         // L [m]
constexpr double omega = 1.0;        // [1/s]
constexpr double density = 1000.0;   // [kg/m3]
constexpr double sound_speed = 7.0;  // ten times the corners' speed [m/s]
constexpr double end = 4.0;          // [s]

// Series of sines that vanish on the sides; x, z from the middle [Pa].
double start_pressure(double x, double z) {
  constexpr int terms = 60;
  const double pi = std::numbers::pi;
  double sum = 0.0;
  for (int m = 1; m < 2 * terms; m += 2) {
    const double along = std::sin(m * pi * (x / side + 0.5)) / m;
    for (int n = 1; n < 2 * terms; n += 2) {
      sum += along * std::sin(n * pi * (z / side + 0.5)) / (n * (m * m + n * n));
    }
  }
  return -32.0 * density * omega * omega * side * side / (pi * pi * pi * pi) * sum;
}

struct Square {
  int across;               // particles along a side
  double shifting = 1.0;    // factor of Eq. 9
  double smoothing = 1.33;  // h/dx
};

struct Patch {
  std::vector<double> time, spin, energy;  // changes since the start, over the start's
  std::vector<double> reach;               // distance of the corners from the middle, mean [m]
  std::vector<double> middle;              // pressure in the middle over rho omega^2 L^2
  std::vector<double> whole;               // share of the mass in the largest connected piece
  double momentum = 0.0;                   // largest, over sum m |u| of the start
  std::vector<ParticlePanel> panels;
};

constexpr double interval = 0.05;  // of the samples [s]
std::size_t sample_at(double time) {
  return static_cast<std::size_t>(std::lround(time / interval));
}

// Share of the mass in the largest piece of particles that are within 1.5 dx of each other.
double largest_piece(const Fluid& f, double dx) {
  const auto n = static_cast<std::size_t>(f.n);
  std::vector<std::size_t> order(n), parent(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return f.z[a] < f.z[b]; });
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const double reach = 1.5 * dx;
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t i = order[a];
    for (std::size_t b = a + 1; b < n && f.z[order[b]] - f.z[i] < reach; ++b) {
      const std::size_t j = order[b];
      if (std::hypot(f.x[j] - f.x[i], f.z[j] - f.z[i]) < reach) parent[root(i)] = root(j);
    }
  }
  std::vector<double> mass(n, 0.0);
  double all = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    mass[root(i)] += f.mass[i];
    all += f.mass[i];
  }
  return *std::max_element(mass.begin(), mass.end()) / all;
}

FlowSetup patch_setup(const Square& square) {
  FlowSetup setup;
  const double dx = side / square.across;
  setup.numerics.spacing = dx;
  setup.numerics.sound_speed = sound_speed;
  setup.numerics.shifting_factor = square.shifting;
  setup.numerics.smoothing_ratio = square.smoothing;
  setup.material.density = density;
  setup.material.yield_stress = 0.0;
  setup.material.consistency = 0.0;
  setup.particles = solver::lattice_block(-0.5 * side, -0.5 * side, side, side, dx, density);
  for (solver::InitialParticle& p : setup.particles) {
    p.u = -omega * p.z;
    p.w = omega * p.x;
    p.density += start_pressure(p.x, p.z) / (sound_speed * sound_speed);
    p.mass = p.density * dx * dx;
  }
  return setup;
}

Patch computed(const Square& square, const CaseRun& run) {
  Flow flow(patch_setup(square));
  const int n = square.across;
  Patch patch;
  const Totals start = totals(flow);
  double speeds = 0.0;  // sum m |u|
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < count; ++i) {
    const Fluid& f = std::as_const(flow).fluid();
    speeds += f.mass[i] * std::hypot(f.u[i], f.w[i]);
  }
  advance_sampled(flow, end, interval, run, [&](Flow& now) {
    const Fluid& f = std::as_const(now).fluid();
    const Totals t = totals(now);
    double reach = 0.0, volume = 0.0, pressure = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      const double r = std::hypot(f.x[i], f.z[i]);
      // the corners' particles: the lattice counts along z first
      const int id = f.id[i];
      if (id == 0 || id == n - 1 || id == n * (n - 1) || id == n * n - 1) reach += 0.25 * r;
      if (r < 0.1 * side) {
        volume += f.volume[i];
        pressure += f.volume[i] * f.pressure[i];
      }
    }
    patch.time.push_back(now.time());
    patch.spin.push_back(t.angular_momentum / start.angular_momentum - 1.0);
    patch.energy.push_back((t.kinetic + t.elastic) / (start.kinetic + start.elastic) - 1.0);
    patch.reach.push_back(reach);
    patch.middle.push_back(pressure / volume / (density * omega * omega * side * side));
    patch.whole.push_back(largest_piece(f, side / n));
    patch.momentum = std::max(patch.momentum, norm(t.momentum) / speeds);
    if (patch.time.size() % sample_at(1.0) == 1 && patch.time.size() > 1)
      patch.panels.push_back(speed_panel(now, fmt::format("omega t = {:.0f}", omega * now.time())));
  });
  return patch;
}

std::string in_words(const Square& s) {
  return fmt::format("{} across{}{}", s.across, s.shifting > 0.0 ? "" : ", no shifting",
                     s.smoothing > 1.4 ? ", h = 2 dx" : "");
}

double straight(const Patch& patch, std::size_t k) {
  return patch.reach[0] * std::sqrt(1.0 + std::pow(omega * patch.time[k], 2));
}

double largest_change(const std::vector<double>& change, double until) {
  double largest = 0.0;
  for (std::size_t k = 0; k <= sample_at(until); ++k)
    largest = std::max(largest, std::abs(change[k]));
  return largest;
}

void draw_lines(CaseRun& run, const std::vector<Square>& squares,
                const std::vector<Patch>& patches) {
  reports::LinePlot spin, middle;
  spin.title = "Angular momentum";
  spin.x_label = middle.x_label = "omega t";
  spin.y_label = "change since the start [%]";
  middle.title = "Pressure in the middle";
  middle.y_label = "pressure over rho omega2 L2";
  for (std::size_t k = 0; k < squares.size(); ++k) {
    reports::PlotSeries s{
        in_words(squares[k]), patches[k].time, {}, reports::SeriesStyle::line, static_cast<int>(k)};
    for (const double change : patches[k].spin) s.y.push_back(100.0 * change);
    spin.series.push_back(s);
    s.y = patches[k].middle;
    middle.series.push_back(std::move(s));
  }
  for (reports::LinePlot* plot : {&spin, &middle}) {
    plot->width_px = 800;
    plot->height_px = 420;
  }
  draw_line_plot(run.figure("spin.png"), spin);
  draw_line_plot(run.figure("middle.png"), middle);
}

void draw_shapes(CaseRun& run, const Square& square, Patch& patch) {
  ParticlePicture picture;
  picture.title = fmt::format("Rotating patch, {}", in_words(square));
  picture.quantity = "speed over omega L";
  picture.high = 1.0;
  picture.spacing = side / square.across;
  picture.window_from = {-2.5, -2.5};
  picture.window_to = {2.5, 2.5};
  picture.panels = std::move(patch.panels);
  picture.columns = 4;
  picture.width_px = 1100;
  draw(run, "shapes.png", picture);
}

void add_spin(CaseRun& run, const Square& square, const Patch& patch, const std::string& key,
              double until, bool judged) {
  Measure m{.key = fmt::format("spin_{}_{}", key, static_cast<int>(until)),
            .what = fmt::format("{}: largest change of the angular momentum until omega t = {}",
                                in_words(square), until),
            .value = 100.0 * largest_change(patch.spin, until),
            .unit = "%"};
  if (judged) {
    m.upper = 1.0;
    m.reason =
        "pair forces are central; only the tensile-instability control, whose forces are not, and "
        "the mass that "
        "shifting exchanges between neighbours at a distance may move it";
  }
  run.add(m);
}

void add_contrast(CaseRun& run, const Square& square, const Patch& patch, const std::string& key) {
  add_spin(run, square, patch, key, 2.0, false);
  add_spin(run, square, patch, key, end, false);
  run.add({.key = fmt::format("whole_{}", key),
           .what = fmt::format("{}: mass in the largest piece at omega t = 2", in_words(square)),
           .value = 100.0 * patch.whole[sample_at(2.0)],
           .unit = "%"});
}

void add_finest(CaseRun& run, const Square& square, const Patch& patch) {
  const std::string at = in_words(square);
  add_spin(run, square, patch, "finest", 2.0, true);
  add_spin(run, square, patch, "finest", end, true);
  run.add({.key = "momentum",
           .what = at + ": largest momentum over sum m |u| of the start",
           .value = 100.0 * patch.momentum,
           .unit = "%",
           .upper = 1.0,
           .reason = "none at the start; pair forces (except those of the tensile-instability "
                     "control) and what shifting exchanges are equal and opposite"});
  run.add({.key = "energy",
           .what = at + ": change of kinetic and elastic energy until omega t = 4",
           .value = 100.0 * patch.energy.back(),
           .unit = "%"});
  run.add({.key = "middle_start",
           .what = at + ": pressure in the middle at the start over rho omega2 L2",
           .value = patch.middle[0],
           .lower = -0.1474,
           .upper = -0.139,
           .reason = "the series gives -0.1473 in the point, 0.005 more over a disc of 0.1 L"});
  Measure whole{.key = "whole",
                .what = at + ": mass in the largest piece at omega t = 2",
                .value = 100.0 * patch.whole[sample_at(2.0)],
                .unit = "%",
                .lower = 99.5,
                .reason =
                    "the exact patch stays whole; the last half per cent are the corners' "
                    "tips, thinner than a particle"};
  if (whole.verdict() == Verdict::missed)
    whole.explanation =
        "the surface is under tension and its particles are not shifted: it frays (see the text)";
  run.add(whole);
  run.add({.key = "whole_end",
           .what = at + ": mass in the largest piece at omega t = 4",
           .value = 100.0 * patch.whole.back(),
           .unit = "%"});
}

}  // namespace

void rotating_patch(CaseRun& run) {
  std::vector<Square> squares;
  for (const int across : run.full() ? std::vector{120, 60, 30} : std::vector{40, 20})
    squares.push_back({across});
  const std::size_t spacings = squares.size();
  squares.push_back({run.full() ? 60 : 40, 0.0});
  squares.push_back({run.full() ? 60 : 40, 1.0, 2.0});
  std::vector<double> cost;
  for (const Square& s : squares) cost.push_back(1.1e-5 * std::pow(s.across, 3));
  std::vector<Patch> patches(squares.size());
  run.side_by_side(
      squares.size(), [&](std::size_t k) { patches[k] = computed(squares[k], run); }, cost);
  add_finest(run, squares[0], patches[0]);
  std::vector<double> dx, deviation;
  const std::size_t k2 = sample_at(2.0);
  for (std::size_t k = 0; k < spacings; ++k) {
    dx.push_back(side / squares[k].across);
    deviation.push_back(1.0 - patches[k].reach[k2] / straight(patches[k], k2));
    run.add({.key = fmt::format("reach_{}", squares[k].across),
             .what = fmt::format("{}: corners at omega t = 2 behind those that fly straight",
                                 in_words(squares[k])),
             .value = 100.0 * deviation.back(),
             .unit = "%"});
  }
  Measure order{.key = "reach_order",
                .what = "order of that lag over the spacings",
                .value = fitted_order(dx, deviation)};
  if (spacings >= 3) {
    order.lower = 0.8;
    order.reason =
        "the outermost particle lies dx/2 inside its corner, where the pressure's "
        "gradient grows in proportion to the distance";
  }
  run.add(order);
  for (std::size_t k = 1; k < squares.size(); ++k) {
    const std::string key = k == spacings       ? std::string("no_shifting")
                            : k == spacings + 1 ? std::string("wide_kernel")
                                                : fmt::format("{}", squares[k].across);
    add_contrast(run, squares[k], patches[k], key);
  }
  draw_lines(run, squares, patches);
  draw_shapes(run, squares[0], patches[0]);
}

}  // namespace parapet::validation
