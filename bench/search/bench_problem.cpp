#include "bench_problem.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "oracle.hpp"
#include "parapet/designs/study_spec.hpp"
#include "study_part.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

constexpr double feasibility_tolerance = 1e-9;  // as of the optimizer's options

Json read_list(const std::filesystem::path& list) {
  std::ifstream in(list);
  if (!in) throw std::invalid_argument("cannot read " + list.string());
  Json json = Json::parse(in);
  if (json.value("format", "") != "parapet-search-comparison/1") {
    throw std::invalid_argument(list.string() + " is not of the format " +
                                "parapet-search-comparison/1");
  }
  return json.at("problems");
}

const Json& find_problem(const Json& problems, const std::string& name) {
  for (const Json& problem : problems) {
    if (problem.at("name") == name) return problem;
  }
  throw std::invalid_argument("there is no problem " + name);
}

designs::Design named(const std::vector<std::string>& variables, const Design& x) {
  designs::Design design;
  for (std::size_t j = 0; j < x.size(); ++j) design[variables[j]] = x[j];
  return design;
}

// The tables of all levels, shared by the copies of the problem.
using Oracles = std::shared_ptr<const std::vector<Oracle>>;

std::size_t metric_index(BenchProblem& problem, const Oracles& oracles, const std::string& name) {
  for (std::size_t m = 0; m < problem.metrics.size(); ++m) {
    if (problem.metrics[m].name == name) return m;
  }
  for (const Oracle& oracle : *oracles) {
    if (!oracle.metrics.contains(name)) {
      throw std::invalid_argument("the table " + oracle.name + " has no metric " + name);
    }
  }
  const MetricSurface& surface = oracles->front().metrics.at(name);
  problem.metrics.push_back({name, nullptr, surface.least, surface.greatest});
  return problem.metrics.size() - 1;
}

void add_objective(BenchProblem& problem, const Oracles& oracles, const Json& json) {
  BenchObjective objective;
  objective.maximize = json.at("goal") == "maximize";
  if (json.contains("value_when_absent")) objective.value_when_absent = json["value_when_absent"];
  if (json.contains("metric")) {
    objective.metric = metric_index(problem, oracles, json.at("metric"));
  } else {
    const std::string expression = json.at("expression");
    const std::vector<std::string> variables = problem.variables;
    objective.metric = problem.metrics.size();
    problem.metrics.push_back({json.at("name"), [expression, variables](const Design& x) {
                                 return designs::evaluate_expression(expression,
                                                                     named(variables, x));
                               }});
  }
  problem.objectives.push_back(objective);
}

void add_evaluators(BenchProblem& problem, const Oracles& oracles) {
  const auto answer = [metrics = problem.metrics, oracles](const Design& x, std::size_t level,
                                                           bool noise) {
    const Oracle& oracle = oracles->at(level);
    Answer result{oracle.succeeds(x), {}};
    if (!result.ok) return result;
    for (const BenchMetric& m : metrics) {
      if (m.exact) {
        result.values.emplace_back(m.exact(x));
      } else {
        result.values.push_back(noise ? oracle.noisy(m.name, x) : oracle.smooth(m.name, x));
      }
    }
    return result;
  };
  problem.evaluate = [answer](const Design& x, int level) {
    return answer(x, static_cast<std::size_t>(level), true);
  };
  problem.truth = [answer](const Design& x) { return answer(x, 0, false); };
}

}  // namespace

bool BenchProblem::allows(const Design& x) const {
  if (!cheap_constraints) return true;
  const std::vector<double> c = cheap_constraints(x);
  return std::all_of(c.begin(), c.end(), [](double v) { return v <= feasibility_tolerance; });
}

Design BenchProblem::from_unit(const std::vector<double>& u) const {
  Design x(u.size());
  for (std::size_t j = 0; j < u.size(); ++j) x[j] = lower[j] + (upper[j] - lower[j]) * u[j];
  return x;
}

double Verdict::total_violation() const {
  double sum = 0.0;
  for (const double v : violations) sum += std::max(0.0, v);
  return sum;
}

Verdict judge(const BenchProblem& problem, const Answer& answer) {
  Verdict verdict;
  verdict.ok = answer.ok;
  if (!answer.ok) return verdict;
  verdict.objectives.resize(static_cast<Eigen::Index>(problem.objectives.size()));
  for (std::size_t k = 0; k < problem.objectives.size(); ++k) {
    const BenchObjective& objective = problem.objectives[k];
    std::optional<double> value = answer.values[objective.metric];
    if (!value) value = objective.value_when_absent;
    if (!value) return {};  // an objective without a value: the evaluation tells nothing
    verdict.objectives[static_cast<Eigen::Index>(k)] = objective.maximize ? -*value : *value;
  }
  for (const BenchLimit& limit : problem.limits) {
    const std::optional<double>& value = answer.values[limit.metric];
    verdict.violations.push_back(
        value ? std::max(*value - limit.upper, limit.lower - *value) / limit.scale : -1.0);
  }
  verdict.feasible = verdict.total_violation() <= feasibility_tolerance;
  return verdict;
}

BenchProblem load_problem(const std::filesystem::path& list, const std::filesystem::path& tables,
                          const std::string& name) {
  const Json problems = read_list(list);
  const Json& json = find_problem(problems, name);
  BenchProblem problem;
  problem.name = name;
  problem.title = json.at("title");
  const auto levels = json.at("levels").get<std::vector<std::string>>();
  const StudyPart study = read_study_part(list.parent_path() / (levels.front() + ".json"));
  problem.variables = study.variables;
  problem.lower = study.lower;
  problem.upper = study.upper;
  problem.cheap_constraints = cheap_constraints(
      problem.variables, json.contains("expression_limits")
                             ? read_expression_limits(json.at("expression_limits"))
                             : study.limits);
  const auto oracles = std::make_shared<std::vector<Oracle>>();
  problem.level_seconds.clear();
  for (const std::string& level : levels) {
    oracles->push_back(read_oracle(tables / (level + ".json")));
    const Oracle& oracle = oracles->back();
    if (oracle.variables != problem.variables || oracle.lower != problem.lower ||
        oracle.upper != problem.upper) {
      throw std::invalid_argument("the table " + level + " has other variables than its study");
    }
    problem.level_seconds.push_back(oracle.median_cpu_time);
  }
  for (const Json& objective : json.at("objectives")) add_objective(problem, oracles, objective);
  for (const Json& limit : json.at("limits")) {
    BenchLimit l;
    l.metric = metric_index(problem, oracles, limit.at("metric"));
    l.lower = limit.value("lower", l.lower);
    l.upper = limit.value("upper", l.upper);
    l.scale = limit.value("scale", 1.0);
    problem.limits.push_back(l);
  }
  add_evaluators(problem, oracles);
  problem.evaluations = json.at("evaluations");
  problem.peer_evaluations = json.at("peer_evaluations");
  return problem;
}

std::vector<std::string> problem_names(const std::filesystem::path& list) {
  std::vector<std::string> names;
  for (const Json& problem : read_list(list)) names.push_back(problem.at("name"));
  return names;
}

std::vector<std::string> level_names(const std::filesystem::path& list, const std::string& name) {
  const Json problems = read_list(list);
  return find_problem(problems, name).at("levels").get<std::vector<std::string>>();
}

}  // namespace parapet::bench::search
