#include "target_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "emulator.hpp"
#include "parapet/designs/study_spec.hpp"
#include "solver_runs.hpp"
#include "study_part.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t metric_index(const BenchProblem& problem, const std::string& name) {
  const auto found = std::find_if(problem.metrics.begin(), problem.metrics.end(),
                                  [&](const BenchMetric& m) { return m.name == name; });
  if (found == problem.metrics.end()) throw std::invalid_argument("there is no metric " + name);
  return static_cast<std::size_t>(found - problem.metrics.begin());
}

void add_objective(BenchProblem& problem, const Json& json) {
  BenchObjective objective;
  objective.maximize = json.at("goal") == "maximize";
  if (json.contains("value_when_absent")) objective.value_when_absent = json["value_when_absent"];
  if (json.contains("metric")) {
    objective.metric = metric_index(problem, json.at("metric"));
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

// What a metric counts as where it does not exist [n_metrics]; empty: nothing.
std::vector<std::optional<double>> values_when_absent(const BenchProblem& problem,
                                                      const Json& json) {
  std::vector<std::optional<double>> values(problem.metrics.size());
  for (const char* part : {"objectives", "limits"}) {
    for (const Json& one : json.at(part)) {
      if (!one.contains("value_when_absent")) continue;
      values[metric_index(problem, one.at("metric"))] = one.at("value_when_absent").get<double>();
    }
  }
  return values;
}

void answer_by_emulator(TargetProblem& target, const Json& json, const std::filesystem::path& file,
                        const std::vector<double>& spacings) {
  BenchProblem& problem = target.problem;
  std::vector<std::string> modelled;
  for (const BenchMetric& m : problem.metrics) {
    if (!m.exact) modelled.push_back(m.name);
  }
  const auto emulator =
      std::make_shared<Emulator>(file, problem.variables, problem.lower, problem.upper, modelled,
                                 json.at("overflow_metric"), spacings);
  fmt::print("  {}: {}\n", problem.name, emulator->summary());
  for (std::size_t level = 0; level < spacings.size(); ++level) {
    problem.level_seconds[level] = emulator->particle_steps(level);
  }
  const auto answer = [metrics = problem.metrics, absent = values_when_absent(problem, json),
                       emulator](const Design& x, std::size_t level, bool scatter) {
    Answer result{true, {}};
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      std::optional<double> value;
      if (metrics[m].exact) {
        value = metrics[m].exact(x);
      } else {
        value = scatter ? emulator->noisy(metrics[m].name, x, level)
                        : emulator->smooth(metrics[m].name, x, level);
      }
      result.values.push_back(value ? value : absent[m]);
    }
    return result;
  };
  problem.evaluate = [answer](const Design& x, int level) {
    return answer(x, static_cast<std::size_t>(level), true);
  };
  problem.truth = [answer](const Design& x) { return answer(x, 0, false); };
}

void answer_by_solver(TargetProblem& target, const Json& json, const std::filesystem::path& study,
                      const std::vector<double>& spacings, const AnswerSource& source) {
  BenchProblem& problem = target.problem;
  const auto runs =
      std::make_shared<SolverRuns>(source.program, study, source.store, problem.variables);
  const auto answer = [metrics = problem.metrics, absent = values_when_absent(problem, json), runs](
                          const Design& x, double spacing, int lattice) {
    const SolverRun& run = runs->run(x, spacing, lattice);
    Answer result{run.ok, {}, run.particle_steps};
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      const auto found = run.metrics.find(metrics[m].name);
      if (metrics[m].exact) {
        result.values.emplace_back(metrics[m].exact(x));
      } else if (found != run.metrics.end()) {
        result.values.emplace_back(found->second);
      } else {
        result.values.push_back(absent[m]);
        // a run that could not tell counts as failed, as in a study
        result.ok = result.ok && std::find(run.unknown.begin(), run.unknown.end(),
                                           metrics[m].name) == run.unknown.end();
      }
    }
    return result;
  };
  problem.evaluate = [answer, spacings](const Design& x, int level) {
    return answer(x, spacings[static_cast<std::size_t>(level)], 0);
  };
  problem.truth = [answer, finest = spacings.front(),
                   lattices = source.judging_lattices](const Design& x) {
    Answer mean = answer(x, finest, 1);
    for (int lattice = 2; lattice <= lattices; ++lattice) {
      const Answer one = answer(x, finest, lattice);
      mean.ok = mean.ok && one.ok;
      for (std::size_t m = 0; m < mean.values.size(); ++m) {
        if (!one.values[m] || !mean.values[m]) {
          mean.values[m].reset();
        } else {
          *mean.values[m] += (*one.values[m] - *mean.values[m]) / lattice;
        }
      }
    }
    return mean;
  };
}

}  // namespace

TargetProblem load_target(const std::filesystem::path& list, const std::string& name,
                          const std::vector<double>& spacings, const AnswerSource& source) {
  std::ifstream in(list);
  if (!in) throw std::invalid_argument("cannot read " + list.string());
  const Json problems = Json::parse(in).at("problems");
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const Json& one) { return one.at("name") == name; });
  if (found == problems.end()) throw std::invalid_argument("there is no problem " + name);
  const Json& json = *found;
  const std::filesystem::path study_file =
      list.parent_path() / (json.at("study").get<std::string>() + ".json");
  const StudyPart study = read_study_part(study_file);
  TargetProblem target;
  BenchProblem& problem = target.problem;
  problem.name = name;
  problem.variables = study.variables;
  problem.lower = study.lower;
  problem.upper = study.upper;
  problem.cheap_constraints = cheap_constraints(study.variables, study.limits);
  // retention first, a share; then the launch length
  for (const auto& metric : json.at("metrics").get<std::vector<std::string>>()) {
    problem.metrics.push_back({metric, nullptr, 0.0, problem.metrics.empty() ? 1.0 : infinity});
  }
  // Particles times steps; the search learns the costs as they are.
  constexpr double nominal_steps = 1.5e7, nominal_spacing = 0.005;
  problem.level_seconds.clear();
  for (const double spacing : spacings) {
    const double finer = nominal_spacing / spacing;
    problem.level_seconds.push_back(nominal_steps * finer * finer * finer);
  }
  for (const Json& objective : json.at("objectives")) add_objective(problem, objective);
  for (const Json& limit : json.at("limits")) {
    problem.limits.push_back({metric_index(problem, limit.at("metric")), -infinity,
                              limit.at("upper"), limit.at("upper")});
  }
  if (source.program.empty()) {
    answer_by_emulator(
        target, json,
        list.parent_path().parent_path() / "tables" / json.at("runs").get<std::string>(), spacings);
  } else {
    answer_by_solver(target, json, study_file, spacings, source);
  }
  const auto reference = json.at("reference").get<std::vector<double>>();
  target.reference.resize(static_cast<Eigen::Index>(reference.size()));
  for (std::size_t j = 0; j < reference.size(); ++j) {
    const bool maximize = problem.objectives[j].maximize;
    target.reference[static_cast<Eigen::Index>(j)] = maximize ? -reference[j] : reference[j];
  }
  return target;
}

}  // namespace parapet::bench::search
