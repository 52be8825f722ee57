#include "study_metrics.hpp"

#include <algorithm>

#include "parapet/designs/study_spec.hpp"
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
  if (const std::string now = with_present_names(key); find(catalog_, now) != nullptr) {
    std::string design = now;
    design.replace(design.find("_slam_"), 6, "_design_");
    findings.add(
        pointer,
        "was the largest mean over 5 ms, which does not converge with the particle spacing",
        design + ", the load to design with, or " + now + " for the former quantity");
    return false;
  }
  findings.add(pointer, "is not a metric of this case" + did_you_mean(key, keys_),
               "one of " + joined(keys_));
  return false;
}

bool Metrics::knows(const std::string& key) const {
  return find(catalog_, key) != nullptr;
}

bool Metrics::may_not_exist(const std::string& key) const {
  const solver::MetricInfo* info = find(always_, key);
  return info == nullptr || info->may_not_exist;
}

}  // namespace parapet::designs
