// bench_search_compare LIST.json TABLES PROBLEM OUT SEEDS [--quick]
//
// Runs every method but Optuna on a problem and leaves what each asked for in OUT/METHOD.json; the
// front found by brute force goes to OUT/front/front.json. --quick: small budgets, to see that all
// works.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <functional>

#include "runs_file.hpp"

namespace parapet::bench::search {
namespace {

struct Entry {
  MethodRuns runs;
  std::function<Run(std::uint64_t seed)> run;
};

std::vector<Entry> methods(const BenchProblem& problem, int budget, int peer_budget) {
  std::vector<Entry> entries;
  const auto add = [&](const std::string& method, const std::string& label,
                       const std::string& family, std::function<Run(std::uint64_t)> run) {
    entries.push_back({{method, label, family, {}}, std::move(run)});
  };
  add("random", "Sobol' points", "random",
      [&problem, peer_budget](std::uint64_t s) { return random_search(problem, s, peer_budget); });
  for (const std::string algorithm : {"COBYLA", "SBPLX", "GN_CRS2_LM", "GN_DIRECT_L"}) {
    add("nlopt_" + algorithm, algorithm + ", scalarised (NLopt)", "nlopt",
        [&problem, algorithm, peer_budget](std::uint64_t s) {
          return scalarised_search(problem, algorithm, s, peer_budget);
        });
  }
  for (const int population : {20, 40}) {
    add(fmt::format("pagmo_nsga2_{}", population),
        fmt::format("NSGA-II, population {} (pagmo2)", population), "pagmo_nsga2",
        [&problem, population, peer_budget](std::uint64_t s) {
          return nsga2_search(problem, population, s, peer_budget);
        });
  }
  add("bayesian", "Bayesian (Parapet)", "bayesian",
      [&problem, budget](std::uint64_t s) { return bayesian_search(problem, false, s, budget); });
  if (problem.level_seconds.size() > 1) {
    // as many seconds as the search at one level has; coarse evaluations are many
    const double seconds = budget * problem.level_seconds.front();
    add("bayesian_levels", "Bayesian, two levels (Parapet)", "bayesian_levels",
        [&problem, budget, seconds](std::uint64_t s) {
          return bayesian_search(problem, true, s, 4 * budget, seconds);
        });
  }
  return entries;
}

void write(const std::filesystem::path& file, const nlohmann::ordered_json& json) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file);
  out << json.dump() << '\n';
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

void compare(const BenchProblem& problem, const std::filesystem::path& out, int seeds, bool quick) {
  nlohmann::ordered_json front = nlohmann::ordered_json::array();
  for (const Eigen::VectorXd& y : brute_force_front(problem, quick ? 8000 : 100000)) {
    front.push_back(std::vector<double>(y.begin(), y.end()));
  }
  write(out / "front" / "front.json", front);
  const int budget = quick ? 30 : problem.evaluations;
  const int peer_budget = quick ? 60 : problem.peer_evaluations;
  for (Entry& entry : methods(problem, budget, peer_budget)) {
    for (int seed = 1; seed <= seeds; ++seed) {
      entry.runs.runs.push_back(entry.run(static_cast<std::uint64_t>(seed)));
    }
    const Run& last = entry.runs.runs.back();
    fmt::print("  {:<32} {} runs, {} evaluations, {:.2f} s of its own\n", entry.runs.label, seeds,
               last.steps.size(), last.own_seconds);
    std::fflush(stdout);
    write(out / (entry.runs.method + ".json"), to_json(entry.runs));
  }
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  using namespace parapet::bench::search;
  const bool quick = argc == 7 && std::string(argv[6]) == "--quick";
  if (argc != 6 && !quick) {
    fmt::print(stderr,
               "usage: bench_search_compare LIST.json TABLES PROBLEM OUT SEEDS [--quick]\n");
    return 2;
  }
  try {
    compare(load_problem(argv[1], argv[2], argv[3]), argv[4], std::stoi(argv[5]), quick);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_compare: {}\n", error.what());
    return 1;
  }
}
