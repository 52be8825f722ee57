// bench_search_targets LIST.json PROBLEM SPACINGS SEEDS EVALUATIONS FINEST_RUNS RULE OUT.json
//                      [PROGRAM STORE.jsonl LATTICES]
//
// The Bayesian search on a study with the fidelity levels SPACINGS ("0.005,0.01", finest first):
// what it spends, in particle-steps, and the hypervolume of the front that it ends with. An
// emulator answers, and each design of the front is judged by it at the finest level without
// scatter, as if simulated again there many times; or PROGRAM, `parapet`, answers, its runs are
// kept in STORE.jsonl, and each design of the front is simulated again at the finest level with
// LATTICES other lattices, whose mean counts. The search ends with EVALUATIONS or with the
// particle-steps of FINEST_RUNS (0: no limit). SEEDS: their number, or "4-6" (parts of a study side
// by side; a last call then finds all runs in the store). RULE says what the front is:
//   observed   the feasible designs observed at the finest level
//   estimated  designs known at any level, by the surrogates' medians at the finest one
// Uses of parapet::bayesian only what revision 1c5eedf has too: bench/search/targets builds it
// twice.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "as_bayesian.hpp"
#include "median.hpp"
#include "parapet/bayesian/search.hpp"
#include "parapet/math/pareto.hpp"
#include "target_problem.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  std::istringstream in(text);
  for (std::string one; std::getline(in, one, ',');) result.push_back(std::stod(one));
  return result;
}

// "10": 1 to 10; "4-6".
std::pair<int, int> seeds_of(const std::string& text) {
  const std::size_t dash = text.find('-');
  if (dash == std::string::npos) return {1, std::stoi(text)};
  return {std::stoi(text.substr(0, dash)), std::stoi(text.substr(dash + 1))};
}

std::vector<double> to_user(const BenchProblem& problem, const Eigen::VectorXd& y) {
  std::vector<double> values(y.begin(), y.end());
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (problem.objectives[j].maximize) values[j] = -values[j];
  }
  return values;
}

// Designs of the front, by the rule.
std::vector<Design> front_of(const BenchProblem& problem, const bayesian::Search& search,
                             bool estimated) {
  const auto assessed = search.assessed();
  std::vector<Design> designs;
  if (!estimated) {
    for (const std::size_t k : search.pareto()) designs.push_back(assessed[k].x);
    return designs;
  }
  constexpr double even_odds = 0.5;
  std::vector<Design> known;
  std::vector<math::Objectives> points;
  for (const bayesian::Assessed& one : assessed) {
    if (!one.ok || one.probability_feasible < even_odds) continue;
    if (std::find(known.begin(), known.end(), one.x) != known.end()) continue;
    math::Objectives y(static_cast<Eigen::Index>(problem.objectives.size()));
    for (std::size_t j = 0; j < problem.objectives.size(); ++j) {
      const double value = one.estimate[problem.objectives[j].metric];
      y[static_cast<Eigen::Index>(j)] = problem.objectives[j].maximize ? -value : value;
    }
    if (!y.allFinite()) continue;
    known.push_back(one.x);
    points.push_back(y);
  }
  for (const std::size_t k : math::non_dominated(points)) designs.push_back(known[k]);
  return designs;
}

struct Outcome {
  double particle_steps = 0.0, hypervolume = 0.0;
  std::vector<int> runs;  // [n_levels]
  std::size_t front = 0;
  std::vector<Eigen::VectorXd> judged;  // [n_feasible] of [n_objectives], minimised
};

Outcome run_once(const TargetProblem& target, std::uint64_t seed, int evaluations,
                 double finest_runs, bool estimated) {
  const BenchProblem& problem = target.problem;
  bayesian::SearchOptions options;
  options.max_evaluations = evaluations;
  options.max_finest = finest_runs;
  options.seed = seed;
  bayesian::Problem asked = as_bayesian(problem, true);
  for (std::size_t j = 0; j < asked.objectives.size(); ++j) {
    asked.objectives[j].reference = to_user(problem, target.reference)[j];
  }
  bayesian::Search search(asked, options);
  Outcome outcome;
  outcome.runs.assign(problem.level_seconds.size(), 0);
  while (const auto suggestion = search.ask()) {
    search.tell(suggestion->id, observe(problem, suggestion->x, suggestion->level));
    ++outcome.runs[static_cast<std::size_t>(suggestion->level)];
  }
  outcome.particle_steps = search.seconds();
  for (const Design& x : front_of(problem, search, estimated)) {
    ++outcome.front;
    const Verdict verdict = judge(problem, problem.truth(x));
    if (verdict.feasible) outcome.judged.push_back(verdict.objectives);
  }
  outcome.hypervolume = math::hypervolume(outcome.judged, target.reference);
  return outcome;
}

void run(const std::vector<std::string>& a) {
  AnswerSource source;
  if (a.size() > 8) source = {a[8], a[9], std::stoi(a[10])};
  const TargetProblem target = load_target(a[0], a[1], numbers(a[2]), source);
  const auto [first, last] = seeds_of(a[3]);
  const int evaluations = std::stoi(a[4]);
  const double finest_runs = std::stod(a[5]);
  Json rows = Json::array();
  std::vector<double> volumes, costs;
  for (int k = first; k <= last; ++k) {
    const Outcome o = run_once(target, static_cast<std::uint64_t>(k), evaluations, finest_runs,
                               a[6] == "estimated");
    volumes.push_back(o.hypervolume);
    costs.push_back(o.particle_steps);
    Json judged = Json::array();
    for (const Eigen::VectorXd& y : o.judged) judged.push_back(to_user(target.problem, y));
    rows.push_back({{"seed", k},
                    {"particle_steps", o.particle_steps},
                    {"hypervolume", o.hypervolume},
                    {"runs", o.runs},
                    {"front", o.front},
                    {"judged", judged}});
    fmt::print("  {} seed {}: {:.3g} particle-steps, runs {}, front {}, hypervolume {:.5f}\n", a[1],
               k, o.particle_steps, Json(o.runs).dump(), o.front, o.hypervolume);
    std::fflush(stdout);
  }
  fmt::print("  {}: median {:.3g} particle-steps, hypervolume median {:.5f}, worst {:.5f}\n", a[1],
             median(costs), median(volumes), *std::min_element(volumes.begin(), volumes.end()));
  std::ofstream file(a[7]);
  file << Json{{"problem", a[1]}, {"spacings_m", numbers(a[2])}, {"rule", a[6]}, {"rows", rows}}
              .dump(1)
       << '\n';
  if (!file) throw std::runtime_error("cannot write " + a[7]);
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  if (argc != 9 && argc != 12) {
    fmt::print(stderr,
               "usage: bench_search_targets LIST.json PROBLEM SPACINGS SEEDS EVALUATIONS "
               "FINEST_RUNS observed|estimated OUT.json [PROGRAM STORE.jsonl LATTICES]\n");
    return 2;
  }
  try {
    parapet::bench::search::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_targets: {}\n", error.what());
    return 1;
  }
}
