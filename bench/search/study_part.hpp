// What the comparison needs of a study: its variables and the limits that need no simulation.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace parapet::bench::search {

struct StudyPart {
  std::string name;
  std::vector<std::string> variables;
  std::vector<double> lower, upper;  // [d]
  // c [n_cheap] <= 0 allows a design x [d]; empty if there are no such limits.
  std::function<std::vector<double>(const std::vector<double>& x)> cheap_constraints;
};

// @throws std::invalid_argument for a file that cannot be read or is no study.
StudyPart read_study_part(const std::filesystem::path& file);

}  // namespace parapet::bench::search
