// bench_search_overhead LIST.json TABLES OUT.json EVALUATIONS...
//
// The Bayesian search's own time at some budgets, against what the simulations would take (the
// table's median wall time each).
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "methods.hpp"

namespace parapet::bench::search {
namespace {

void measure(const std::string& list, const std::string& tables, const std::string& out,
             const std::vector<int>& budgets) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::string& name : problem_names(list)) {
    const BenchProblem problem = load_problem(list, tables, name);
    for (const int budget : budgets) {
      const Run run = bayesian_search(problem, false, 1, budget);
      double simulated = 0.0;
      for (const Step& step : run.steps) simulated += step.seconds;
      rows.push_back({{"problem", name},
                      {"evaluations", run.steps.size()},
                      {"own_seconds", run.own_seconds},
                      {"simulated_seconds", simulated}});
      fmt::print("  {}: {} evaluations, own {:.2f} s, simulations {:.0f} s\n", name,
                 run.steps.size(), run.own_seconds, simulated);
      std::fflush(stdout);
    }
  }
  std::ofstream file(out);
  file << rows.dump(1) << '\n';
  if (!file) throw std::runtime_error("cannot write " + out);
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: bench_search_overhead LIST.json TABLES OUT.json EVALUATIONS...\n");
    return 2;
  }
  try {
    std::vector<int> budgets;
    for (int k = 4; k < argc; ++k) budgets.push_back(std::stoi(argv[k]));
    parapet::bench::search::measure(argv[1], argv[2], argv[3], budgets);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_overhead: {}\n", error.what());
    return 1;
  }
}
