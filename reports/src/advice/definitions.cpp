#include "definitions.hpp"

#include <algorithm>

#include "parapet/solver/metric_catalog.hpp"

namespace parapet::reports {
namespace {

/// 2 for "barrier_2_design_force_n_per_m"; 0 for a metric of no barrier.
int barrier_of(const std::string& key) {
  const std::string prefix = "barrier_";
  if (!key.starts_with(prefix)) return 0;
  int number = 0;
  for (std::size_t k = prefix.size(); k < key.size() && key[k] >= '0' && key[k] <= '9'; ++k) {
    number = 10 * number + (key[k] - '0');
  }
  return number;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> metric_definitions(
    const study::LoadedStudy& study) {
  int barriers = 0;
  for (const records::EvaluationRecord& record : study.designs) {
    for (const solver::Metric& metric : record.metrics) {
      barriers = std::max(barriers, barrier_of(metric.key));
    }
  }
  std::vector<std::pair<std::string, std::string>> list;
  for (const solver::MetricInfo& info : solver::metric_catalog(barriers)) {
    list.emplace_back(info.key, info.definition);
  }
  return list;
}

}  // namespace parapet::reports
