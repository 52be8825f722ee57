#include <fmt/format.h>

#include <algorithm>

#include "parapet/records/hashes.hpp"
#include "parapet/study/front.hpp"

namespace parapet::study {
namespace {

using designs::Json;

Json vector_json(const Eigen::VectorXd& values) {
  return std::vector<double>(values.begin(), values.end());
}

Json rows_json(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back(vector_json(matrix.row(i).transpose()));
  }
  return rows;
}

std::string kind_name(bayesian::VariableKind kind) {
  switch (kind) {
    case bayesian::VariableKind::continuous:
      return "continuous";
    case bayesian::VariableKind::integer:
      return "integer";
    case bayesian::VariableKind::choice:
      return "choice";
  }
  return "unknown";
}

std::string transform_name(surrogate::TransformKind kind) {
  switch (kind) {
    case surrogate::TransformKind::automatic:
      return "automatic";
    case surrogate::TransformKind::identity:
      return "identity";
    case surrogate::TransformKind::log:
      return "log";
    case surrogate::TransformKind::bilog:
      return "bilog";
  }
  return "unknown";
}

std::string statistic_name(designs::Statistic statistic) {
  switch (statistic) {
    case designs::Statistic::mean:
      return "mean";
    case designs::Statistic::worst:
      return "worst";
    case designs::Statistic::quantile:
      return "quantile";
    case designs::Statistic::probability:
      return "probability";
  }
  return "unknown";
}

Json space_json(const designs::StudySpec& study, const bayesian::Space& space) {
  Json list = Json::array();
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bayesian::Variable& variable = space.variables()[i];
    Json one;
    one["name"] = variable.name;
    one["kind"] = kind_name(variable.kind);
    one["lower"] = variable.lower;
    one["upper"] = variable.upper;
    if (variable.kind == bayesian::VariableKind::choice) {
      one["options"] = Json::array();
      for (const designs::Option& option : study.variables[i].options) {
        one["options"].push_back(option.name);
      }
    }
    if (variable.active_when) {
      one["active_when"] = {{"choice", space.variables()[variable.active_when->choice].name},
                            {"options", variable.active_when->options}};
    }
    list.push_back(std::move(one));
  }
  return list;
}

Json level_json(const surrogate::LevelParameters& level, double spacing) {
  return {{"spacing_m", spacing},         {"length_scales", vector_json(level.length_scales)},
          {"amplitude", level.amplitude}, {"noise", level.noise},
          {"mean", level.mean},           {"coupling", level.coupling}};
}

/// Values that the metric can have: a normal distribution knows no ends.
Json possible_json(const Eigen::VectorXd& values, const bayesian::Metric& metric) {
  return vector_json(values.cwiseMax(metric.least).cwiseMin(metric.greatest));
}

Json process_json(const surrogate::GaussianProcess& process, const SearchProblem& problem,
                  const bayesian::Metric& metric) {
  const surrogate::Parameters& parameters = process.parameters();
  Json json;
  json["transform"] = {{"kind", transform_name(parameters.transform.kind)},
                       {"unit", parameters.transform.unit},
                       {"shift", parameters.transform.shift},
                       {"scale", parameters.transform.scale}};
  json["levels"] = Json::array();
  for (std::size_t k = 0; k < parameters.levels.size(); ++k) {
    json["levels"].push_back(level_json(parameters.levels[k], problem.spacings[k]));
  }
  json["log_likelihood"] = process.log_likelihood();
  json["data"] = {{"inputs", rows_json(process.data().inputs)},
                  {"values", vector_json(process.data().values)},
                  {"levels", process.data().levels}};
  const surrogate::LeaveOneOut left_out = process.leave_one_out();
  json["leave_one_out"] = {{"mean", possible_json(left_out.mean, metric)},
                           {"lower_95", possible_json(left_out.lower, metric)},
                           {"upper_95", possible_json(left_out.upper, metric)},
                           {"residual", vector_json(left_out.residual)},
                           {"q_squared", left_out.q_squared},
                           {"coverage_95", left_out.coverage_95}};
  return json;
}

