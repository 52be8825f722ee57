// bench_search_oracle LIST.json TABLES PROBLEM
//
// Evaluates designs over a pipe, for optimisers in other languages. First it prints one line:
//   {"variables": [...], "lower": [...], "upper": [...], "objectives": n, "limits": n,
//    "seconds": nominal cost of an evaluation, "budget": evaluations}
// then answers every line {"x": [...]} with one line:
//   {"cheap": [...], "allowed": false}  the cheap constraints refuse it: nothing was evaluated
//   {"cheap": [...], "allowed": true, "ok": false}
//   {"cheap": [...], "allowed": true, "ok": true, "objectives": [...], "violations": [...]}
// Objectives are minimised; of cheap constraints and violations, <= 0 is met.
#include <fmt/format.h>

#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench_problem.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

Json answer(const BenchProblem& problem, const Design& x) {
  Json json = {{"cheap", Json::array()}, {"allowed", problem.allows(x)}};
  if (problem.cheap_constraints) json["cheap"] = problem.cheap_constraints(x);
  if (!json["allowed"]) return json;
  const Verdict verdict = judge(problem, problem.evaluate(x, 0));
  json["ok"] = verdict.ok;
  if (!verdict.ok) return json;
  json["objectives"] = std::vector<double>(verdict.objectives.begin(), verdict.objectives.end());
  json["violations"] = verdict.violations;
  return json;
}

void serve(const BenchProblem& problem) {
  const Json greeting = {{"variables", problem.variables},
                         {"lower", problem.lower},
                         {"upper", problem.upper},
                         {"objectives", problem.objectives.size()},
                         {"limits", problem.limits.size()},
                         {"seconds", problem.level_seconds.front()},
                         {"budget", problem.peer_evaluations}};
  std::cout << greeting.dump() << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << answer(problem, Json::parse(line).at("x").get<Design>()).dump() << std::endl;
  }
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  using namespace parapet::bench::search;
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_search_oracle LIST.json TABLES PROBLEM\n");
    return 2;
  }
  try {
    serve(load_problem(argv[1], argv[2], argv[3]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_oracle: {}\n", error.what());
    return 1;
  }
}
