// The table of metrics: one entry for each, with the gauge that reads it off a run. Results, the
// catalogue, docs/metrics.md, the schema and the surrogates' bounds come from here.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/solver/result.hpp"
#include "run_readings.hpp"

namespace parapet::solver {

// A reason for which a run may end without a metric.
struct Absent {
  std::string_view text;
  Absence kind = Absence::does_not_exist;
  bool may_come = false;  // a longer run could bring the metric
};

namespace absence {
// Those that no gauge gives itself: see read().
inline constexpr Absent too_coarse{
    "fewer than 4 particles span its window: finer particles, or a wider window under `gauges`",
    Absence::too_coarse};
inline constexpr Absent too_few{
    "fewer than 2 particles make up its share of the released mass: finer particles, or a larger "
    "share under `gauges`",
    Absence::too_coarse};
inline constexpr Absent too_large{
    "the particles are coarser than 1.5 landing_height and cannot come so near the bed: finer "
    "particles, or a larger height under `gauges`",
    Absence::too_coarse};
inline constexpr Absent run_too_short{
    "the run ended at its stop time while the flow could still bring it", Absence::run_too_short};
}  // namespace absence

// A value, or the reason why there is none: one of the entry's absent_when.
struct Reading {
  Reading(double number) : value(number) {}
  Reading(const Absent& reason) : absent(&reason) {}
  Reading(const std::optional<double>& number, const Absent& reason)
      : value(number), absent(number ? nullptr : &reason) {}

  std::optional<double> value;
  const Absent* absent = nullptr;  // of static storage
};

// `barrier` counts from 0; it matters where every barrier has the metric.
using Gauge = Reading (*)(const RunReadings& run, std::size_t barrier);

struct MetricEntry {
  std::string_view key;   // ends in its unit; begins with barrier_K_ where every barrier has it
  std::string_view unit;  // as messages write it; empty for a pure number
  // The values that it can have at all, by its definition alone: what a surrogate may predict.
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  // Every reason that its gauge may give instead of a value.
  std::array<const Absent*, 4> absent_when = {};
  std::string_view definition;
  Gauge gauge;
  // The coarsest particles that resolve it, over H0, and the smallest share of the released mass
  // that it looks at; nullptr: any.
  double (*coarsest)(const GaugeSettings& settings) = nullptr;
  const Absent* coarse_reason = &absence::too_coarse;
  double (*mass_share)(const GaugeSettings& settings) = nullptr;
  // Of a quantity that describes the state at the end, and creeps: the range of its values. The
  // others are settled by an event.
  double (*range)(const RunReadings& run) = nullptr;
};

constexpr std::string_view barrier_placeholder = "barrier_K_";

struct MetricTable {
  std::span<const MetricEntry> with_barrier;  // of a run with at least one barrier
  std::span<const MetricEntry> every_run;
  std::span<const MetricEntry> each_barrier;
};

MetricTable metric_table();

// "barrier_2_arrival_time_s" for an entry of every barrier and 1.
std::string barrier_key(const MetricEntry& entry, std::size_t barrier);

// Calls visit(key, entry, barrier) in the order of results.
template <typename Visit>
void for_each_metric(std::size_t n_barriers, Visit visit) {
  const MetricTable table = metric_table();
  if (n_barriers > 0) {
    for (const MetricEntry& entry : table.with_barrier) visit(std::string(entry.key), entry, 0);
  }
  for (const MetricEntry& entry : table.every_run) visit(std::string(entry.key), entry, 0);
  for (std::size_t k = 0; k < n_barriers; ++k) {
    for (const MetricEntry& entry : table.each_barrier) visit(barrier_key(entry, k), entry, k);
  }
}

// What a result says of the metric: the gauge's reading where the particles resolve it and the run
// was long enough.
Reading read(const MetricEntry& entry, const RunReadings& run, std::size_t barrier);

// Every reason for which a result may lack the metric.
std::vector<const Absent*> absent_when(const MetricEntry& entry);

// All metrics of a run, in the order of results.
std::vector<Metric> read_metrics(const RunReadings& run);

// Whether a metric differs between two moments of a run; one that creeps, by more than `share` of
// its range.
bool metric_moved(const RunReadings& before, const RunReadings& now, double share);

}  // namespace parapet::solver
