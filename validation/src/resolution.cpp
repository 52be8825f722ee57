// What the support of the kernel buys: error and scatter of the metrics that designs are judged by,
// against the visits of particle pairs that they cost, for several h/dx and particle spacings.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"

namespace parapet::validation {
namespace {

struct Group {
  std::size_t row;
  double spacing;  // [m]
  double ratio;    // h/dx
  std::vector<solver::Result> results;
};

// Pairs visited grow with the particles and with the area of the support.
double visits(const Group& g) {
  double sum = 0.0;
  for (const solver::Result& r : g.results) {
    sum += static_cast<double>(r.statistics.steps) * static_cast<double>(r.mass.particles_released);
  }
  return sum * g.ratio * g.ratio / static_cast<double>(g.results.size());
}

std::vector<Group> groups(bool full) {
  std::vector<Group> list;
  const auto add = [&](std::size_t row, double spacing, double ratio, std::size_t runs) {
    list.push_back({row, spacing, ratio, std::vector<solver::Result>(runs)});
  };
  if (!full) {
    for (const double ratio : {1.33, 2.0}) add(1, 0.02, ratio, 2);
    return list;
  }
  for (std::size_t row = 0; row < std::size(three_barriers); ++row) {
    for (const double ratio : {1.33, 2.0}) add(row, 0.005, ratio, 4);  // first: the references
    for (const double spacing : {0.00707, 0.01}) {
      for (const double ratio : {1.33, 1.5, 1.75, 2.0}) add(row, spacing, ratio, 4);
    }
  }
  return list;
}

void compute(std::vector<Group>& list, CaseRun& run) {
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  std::vector<double> costs;
  for (const double dearest : {0.005, 0.00707, 0.01, 0.02}) {
    for (std::size_t g = 0; g < list.size(); ++g) {
      if (list[g].spacing != dearest) continue;
      for (std::size_t k = 0; k < list[g].results.size(); ++k) {
        tasks.emplace_back(g, k);
        costs.push_back(std::pow(0.01 / dearest, 3.0) * list[g].ratio * list[g].ratio / 1.8);
      }
    }
  }
  run.side_by_side(
      tasks.size(),
      [&](std::size_t t) {
        const auto [g, k] = tasks[t];
        solver::Numerics numerics;
        numerics.spacing = list[g].spacing;
        numerics.smoothing_ratio = list[g].ratio;
        numerics.lattice_jitter = 0.01;
        numerics.lattice_seed = static_cast<unsigned>(k + 1);
        list[g].results[k] = simulated(scene_of(three_barriers[list[g].row]), numerics, run);
      },
      costs);
}

// Both supports at the finest spacing: they have the same limit, and halfway between is the
// reference.
std::optional<double> reference(const std::vector<Group>& list, std::size_t row,
                                const JudgedMetric& judged) {
  double sum = 0.0, n = 0.0;
  for (const Group& g : list) {
    if (g.row != row || g.spacing != 0.005) continue;
    const auto s = spread(g.results, judged);
    if (!s) return std::nullopt;
    sum += s->mean;
    n += 1.0;
  }
  return n > 0.0 ? std::optional(sum / n) : std::nullopt;
}

}  // namespace

void resolution(CaseRun& run) {
  std::vector<Group> list = groups(run.full());
  compute(list, run);
  const double unit = visits(list.front());
  for (const Group& g : list) {
    const std::string key = fmt::format("{}_{:.0f}mm_{:.0f}", three_barriers[g.row].key,
                                        1e3 * g.spacing, 100.0 * g.ratio);
    const std::string of =
        fmt::format("{}, {:.1f} mm, h/dx {}", three_barriers[g.row].name, 1e3 * g.spacing, g.ratio);
    run.add({.key = key + "_cost",
             .what = of + ": visits of pairs over those of the first line",
             .value = visits(g) / unit});
    for (const JudgedMetric& judged : judged_metrics) {
      const auto s = spread(g.results, judged);
      if (!s) continue;
      const auto target = reference(list, g.row, judged);
      run.add({.key = fmt::format("{}_{}", key, judged.key),
               .what = fmt::format("{}: {}, mean of {}", of, judged.name, s->runs),
               .value = s->mean,
               .unit = judged.unit});
      run.add({.key = fmt::format("{}_{}_scatter", key, judged.key),
               .what = fmt::format("{}: {}, standard deviation", of, judged.name),
               .value = s->deviation,
               .unit = judged.unit});
      if (!target) continue;
      run.add({.key = fmt::format("{}_{}_error", key, judged.key),
               .what = fmt::format("{}: {}, mean minus reference", of, judged.name),
               .value = s->mean - *target,
               .unit = judged.unit});
    }
  }
}

}  // namespace parapet::validation