Json metric_json(const SearchProblem& problem, std::size_t metric,
                 const surrogate::GaussianProcess* process) {
  const SearchMetric& what = problem.metrics[metric];
  Json json;
  json["name"] = problem.problem.metrics[metric].name;
  if (!what.expression.empty()) {
    json["expression"] = what.expression;
    return json;
  }
  if (problem.problem.metrics[metric].is_composed()) {
    json["expression"] = what.quantity.expression;
    json["inputs"] = Json::array();
    for (const std::size_t input : problem.problem.metrics[metric].composition.inputs) {
      json["inputs"].push_back(problem.problem.metrics[input].name);
    }
    return json;
  }
  json["metric"] = what.quantity.metric;
  if (!what.quantity.expression.empty()) json["expression"] = what.quantity.expression;
  if (!what.quantity.event.empty()) json["event"] = what.quantity.event;
  json["statistic"] = statistic_name(what.quantity.statistic);
  json["quantile"] = what.quantity.quantile;
  json["high_is_good"] = what.quantity.high_is_good;
  json["surrogate"] = process == nullptr
                          ? Json(nullptr)
                          : process_json(*process, problem, problem.problem.metrics[metric]);
  return json;
}

/// Whether a goal of the study hangs on a metric.
bool matters(const bayesian::Problem& problem, std::size_t metric) {
  const auto of = [&](const auto& goal) {
    const auto& inputs = problem.metrics[goal.metric].composition.inputs;
    return goal.metric == metric || std::find(inputs.begin(), inputs.end(), metric) != inputs.end();
  };
  return std::any_of(problem.objectives.begin(), problem.objectives.end(), of) ||
         std::any_of(problem.limits.begin(), problem.limits.end(), of);
}

std::vector<std::string> level_warnings(const SearchProblem& problem,
                                        const bayesian::Search& search) {
  constexpr double least_correlation = 0.7;  // half of the variance
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < problem.metrics.size(); ++k) {
    const surrogate::GaussianProcess* process = search.surrogate(k);
    if (process == nullptr || !matters(problem.problem, k)) continue;
    for (std::size_t level = 1; level < problem.spacings.size(); ++level) {
      const double correlation = process->level_correlation(static_cast<int>(level));
      if (correlation >= least_correlation) continue;
      sentences.push_back(fmt::format(
          "runs at {:g} mm tell little about {} at {:g} mm (correlation {:.2f}): what is known of "
          "it rests on the runs at {:g} mm",
          1000.0 * problem.spacings[level], problem.problem.metrics[k].name,
          1000.0 * problem.spacings.front(), correlation, 1000.0 * problem.spacings.front()));
    }
  }
  return sentences;
}

}  // namespace

Json surrogates_json(const designs::StudySpec& study, const SearchProblem& problem,
                     const bayesian::Search& search) {
  const bayesian::Space& space = problem.problem.space;
  const surrogate::Layout layout = space.layout(static_cast<int>(problem.spacings.size()));
  Json json;
  json["format"] = "parapet-surrogates/1";
  json["name"] = study.name;
  json["spec_hash"] = records::study_hash(study);
  json["space"] = space_json(study, space);
  json["layout"] = {{"group", layout.group}, {"n_levels", layout.n_levels}};
  json["spacings_m"] = problem.spacings;
  json["metrics"] = Json::array();
  for (std::size_t k = 0; k < problem.metrics.size(); ++k) {
    json["metrics"].push_back(metric_json(problem, k, search.surrogate(k)));
  }
  json["evaluations"] = Json::array();
  for (const bayesian::Assessed& one : search.assessed()) {
    json["evaluations"].push_back({{"design", to_design(study, space, one.x)},
                                   {"level", one.level},
                                   {"ok", one.ok},
                                   {"feasible", one.feasible}});
  }
  return json;
}

std::vector<std::string> surrogate_warnings(const SearchProblem& problem,
                                            const bayesian::Search& search) {
  constexpr int enough_designs = 15;
  constexpr double least_q_squared = 0.3;
  std::vector<std::string> sentences;
  if (search.evaluations() < enough_designs) return sentences;
  const auto& metrics = search.problem().metrics;
  for (std::size_t k = 0; k < metrics.size(); ++k) {
    const surrogate::GaussianProcess* process = search.surrogate(k);
    if (process == nullptr) continue;
    const double q_squared = process->leave_one_out().q_squared;
    if (q_squared >= least_q_squared) continue;
    sentences.push_back(
        fmt::format("the surrogate of {} fails the leave-one-out test (Q^2 {:.2f} after {} "
                    "designs): do not rely on its estimates",
                    metrics[k].name, q_squared, search.evaluations()));
  }
  for (const std::string& sentence : level_warnings(problem, search)) sentences.push_back(sentence);
  return sentences;
}

}  // namespace parapet::study
