// Rows of the Table 3 case by their names, and how its scorecard is written.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "barrier_runs.hpp"
#include "parapet/designs/study_spec.hpp"

namespace parapet::validation {

// Single barriers of 100 mm by the deflector's angle.
inline const std::vector<std::string> angles{"H10-D0", "H10-D30", "H10-D45", "H10-D60"};

// Rows by their ID.
class Rows {
 public:
  Rows(const std::vector<designs::SweepRow>& rows, const std::vector<solver::Result>& results) {
    for (std::size_t k = 0; k < rows.size(); ++k) results_[rows[k].id] = &results[k];
  }
  bool has(const std::string& id) const { return results_.contains(id); }
  const solver::Result& result(const std::string& id) const { return *results_.at(id); }
  double operator()(const std::string& id, const std::string& key) const {
    return metric(result(id), key);
  }

 private:
  std::map<std::string, const solver::Result*> results_;
};

// Smallest step from row to row; positive when the metric rises all along.
inline double smallest_rise(const Rows& rows, const std::vector<std::string>& ids,
                            const char* key) {
  double least = 1e9;
  for (std::size_t k = 1; k < ids.size(); ++k) {
    least = std::min(least, rows(ids[k], key) - rows(ids[k - 1], key));
  }
  return least;
}

inline void add_trend(CaseRun& run, const char* key, const std::string& what, double value,
                      const char* unit, std::optional<double> lower, std::optional<double> upper,
                      const std::string& stated, const std::string& explanation = "") {
  run.add({.key = key,
           .what = what,
           .value = value,
           .unit = unit,
           .lower = lower,
           .upper = upper,
           .reason = stated,
           .explanation = explanation});
}

// What the paper says in words: dead zones, ramps, overflow, backflow, the reduction factor, B/h.
void add_words(CaseRun& run, const Rows& rows);

}  // namespace parapet::validation
