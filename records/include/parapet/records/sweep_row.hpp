/// One row of a sweep as it was simulated.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::records {

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

/// What a row came to, from its simulation.
SweepRowResult make_sweep_row_result(const designs::SweepRow& row, const solver::Result& result);

}  // namespace parapet::records
