#include "metric_table.hpp"

#include "metric_entries.hpp"

namespace parapet::solver {

std::vector<const Absent*> absent_when(const MetricEntry& entry) {
  std::vector<const Absent*> reasons;
  bool may_come = false;
  for (const Absent* reason : entry.absent_when) {
    if (reason == nullptr) continue;
    reasons.push_back(reason);
    may_come = may_come || reason->may_come;
  }
  if (entry.coarsest) reasons.push_back(entry.coarse_reason);
  if (entry.mass_share) reasons.push_back(&absence::too_few);
  if (may_come) reasons.push_back(&absence::run_too_short);
  return reasons;
}

MetricTable metric_table() {
  return {overflow_metrics(), channel_metrics(), barrier_metrics()};
}

std::string barrier_key(const MetricEntry& entry, std::size_t barrier) {
  return "barrier_" + std::to_string(barrier + 1) + "_" +
         std::string(entry.key.substr(barrier_placeholder.size()));
}

}  // namespace parapet::solver
