#include "parapet/records/sweep_row.hpp"

namespace parapet::records {

std::optional<double> SweepRowResult::metric(const std::string& key) const {
  const auto found = metrics.find(key);
  return found == metrics.end() ? std::nullopt : found->second;
}

SweepRowResult make_sweep_row_result(const designs::SweepRow& row, const solver::Result& result) {
  SweepRowResult out;
  out.id = row.id;
  out.description = row.description;
  out.status = result.status;
  out.reason = result.reason;
  for (const solver::Metric& entry : result.metrics) {
    out.metrics[entry.key] = entry.value;
    if (!entry.value) out.metrics_absent[entry.key] = entry.absent_reason;
  }
  out.stop_time = result.stop_time;
  out.stop_reason = std::string(solver::to_string(result.stop_reason));
  out.steps = result.statistics.steps;
  out.wall_time = result.statistics.wall_time;
  out.published = row.published;
  return out;
}

}  // namespace parapet::records
