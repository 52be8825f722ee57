// bench_search_zoo OUT.json SEEDS EVALUATIONS
//
// The Bayesian search against Sobol' points on problems whose fronts are known: evaluations to 90
// and 95 % of the true hypervolume; with noise and with failing evaluations too.
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "zoo_problem.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

struct Case {
  zoo::ZooProblem problem;
  Trouble trouble;
};

std::vector<Case> cases() {
  const Trouble none{"", 0.0, 0.0, 0.0};
  std::vector<Case> all;
  for (const zoo::ZooProblem& p :
       {zoo::branin(), zoo::hartmann_6(), zoo::bnh(), zoo::srn(), zoo::tnk(), zoo::c2_dtlz2(2),
        zoo::c2_dtlz2(3), zoo::zdt(1), zoo::zdt(2), zoo::zdt(3)}) {
    all.push_back({p, none});
  }
  for (const zoo::ZooProblem& p : {zoo::bnh(), zoo::c2_dtlz2(2), zoo::zdt(1)}) {
    all.push_back({p, {"noise of 5 %", 0.05, 0.0, 0.0}});
  }
  for (const zoo::ZooProblem& p : {zoo::bnh(), zoo::zdt(1)}) {
    all.push_back({p, {"30 % fail, anywhere", 0.0, 0.3, 0.0}});
  }
  all.push_back({zoo::zdt(1), {"30 % fail, a region", 0.0, 0.0, 0.3}});
  return all;
}

Json as_json(const MethodScore& score, int budget) {
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  return {{"budget", budget},
          {"evaluations_90", number(score.evaluations[0])},
          {"evaluations_95", number(score.evaluations[1])},
          {"share_at_end", score.median_share.empty() ? 0.0 : score.median_share.back()},
          {"worst_share_at_end", score.worst_share},
          {"own_seconds", score.own_seconds}};
}

Json compare(const Case& one, int seeds, int evaluations) {
  const BenchProblem problem = zoo_problem(one.problem, one.trouble);
  const Yardstick yardstick = zoo_yardstick(one.problem);
  MethodRuns ours{"bayesian", "Bayesian (Parapet)", "bayesian", {}};
  MethodRuns chance{"random", "Sobol' points", "random", {}};
  for (int k = 1; k <= seeds; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    ours.runs.push_back(bayesian_search(problem, false, seed, evaluations));
    chance.runs.push_back(random_search(problem, seed, evaluations));
  }
  return {{"problem", one.problem.name},
          {"variant", one.trouble.name},
          {"bayesian", as_json(score(problem, yardstick, ours), evaluations)},
          {"random", as_json(score(problem, yardstick, chance), evaluations)}};
}

void run(const std::string& out, int seeds, int evaluations) {
  Json json = {{"seeds", seeds}, {"evaluations", evaluations}, {"rows", Json::array()}};
  for (const Case& one : cases()) {
    const Json row = compare(one, seeds, evaluations);
    fmt::print("  {} {}: {} | {}\n", one.problem.name, one.trouble.name, row["bayesian"].dump(),
               row["random"].dump());
    std::fflush(stdout);
    json["rows"].push_back(row);
  }
  std::ofstream file(out);
  file << json.dump(1) << '\n';
  if (!file) throw std::runtime_error("cannot write " + out);
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_search_zoo OUT.json SEEDS EVALUATIONS\n");
    return 2;
  }
  try {
    parapet::bench::search::run(argv[1], std::stoi(argv[2]), std::stoi(argv[3]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_zoo: {}\n", error.what());
    return 1;
  }
}
