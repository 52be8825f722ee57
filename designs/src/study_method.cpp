#include "study_parts.hpp"

namespace parapet::designs {
namespace {

int whole(const Json& json, const char* key) {
  return static_cast<int>(json.at(key).get<double>());
}

Scalarization read_scalarization(const Json& json) {
  const std::string word = json.at("scalarization").get<std::string>();
  if (word == "epsilon_constraint") return Scalarization::epsilon_constraint;
  if (word == "augmented_chebyshev") return Scalarization::augmented_chebyshev;
  return Scalarization::weighted_sum;
}

}  // namespace

Method read_method(const Json& json, const std::vector<Variable>& variables, Findings& findings) {
  Method method;
  method.algorithm = json.at("algorithm").get<std::string>();
  method.local_algorithm = json.at("local_algorithm").get<std::string>();
  method.max_evaluations = whole(json, "max_evaluations");
  method.max_time_s = json.at("max_time_s").get<double>();
  method.max_cpu_time_s = json.at("max_cpu_time_s").get<double>();
  method.relative_tolerance = json.at("relative_tolerance").get<double>();
  method.seed = static_cast<std::uint64_t>(json.at("seed").get<double>());
  method.start_count = whole(json, "start_count");
  method.initial_step = json.at("initial_step").get<double>();
  method.scalarization = read_scalarization(json);
  method.pareto_points = whole(json, "pareto_points");
  method.points_per_variable = whole(json, "points_per_variable");
  method.stagnation_evaluations = whole(json, "stagnation_evaluations");
  method.least_gain = json.at("least_gain").get<double>();
  method.max_finest_runs = json.at("max_finest_runs").get<double>();
  method.repeatable = json.at("repeatable").get<bool>();
  const Json& starts = json.at("starts");
  // A start cannot be judged by variables that are wrong themselves.
  for (std::size_t k = 0; k < starts.size() && !variables.empty(); ++k) {
    method.starts.push_back(
        read_design_values(variables, starts[k], child_pointer("/method/starts", k), findings));
  }
  const auto n_starts = static_cast<long>(starts.size()) + method.start_count;
  if (n_starts > method.max_evaluations) {
    findings.add("/method/max_evaluations",
                 "does not even allow the " + std::to_string(n_starts) + " starting designs",
                 "at least the number of starts and start_count together");
  }
  return method;
}

}  // namespace parapet::designs
