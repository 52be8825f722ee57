// Simulations by the program itself, each kept in a file: what a comparison rests on where an
// emulator's word is not enough.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench_problem.hpp"

namespace parapet::bench::search {

// What a simulation of the program gave.
struct SolverRun {
  bool ok = false;
  double particle_steps = 0.0;
  std::map<std::string, double> metrics;  // those that have a value
  std::vector<std::string> unknown;       // the run was too short or too coarse to tell
};

class SolverRuns {
 public:
  // program: `parapet`; study: its case is simulated; store: JSON lines, one run each, in the
  // order of simulation, made where it is missing. Runs of another program are not taken from it.
  // @throws std::invalid_argument for a file that cannot be read.
  SolverRuns(std::string program, const std::filesystem::path& study,
             const std::filesystem::path& store, const std::vector<std::string>& variables);

  // Lattice 0 is the regular one, as studies have it; another one is moved at random by up to 1 %
  // of the spacing.
  // @throws std::runtime_error when the program gives no result.
  const SolverRun& run(const Design& x, double spacing_m, int lattice);

  int simulated() const { return simulated_; }  // now, not taken from the store

 private:
  std::string key(const Design& x, double spacing_m, int lattice) const;
  std::filesystem::path study_of(int lattice) const;
  nlohmann::ordered_json simulate(const Design& x, double spacing_m, int lattice) const;

  std::string program_, version_;
  std::filesystem::path study_, store_;
  std::vector<std::string> variables_;
  std::map<std::string, SolverRun> known_;
  int simulated_ = 0;
};

}  // namespace parapet::bench::search
