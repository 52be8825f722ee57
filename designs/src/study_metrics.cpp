#include "study_metrics.hpp"

#include <algorithm>

#include "words.hpp"

namespace parapet::designs {
namespace {

const solver::MetricInfo* find(const std::vector<solver::MetricInfo>& catalog,
                               const std::string& key) {
  const auto found = std::find_if(catalog.begin(), catalog.end(),
                                  [&](const solver::MetricInfo& info) { return info.key == key; });
  return found == catalog.end() ? nullptr : &*found;
}

}  // namespace

Metrics::Metrics(const std::vector<Combination>& combinations) {
  const auto [fewest, most] = std::minmax_element(
      combinations.begin(), combinations.end(),
      [](const Combination& a, const Combination& b) { return a.n_barriers() < b.n_barriers(); });
  catalog_ = solver::metric_catalog(static_cast<int>(most->n_barriers()));
  always_ = solver::metric_catalog(static_cast<int>(fewest->n_barriers()));
  for (const solver::MetricInfo& info : catalog_) keys_.push_back(info.key);
}

bool Metrics::has(const std::string& key, const std::string& pointer, Findings& findings) const {
  if (find(catalog_, key) != nullptr) return true;
  findings.add(pointer, "is not a metric of this case" + did_you_mean(key, keys_),
               "one of " + joined(keys_));
  return false;
}

bool Metrics::may_be_absent(const std::string& key) const {
  const solver::MetricInfo* info = find(always_, key);
  return info == nullptr || info->may_be_absent();
}

}  // namespace parapet::designs
