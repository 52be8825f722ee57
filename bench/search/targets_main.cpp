// bench_search_targets LIST.json PROBLEM SPACINGS SEEDS EVALUATIONS PARTICLE_STEPS RULE OUT.json
//
// The Bayesian search on an emulated study with the fidelity levels SPACINGS ("0.005,0.01", finest
// first): what it spends, in particle-steps, and the hypervolume of the front that it ends with,
// each design of it judged by the emulator of the finest level without scatter, as if simulated
// again there many times. The search ends with EVALUATIONS or PARTICLE_STEPS (0: no limit). RULE
// says what the front is:
//   observed   the feasible designs observed at the finest level
//   estimated  designs known at any level, by the surrogates' medians at the finest one
// Uses of parapet::bayesian only what revision 1c5eedf has too: bench/search/targets builds it
// twice.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "as_bayesian.hpp"
#include "emulator.hpp"
#include "median.hpp"
#include "parapet/bayesian/search.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/math/pareto.hpp"
#include "study_part.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

struct TargetProblem {
  BenchProblem problem;
  Eigen::VectorXd reference;  // [n_objectives], minimised
};

std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  std::istringstream in(text);
  for (std::string one; std::getline(in, one, ',');) result.push_back(std::stod(one));
  return result;
}

void add_objective(BenchProblem& problem, const Json& json) {
  BenchObjective objective;
  objective.maximize = json.at("goal") == "maximize";
  if (json.contains("value_when_absent")) objective.value_when_absent = json["value_when_absent"];
  if (json.contains("metric")) {
    const std::string name = json.at("metric");
    objective.metric = static_cast<std::size_t>(
        std::find_if(problem.metrics.begin(), problem.metrics.end(),
                     [&](const BenchMetric& m) { return m.name == name; }) -
        problem.metrics.begin());
  } else {
    objective.metric = problem.metrics.size();
    const std::string expression = json.at("expression");
    problem.metrics.push_back(
        {json.at("name"), [expression, variables = problem.variables](const Design& x) {
           designs::Design design;
           for (std::size_t j = 0; j < x.size(); ++j) design[variables[j]] = x[j];
           return designs::evaluate_expression(expression, design);
         }});
  }
  problem.objectives.push_back(objective);
}

// Retention and launch length are what the studies need.
TargetProblem load_target(const std::filesystem::path& list, const std::string& name,
                          const std::vector<double>& spacings) {
  std::ifstream in(list);
  if (!in) throw std::invalid_argument("cannot read " + list.string());
  const Json problems = Json::parse(in).at("problems");
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const Json& one) { return one.at("name") == name; });
  if (found == problems.end()) throw std::invalid_argument("there is no problem " + name);
  const Json& json = *found;
  const StudyPart study =
      read_study_part(list.parent_path() / (json.at("study").get<std::string>() + ".json"));
  TargetProblem target;
  BenchProblem& problem = target.problem;
  problem.name = name;
  problem.variables = study.variables;
  problem.lower = study.lower;
  problem.upper = study.upper;
  problem.cheap_constraints = cheap_constraints(study.variables, study.limits);
  const auto metrics = json.at("metrics").get<std::vector<std::string>>();
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    problem.metrics.push_back({metrics[m], nullptr, 0.0, m == 0 ? 1.0 : infinity});
  }
  const auto emulator = std::make_shared<Emulator>(
      list.parent_path().parent_path() / "tables" / json.at("runs").get<std::string>(),
      study.variables, study.lower, study.upper, metrics, json.at("overflow_metric"), spacings);
  fmt::print("  {}: {}\n", name, emulator->summary());
  problem.level_seconds.clear();
  for (std::size_t level = 0; level < spacings.size(); ++level) {
    problem.level_seconds.push_back(emulator->particle_steps(level));
  }
  for (const Json& objective : json.at("objectives")) add_objective(problem, objective);
  for (const Json& limit : json.at("limits")) {
    const auto place = std::find(metrics.begin(), metrics.end(), limit.at("metric"));
    problem.limits.push_back({static_cast<std::size_t>(place - metrics.begin()), -infinity,
                              limit.at("upper"), limit.at("upper")});
  }
  const auto answer = [metrics = problem.metrics, emulator](const Design& x, std::size_t level,
                                                            bool scatter) {
    Answer result{true, {}};
    for (const BenchMetric& m : metrics) {
      if (m.exact) {
        result.values.emplace_back(m.exact(x));
      } else {
        result.values.push_back(scatter ? emulator->noisy(m.name, x, level)
                                        : emulator->smooth(m.name, x, level));
      }
    }
    return result;
  };
  problem.evaluate = [answer](const Design& x, int level) {
    return answer(x, static_cast<std::size_t>(level), true);
  };
  problem.truth = [answer](const Design& x) { return answer(x, 0, false); };
  const auto reference = json.at("reference").get<std::vector<double>>();
  target.reference.resize(static_cast<Eigen::Index>(reference.size()));
  for (std::size_t j = 0; j < reference.size(); ++j) {
    const bool maximize = problem.objectives[j].maximize;
    target.reference[static_cast<Eigen::Index>(j)] = maximize ? -reference[j] : reference[j];
  }
  return target;
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
};

Outcome run_once(const TargetProblem& target, std::uint64_t seed, int evaluations, double steps,
                 bool estimated) {
  const BenchProblem& problem = target.problem;
  bayesian::SearchOptions options;
  options.max_evaluations = evaluations;
  options.max_seconds = steps;
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
  std::vector<Eigen::VectorXd> points;
  for (const Design& x : front_of(problem, search, estimated)) {
    ++outcome.front;
    const Verdict verdict = judge(problem, problem.truth(x));
    if (verdict.feasible) points.push_back(verdict.objectives);
  }
  outcome.hypervolume = math::hypervolume(points, target.reference);
  return outcome;
}

void run(const std::vector<std::string>& a) {
  const TargetProblem target = load_target(a[0], a[1], numbers(a[2]));
  const int seeds = std::stoi(a[3]), evaluations = std::stoi(a[4]);
  const double steps = std::stod(a[5]);
  Json rows = Json::array();
  std::vector<double> volumes, costs;
  for (int k = 1; k <= seeds; ++k) {
    const Outcome o =
        run_once(target, static_cast<std::uint64_t>(k), evaluations, steps, a[6] == "estimated");
    volumes.push_back(o.hypervolume);
    costs.push_back(o.particle_steps);
    rows.push_back({{"seed", k},
                    {"particle_steps", o.particle_steps},
                    {"hypervolume", o.hypervolume},
                    {"runs", o.runs},
                    {"front", o.front}});
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
  if (argc != 9) {
    fmt::print(stderr,
               "usage: bench_search_targets LIST.json PROBLEM SPACINGS SEEDS EVALUATIONS "
               "PARTICLE_STEPS observed|estimated OUT.json\n");
    return 2;
  }
  try {
    parapet::bench::search::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_targets: {}\n", error.what());
    return 1;
  }
}
