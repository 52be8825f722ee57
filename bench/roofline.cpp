// The tables that need arithmetic: roofline and scaling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tables.hpp"

namespace parapet::bench {
namespace {

// Exponent of y = c x^p by least squares of the logarithms.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

struct Ceilings {
  double flops, load, gathers;
};

}  // namespace

std::string roofline_table(const Report& report) {
  const std::string isa = report.best_isa();
  // of whichever instruction set gets there: what the core can do
  const auto ceiling = [&](const char* what, const char* quantity) {
    double best = 0.0;
    for (const char* any : {"x86_64", "x86_64_v3", "x86_64_v4"}) {
      const std::string name = std::string("ceiling/") + any + "/" + what;
      best = std::max(best, report.find(name, quantity).value_or(0.0));
    }
    return best;
  };
  const Ceilings c{ceiling("multiply_add", "flop_per_s"), ceiling("load_16_kB", "bytes_per_s"),
                   ceiling("gather_2400", "per_s")};
  if (c.flops == 0.0) return {};
  std::string text = fmt::format(
      "{}, one core: {:.1f} GFLOP/s with separate, {:.1f} with fused multiplication and addition; "
      "loads {:.0f} (16 kB), {:.0f} (256 kB), {:.0f} (4 MB), {:.1f} (256 MB) GB/s; {:.2f} G "
      "values/s "
      "gathered (2,400 points), {:.2f} (60,000); {:.2f} G roots/s, {:.2f} G quotients/s\n",
      isa, 1e-9 * c.flops, 1e-9 * ceiling("fused_multiply_add", "flop_per_s"), 1e-9 * c.load,
      1e-9 * ceiling("load_256_kB", "bytes_per_s"), 1e-9 * ceiling("load_4_MB", "bytes_per_s"),
      1e-9 * ceiling("load_256_MB", "bytes_per_s"), 1e-9 * c.gathers,
      1e-9 * ceiling("gather_60000", "per_s"), 1e-9 * ceiling("roots", "per_s"),
      1e-9 * ceiling("quotients", "per_s"));
  text +=
      fmt::format("  {:<28} {:>9} {:>8} {:>9} {:>8} {:>9} {:>9} {:>9} {:>9}\n", "pass", "M pairs/s",
                  "ns/pair", "flop/pair", "flop/B", "GFLOP/s", "of roof", "GB/s", "of gather");
  for (const auto& [name, values] : report.medians) {
    if (!name.starts_with("pass/") || name.find("/" + isa + "/") == std::string::npos) continue;
    const double intensity = values.at("flops_per_pair") / values.at("bytes_per_pair");
    const double roof = std::min(c.flops, intensity * c.load);
    std::string label = name.substr(5);
    label.erase(label.find("/" + isa), isa.size() + 1);
    text += fmt::format(
        "  {:<28} {:>9.1f} {:>8.2f} {:>9.1f} {:>8.2f} {:>9.2f} {:>7.1f} % {:>9.1f} {:>7.1f} %\n",
        label, 1e-6 * values.at("pairs_per_s"), 1e9 / values.at("pairs_per_s"),
        values.at("flops_per_pair"), intensity, 1e-9 * values.at("flop_per_s"),
        100.0 * values.at("flop_per_s") / roof, 1e-9 * values.at("requested_bytes_per_s"),
        100.0 * values.at("gathers_per_s") / c.gathers);
  }
  return text;
}

std::string scaling_table(const Report& report) {
  struct Row {
    double particles, threads, wall, cpu, cg, time_step;
  };
  std::vector<Row> rows;
  for (const auto& [name, v] : report.medians) {
    if (!name.starts_with("scaling/")) continue;
    rows.push_back({v.at("particles"), v.at("thread_count"), v.at("wall_s_per_step"),
                    v.at("cpu_s_per_step"), v.at("cg_per_step"), v.at("time_step")});
  }
  if (rows.empty()) return {};
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.particles != b.particles ? a.particles < b.particles : a.threads < b.threads;
  });
  std::string text =
      fmt::format("  {:>9} {:>8} {:>10} {:>12} {:>8} {:>14} {:>9}\n", "particles", "threads",
                  "ms/step", "ns/particle", "CG/step", "s/s of flow", "speedup");
  std::vector<double> n, step, second, iterations;
  double alone = 0.0;
  for (const Row& r : rows) {
    if (r.threads == 1.0) {
      alone = r.wall;
      n.push_back(r.particles);
      step.push_back(r.cpu);
      second.push_back(r.cpu / r.time_step);
      iterations.push_back(r.cg);
    }
    text += fmt::format("  {:>9.0f} {:>8.0f} {:>10.3f} {:>12.1f} {:>8.2f} {:>14.2f} {:>9.2f}\n",
                        r.particles, r.threads, 1e3 * r.wall, 1e9 * r.wall / r.particles, r.cg,
                        r.wall / r.time_step, alone / r.wall);
  }
  if (n.size() > 2) {
    text += fmt::format(
        "  one thread, N particles: CPU time of a step ~ N^{:.2f}, of a second of flow ~ N^{:.2f}; "
        "CG iterations ~ N^{:.2f}\n",
        fitted_exponent(n, step), fitted_exponent(n, second), fitted_exponent(n, iterations));
  }
  return text;
}

}  // namespace parapet::bench
