// The targets, and the comparison with the committed baseline.
#include <fmt/format.h>

#include "tables.hpp"

namespace parapet::bench {
namespace {

struct Target {
  const char* what;
  const char* benchmark;  // {} stands for the best instruction set
  const char* quantity;
  double scale;  // to the unit of the limit
  bool at_most;
  double limit;
  const char* unit;
  bool of_the_machine;  // depends on how fast it is, not only on how the work is shared
};

constexpr Target targets[] = {
    {"H10-D45, 5 mm, 1.6 s of flow, one thread", "run/h10_d45_5mm", "cpu_s", 1.0, true, 8.0, "s",
     true},
    {"the same at 10 mm", "run/h10_d45_10mm", "cpu_s", 1.0, true, 1.0, "s", true},
    {"Table 3 at 5 mm to its settled ends, 2 at a time", "table3/5mm", "wall_s", 1.0, true, 120.0,
     "s", true},
    {"pressure + continuity, 20 neighbours, one core", "pass/box/{}/pressure_and_continuity",
     "pairs_per_s", 1e-6, false, 500.0, "M pairs/s", true},
    {"the same on the flow, with walls", "pass/flow/{}/pressure_and_continuity", "pairs_per_s",
     1e-6, false, 500.0, "M pairs/s", true},
    {"1 mm, 53,000 particles: 2 threads against 1", "compare/threads_60k", "speedup", 1.0, false,
     1.8, "x", false},
    {"1 mm, 53,000 particles: a particle-step against 5 mm", "compare/size_60k", "cost_ratio", 1.0,
     true, 1.3, "x", false},
    {"two designs side by side against one after the other", "compare/side_by_side", "speedup", 1.0,
     false, 1.9, "x", false},
    {"implicit_viscosity against rk4_explicit, 5 mm", "compare/integrators", "speedup", 1.0, false,
     15.0, "x", false},
    {"peak memory, 60,000 particles", "compare/memory_60k", "bytes_per_particle", 1.0, true, 1000.0,
     "B/particle", false},
};

std::string benchmark_of(const Target& target, const Report& report) {
  return fmt::format(fmt::runtime(target.benchmark), report.best_isa());
}

std::string ratio_line(const std::string& what, double ratio, double scaled) {
  return fmt::format("  {:<56} {:>8.2f} {:>8.2f}\n", what, ratio, scaled);
}

}  // namespace

std::string target_table(const Report& report) {
  std::string text =
      fmt::format("  {:<56} {:>16} {:>16}  {}\n", "what", "target", "measured", "met");
  for (const Target& t : targets) {
    const auto found = report.find(benchmark_of(t, report), t.quantity);
    const double value = found.value_or(0.0) * t.scale;
    const bool met = t.at_most ? value <= t.limit : value >= t.limit;
    text += fmt::format("  {:<56} {:>16} {:>16}  {}\n", t.what,
                        fmt::format("{} {:g} {}", t.at_most ? "<=" : ">=", t.limit, t.unit),
                        found ? fmt::format("{:.4g} {}", value, t.unit) : "not measured",
                        !found ? "-"
                        : met  ? "yes"
                               : "no");
  }
  return text;
}

std::string comparison_table(const Report& report, const Report& baseline) {
  const auto peak = report.peak(), old_peak = baseline.peak();
  const double machines = peak && old_peak ? *old_peak / *peak : 1.0;
  std::string lines;
  for (const Target& t : targets) {
    const auto now = report.find(benchmark_of(t, report), t.quantity);
    const auto then = baseline.find(benchmark_of(t, baseline), t.quantity);
    if (!now || !then) continue;
    const double ratio = t.at_most ? *then / *now : *now / *then;
    lines += ratio_line(t.what, ratio, t.of_the_machine ? ratio * machines : ratio);
  }
  const std::string passes = "pass/flow/" + report.best_isa() + "/";
  for (const auto& [name, values] : report.medians) {
    const bool part = name.starts_with("part/");
    if (!part && !name.starts_with(passes)) continue;
    const std::string in_baseline =
        part ? name : "pass/flow/" + baseline.best_isa() + "/" + name.substr(passes.size());
    const auto then = baseline.find(in_baseline, "cpu_s");
    if (then)
      lines += ratio_line(name, *then / values.at("cpu_s"), *then / values.at("cpu_s") * machines);
  }
  if (lines.empty()) return lines;
  return fmt::format(
             "baseline: {} on {}\n"
             "  {:<56} {:>8} {:>8}\n",
             baseline.revision, baseline.machine, "times as good as the baseline", "measured",
             "scaled") +
         lines;
}

}  // namespace parapet::bench
