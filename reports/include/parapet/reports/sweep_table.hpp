/// A sweep's results beside the published figures, for the terminal and as JSON.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::reports {

/// One row of a sweep after its simulation. SI units.
struct SweepRowResult {
  std::string id;
  std::string description;
  solver::Status status = solver::Status::ok;
  std::string reason;                                    ///< why it failed
  std::map<std::string, std::optional<double>> metrics;  ///< keys of solver::metric_catalog
  std::map<std::string, std::string> metrics_absent;     ///< why a metric has no value
  double stop_time = 0.0;                                ///< simulated [s]
  std::string stop_reason;
  std::int64_t steps = 0;
  double wall_time = 0.0;   ///< [s]
  designs::Json published;  ///< as in designs::SweepRow; null when nothing

  /// The metric's value; empty when it is unknown or absent.
  std::optional<double> metric(const std::string& key) const;
};

SweepRowResult make_sweep_row_result(const designs::SweepRow& row, const solver::Result& result);

/// How a computed value stands to a published one.
struct Agreement {
  enum class Verdict { none, agrees, misses };
  Verdict verdict = Verdict::none;  ///< none: nothing published, or a bare value without a range
  std::optional<double> published;  ///< the published value, if a single one is stated
  std::optional<double> lower, upper;
  double distance = 0.0;  ///< out of the range, signed: negative below it; 0 inside
};

/// Compares a value (absent when the simulation has none) with one entry of `published`:
/// {"value": x} and/or {"lower": a, "upper": b}. A range with no computed value is a miss.
Agreement compare(const std::optional<double>& computed, const designs::Json& published);

/// An aligned table for a terminal, with the published figure beside the computed one wherever
/// there is one, a legend, and a count of the published ranges met.
/// @param spacing particle spacing dx [m]
std::string sweep_table_text(const std::vector<SweepRowResult>& rows, double spacing);

/// The content of table3.json, format "parapet-sweep-result/1": metrics lie flat in each row (null
/// when absent), `paper` holds the published figures, `agreement` the verdict on each.
/// @param provenance stored as it is; null leaves it out
designs::Json sweep_json(const std::string& name, const std::string& source, double spacing,
                         const std::vector<SweepRowResult>& rows,
                         const designs::Json& provenance = nullptr);

}  // namespace parapet::reports
