// The studies of bench/search/targets: problems at several particle spacings, whose answers come
// from an emulator or from the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench_problem.hpp"

namespace parapet::bench::search {

struct TargetProblem {
  BenchProblem problem;       // costs in particle-steps
  Eigen::VectorXd reference;  // [n_objectives], minimised
};

// Where answers come from. Without a program: co-kriging of the runs beside the list, judged
// without its scatter.
struct AnswerSource {
  std::string program;          // `parapet`; designs are judged by the mean over moved lattices
  std::filesystem::path store;  // of its runs
  int judging_lattices = 1;
};

// @param list The problems; their studies stand beside it.
// @param spacings_m The fidelity levels, finest first.
// @throws std::invalid_argument for an unknown name or a file that does not fit.
TargetProblem load_target(const std::filesystem::path& list, const std::string& name,
                          const std::vector<double>& spacings_m, const AnswerSource& source);

}  // namespace parapet::bench::search
