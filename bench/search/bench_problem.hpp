// A problem that every search method is given: named metrics, objectives, limits, and an evaluator.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace parapet::bench::search {

using Design = std::vector<double>;  // [d] in the variables' units

struct BenchMetric {
  std::string name;
  std::function<double(const Design&)> exact;  // a formula of the design; else empty
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

struct BenchObjective {
  std::size_t metric = 0;
  bool maximize = false;
  std::optional<double> value_when_absent;
};

// lower <= metric <= upper, satisfied where the metric has no value; the violation is divided by
// the scale.
struct BenchLimit {
  std::size_t metric = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double scale = 1.0;
};

// What an evaluation gives: values [n_metrics], empty where a metric has none.
struct Answer {
  bool ok = false;
  std::vector<std::optional<double>> values;
  std::optional<double> seconds = {};  // what it cost, where that differs from the level's
};

struct BenchProblem {
  std::string name;
  std::string title;  // for people
  std::vector<std::string> variables;
  std::vector<double> lower, upper;  // [d]
  std::vector<BenchMetric> metrics;
  std::vector<BenchObjective> objectives;
  std::vector<BenchLimit> limits;
  std::function<std::vector<double>(const Design&)> cheap_constraints;  // <= 0 allows; or empty
  // What a method sees: noise and failures included. Level 0 is the finest.
  std::function<Answer(const Design&, int level)> evaluate;
  // What a design is worth: the finest level without noise.
  std::function<Answer(const Design&)> truth;
  std::vector<double> level_seconds{1.0};  // nominal cost of an evaluation
  int evaluations = 100;                   // budget of the Bayesian search
  int peer_evaluations = 100;              // budget of the others, which are cheap

  std::size_t dimension() const { return variables.size(); }
  bool allows(const Design& x) const;
  Design from_unit(const std::vector<double>& u) const;
};

// An answer in the terms of the problem.
struct Verdict {
  bool ok = false;
  Eigen::VectorXd objectives;      // [n_objectives], minimised; empty if not ok
  std::vector<double> violations;  // [n_limits], scaled, <= 0 is satisfied
  bool feasible = false;           // ok and no violation above 1e-9

  double total_violation() const;  // sum of what is positive
};

Verdict judge(const BenchProblem& problem, const Answer& answer);

// Reads the list of problems and builds one of them: its studies stand beside the list, its tables
// in `tables` (NAME.json of every level). Limits of expressions are those of the finest study
// unless the list has its own.
// @throws std::invalid_argument for an unknown name or a file that does not fit.
BenchProblem load_problem(const std::filesystem::path& list, const std::filesystem::path& tables,
                          const std::string& name);
std::vector<std::string> problem_names(const std::filesystem::path& list);

// The studies of a problem's levels of fidelity, the finest first.
std::vector<std::string> level_names(const std::filesystem::path& list, const std::string& name);

}  // namespace parapet::bench::search
