#include <algorithm>
#include <numeric>

#include "study_parts.hpp"

namespace parapet::designs {
namespace {

/// A list beside spacings_m must have an entry for each of them.
bool has_all_levels(const Json& list, std::size_t n_levels, const std::string& pointer,
                    Findings& findings) {
  if (list.size() == n_levels) return true;
  findings.add(pointer,
               "has " + std::to_string(list.size()) + " entries for " + std::to_string(n_levels) +
                   " spacings",
               "one entry for each of /fidelity/spacings_m");
  return false;
}

}  // namespace

std::vector<FidelityLevel> read_fidelity(const Json& json, const Json& resolved_case,
                                         const Metrics& metrics, Findings& findings) {
  std::vector<FidelityLevel> levels;
  if (json.contains("spacings_m")) {
    for (const Json& spacing : json.at("spacings_m"))
      levels.push_back({spacing.get<double>(), {}, {}});
  } else {
    levels.push_back({resolved_case.at("numerics").at("spacing_m").get<double>(), {}, {}});
  }
  const Json& seconds = json.at("cpu_time_s");
  if (!seconds.empty() &&
      has_all_levels(seconds, levels.size(), "/fidelity/cpu_time_s", findings)) {
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k].seconds = seconds[k].get<double>();
  }
  for (const auto& [metric, noise] : json.at("noise").items()) {
    const std::string pointer = child_pointer("/fidelity/noise", metric);
    if (!metrics.has(metric, pointer, findings)) continue;
    if (!has_all_levels(noise, levels.size(), pointer, findings)) continue;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      levels[k].noise[metric] = noise[k].get<double>();
    }
  }
  std::stable_sort(
      levels.begin(), levels.end(),
      [](const FidelityLevel& a, const FidelityLevel& b) { return a.spacing < b.spacing; });
  for (std::size_t k = 1; k < levels.size(); ++k) {
    if (levels[k].spacing != levels[k - 1].spacing) continue;
    findings.add("/fidelity/spacings_m", "holds " + Json(levels[k].spacing).dump() + " twice",
                 "each spacing once");
  }
  return levels;
}

}  // namespace parapet::designs
