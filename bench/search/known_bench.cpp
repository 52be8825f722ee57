// bench_search_known OUT.json SEEDS [NAME]
//
// The Bayesian search and NLopt's algorithms on the problems of known_problems.hpp (or those whose
// name begins with NAME): the gap to the least value, or the share of the best hypervolume, at the
// end of the budget; median and worst of the seeds.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "known_problems.hpp"
#include "median.hpp"
#include "methods.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

// Gap of the best feasible design (one objective) or the share of the hypervolume.
double result(const KnownProblem& known, const Run& run) {
  if (!known.one_objective()) {
    const Curve curve = score(known.problem, known.yardstick, run);
    return curve.share.empty() ? 0.0 : curve.share.back();
  }
  double best = std::numeric_limits<double>::infinity();
  for (const Step& step : run.steps) {
    const Verdict verdict = judge(known.problem, known.problem.truth(step.x));
    if (verdict.feasible) best = std::min(best, verdict.objectives[0]);
  }
  return best - known.least;
}

Json row(const KnownProblem& known, const std::string& method, const std::vector<double>& results,
         double own_seconds) {
  const auto [least, greatest] = std::minmax_element(results.begin(), results.end());
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  return {{"problem", known.problem.name},
          {"evaluations", known.problem.evaluations},
          {"measure", known.one_objective() ? "gap" : "share"},
          {"method", method},
          {"median", number(median(results))},
          {"worst", number(known.one_objective() ? *greatest : *least)},
          {"own_seconds", own_seconds}};
}

void run(const std::string& out, int seeds, const std::string& only) {
  Json rows = Json::array();
  for (const KnownProblem& known : known_problems()) {
    if (!known.problem.name.starts_with(only)) continue;
    const BenchProblem& problem = known.problem;
    const int budget = problem.evaluations;
    const auto add = [&](const std::string& method, const auto& one_run) {
      std::vector<double> results;
      double own = 0.0;
      for (int k = 1; k <= seeds; ++k) {
        const Run done = one_run(static_cast<std::uint64_t>(k));
        results.push_back(result(known, done));
        own += done.own_seconds / seeds;
      }
      rows.push_back(row(known, method, results, own));
      std::string all;
      for (const double r : results) all += fmt::format(" {:.3g}", r);
      fmt::print(
          "  {:<24} {:<12} median {:<9.3g} worst {:<9.3g} own {:.1f} s |{}\n", problem.name, method,
          rows.back()["median"].is_null() ? -1.0 : rows.back()["median"].get<double>(),
          rows.back()["worst"].is_null() ? -1.0 : rows.back()["worst"].get<double>(), own, all);
      std::fflush(stdout);
    };
    add("bayesian", [&](auto seed) { return bayesian_search(problem, false, seed, budget); });
    for (const std::string algorithm : {"COBYLA", "SBPLX", "GN_CRS2_LM"}) {
      add(algorithm,
          [&](auto seed) { return scalarised_search(problem, algorithm, seed, budget); });
    }
  }
  std::ofstream file(out);
  file << Json{{"seeds", seeds}, {"rows", rows}}.dump(1) << '\n';
  if (!file) throw std::runtime_error("cannot write " + out);
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    fmt::print(stderr, "usage: bench_search_known OUT.json SEEDS [NAME]\n");
    return 2;
  }
  try {
    parapet::bench::search::run(argv[1], std::stoi(argv[2]), argc == 4 ? argv[3] : "");
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_known: {}\n", error.what());
    return 1;
  }
}
