/// The metrics that the cases of a study have.
#pragma once

#include <string>
#include <vector>

#include "findings.hpp"
#include "parapet/solver/metric_catalog.hpp"
#include "study_targets.hpp"

namespace parapet::designs {

/// A metric is known when a scene under some combination of options has it.
class Metrics {
 public:
  /// Precondition: at least one combination.
  explicit Metrics(const std::vector<Combination>& combinations);

  /// False when there is no such metric; that is then added to the findings.
  bool has(const std::string& key, const std::string& pointer, Findings& findings) const;

  /// Whether there is such a metric.
  bool knows(const std::string& key) const;
  const std::vector<std::string>& keys() const { return keys_; }

  /// Whether a run may end without a value: by the metric's nature, or because its barrier does not
  /// exist under every combination.
  bool may_not_exist(const std::string& key) const;

 private:
  std::vector<solver::MetricInfo> catalog_, always_;
  std::vector<std::string> keys_;
};

}  // namespace parapet::designs
