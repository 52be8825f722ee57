// Simulations of a study at several particle spacings, interpolated by co-kriging: stands for the
// solver where a comparison needs thousands of runs.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench_problem.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::bench::search {

class Emulator {
 public:
  // File of one run a line: {"design": {..}, "spacing_m": .., "particle_steps": .., "metrics":
  // {..: number or null}}; a metric that is null does not exist there (nothing overflowed). Levels:
  // the spacings wanted, finest first; every run counts, whichever spacings are wanted.
  Emulator(const std::filesystem::path& file, const std::vector<std::string>& variables,
           const std::vector<double>& lower, const std::vector<double>& upper,
           const std::vector<std::string>& metrics, const std::string& overflow_metric,
           const std::vector<double>& spacings);

  // Median of the metric at a level, without scatter. A launch is empty where nothing overflows:
  // where the overflow metric, the retention of the first barrier, is as good as one.
  std::optional<double> smooth(const std::string& metric, const Design& x, std::size_t level) const;

  // With the scatter from one design to its neighbour, of the size that the fit found. It belongs
  // to the design and repeats.
  std::optional<double> noisy(const std::string& metric, const Design& x, std::size_t level) const;

  double particle_steps(std::size_t level) const { return steps_[level]; }  // mean of a run
  std::string summary() const;  // runs of each level, leave-one-out Q^2

 private:
  std::vector<double> unit(const Design& x) const;
  std::optional<double> value(const std::string& metric, const Design& x, std::size_t level,
                              bool scatter) const;

  std::vector<double> lower_, upper_;
  std::string overflow_metric_;
  std::vector<double> steps_;               // [n_levels]
  std::vector<std::size_t> level_of_file_;  // [n_levels] among the spacings of the file
  std::vector<double> file_spacings_;       // finest first
  std::vector<int> runs_;                   // [n_file_spacings]
  std::map<std::string, surrogate::GaussianProcess> processes_;
};

}  // namespace parapet::bench::search
