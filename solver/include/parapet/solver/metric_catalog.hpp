/// What each metric is: key, unit, possible values, when it does not exist, definition.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parapet::solver {

/// What a metric means, for docs, checks, searches and reports.
struct MetricInfo {
  std::string key;   ///< ends in its unit
  std::string unit;  ///< as messages write it ("m/s"); empty for a pure number
  /// The values that it can have at all, by its definition alone; infinite where there is no limit.
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  std::vector<std::string> absent_when;  ///< the reasons for which a run may end without it
  std::string definition;                ///< one sentence; H0 is the event's length, and a name
                                         ///< such as rest_speed a key of the case's `gauges`

  /// Whether there are runs, long and fine enough, in which it does not exist.
  bool may_not_exist = false;
};

/// Every metric of a scene with this many barriers, in the order in which results list them.
/// Barrier metrics are keyed barrier_K_..., K counted from 1 upstream.
std::vector<MetricInfo> metric_catalog(int n_barriers);

/// The metrics as docs list them: those of every barrier once, with K for its number.
std::vector<MetricInfo> metric_definitions();

/// The metric of that key, whatever the number of barriers; nothing when there is none.
std::optional<MetricInfo> find_metric_info(std::string_view key);

}  // namespace parapet::solver
