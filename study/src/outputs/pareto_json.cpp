#include <cmath>

#include "parapet/records/hashes.hpp"
#include "parapet/study/event_model.hpp"
#include "parapet/study/front.hpp"
#include "parapet/study/goal_quantity.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

using designs::Json;
using records::EvaluationRecord;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// The search's view of a record; null when it has none.
const bayesian::Assessed* find_assessed(const designs::StudySpec& study,
                                        const SearchProblem& problem,
                                        const std::vector<bayesian::Assessed>& assessed,
                                        const EvaluationRecord& record) {
  for (const bayesian::Assessed& one : assessed) {
    const auto level = static_cast<std::size_t>(one.level);
    if (problem.spacings[level] != record.spacing) continue;
    if (to_design(study, problem.problem.space, one.x) == record.design) return &one;
  }
  return nullptr;
}

void add_estimate(Json& json, const bayesian::Assessed* assessed, std::size_t metric) {
  const bool known = assessed != nullptr && metric < assessed->estimate.size();
  json["estimate"] = known ? finite(assessed->estimate[metric]) : Json(nullptr);
  json["lower_95"] = known ? finite(assessed->lower[metric]) : Json(nullptr);
  json["upper_95"] = known ? finite(assessed->upper[metric]) : Json(nullptr);
}

/// The statistic over the distribution of events in the place of an estimate over the simulated
/// events.
void add_statistic(Json& json, const EventModel* events, const Quantity& quantity,
                   const designs::Design& design) {
  if (events == nullptr || events->empty()) return;
  const auto found = events->statistic(quantity, design);
  if (!found) return;
  json["estimate"] = found->value;
  json["lower_95"] = found->lower_95;
  json["upper_95"] = found->upper_95;
  json["over_events"] = designs::n_event_draws;
}

/// How well the surrogates of design and event predict events that they have not seen.
Json events_json(const designs::StudySpec& study, const EventModel& events) {
  Json json{{"simulated", study.scenarios.size()},
            {"drawn", designs::n_event_draws},
            {"designs", events.n_designs()},
            {"variables", Json::array()},
            {"leave_one_event_out", Json::array()}};
  for (const designs::EventVariable& variable : study.event_variables) {
    json["variables"].push_back(variable.name);
  }
  for (const auto& [key, process] : events.processes()) {
    const LeaveOneEventOut error = events.leave_one_event_out(key);
    json["leave_one_event_out"].push_back({{"metric", key.first},
                                           {"value_when_absent", optional_json(key.second)},
                                           {"rmse", finite(error.rmse)},
                                           {"q_squared", finite(error.q_squared)},
                                           {"coverage_95", finite(error.coverage_95)}});
  }
  return json;
}

Json objectives_json(const designs::StudySpec& study, const EvaluationRecord& record,
                     const SearchProblem* problem, const bayesian::Assessed* assessed,
                     const EventModel* events) {
  Json list = Json::array();
  for (std::size_t j = 0; j < record.objectives.size(); ++j) {
    Json one;
    one["name"] = record.objectives[j].metric;
    one["value"] = optional_json(record.objectives[j].value);
    one["absent"] = record.objectives[j].absent;
    add_estimate(one, assessed, problem == nullptr ? 0 : problem->problem.objectives[j].metric);
    if (j < study.objectives.size() && !study.objectives[j].is_of_design()) {
      add_statistic(one, events, objective_quantity(study, study.objectives[j]), record.design);
    }
    list.push_back(std::move(one));
  }
  return list;
}

/// A constraint's limits, each with what the surrogate of its quantity says; formulas have none.
Json constraints_json(const designs::StudySpec& study, const EvaluationRecord& record,
                      const SearchProblem* problem, const bayesian::Assessed* assessed,
                      const EventModel* events) {
  Json list = Json::array();
  std::size_t limit = 0;
  for (std::size_t k = 0; k < record.constraints.size() && k < study.constraints.size(); ++k) {
    const records::ConstraintRecord& constraint = record.constraints[k];
    Json one;
    one["name"] = constraint.name;
    one["value"] = optional_json(constraint.value);
    one["lower"] = optional_json(constraint.lower);
    one["upper"] = optional_json(constraint.upper);
    one["margin"] = optional_json(constraint.margin);
    one["satisfied"] = constraint.satisfied;
    one["estimates"] = Json::array();
    if (!study.constraints[k].is_of_design() && problem != nullptr) {
      for (const QuantityLimit& limited : constraint_quantities(study, study.constraints[k])) {
        const std::size_t metric = problem->problem.limits[limit++].metric;
        Json estimate;
        estimate["quantity"] = problem->problem.metrics[metric].name;
        add_estimate(estimate, assessed, metric);
        add_statistic(estimate, events, limited.quantity, record.design);
        one["estimates"].push_back(std::move(estimate));
      }
    }
    list.push_back(std::move(one));
  }
  return list;
}

Json design_json(const designs::StudySpec& study, const EvaluationRecord& record,
                 const SearchProblem* problem, const bayesian::Assessed* assessed,
                 const EventModel* events) {
  Json json;
  json["id"] = record.id;
  json["design"] = record.design;
  if (!record.options.empty()) json["options"] = record.options;
  json["spacing_m"] = record.spacing;
  json["objectives"] = objectives_json(study, record, problem, assessed, events);
  json["constraints"] = constraints_json(study, record, problem, assessed, events);
  json["probability_feasible"] =
      assessed == nullptr ? Json(nullptr) : finite(assessed->probability_feasible);
  return json;
}

/// The front as the surrogates see it: designs known at any spacing, with the uncertainty that is
/// left of their values at the finest one.
Json estimated_json(const designs::StudySpec& study, const SearchProblem& problem,
                    const bayesian::Search& search,
                    const std::vector<bayesian::Assessed>& assessed) {
  Json list = Json::array();
  for (const std::size_t k : search.estimated_front()) {
    const bayesian::Assessed& one = assessed[k];
    Json json;
    json["design"] = to_design(study, problem.problem.space, one.x);
    json["spacing_m"] = problem.spacings[static_cast<std::size_t>(one.level)];
    json["objectives"] = Json::array();
    for (std::size_t j = 0; j < study.objectives.size(); ++j) {
      Json objective;
      objective["name"] = objective_name(study.objectives[j]);
      add_estimate(objective, &one, problem.problem.objectives[j].metric);
      json["objectives"].push_back(std::move(objective));
    }
    json["probability_feasible"] = finite(one.probability_feasible);
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

Json pareto_json(const designs::StudySpec& study, const Front& front, const SearchProblem* problem,
                 const bayesian::Search* search, const EventModel* events) {
  Json json;
  json["format"] = "parapet-pareto/1";
  json["name"] = study.name;
  json["spec_hash"] = records::study_hash(study);
  json["objectives"] = Json::array();
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    const designs::Objective& objective = study.objectives[j];
    json["objectives"].push_back(
        {{"name", objective_name(objective)},
         {"goal", objective.goal == designs::Goal::maximize ? "maximize" : "minimize"},
         {"reference", front.reference.empty() ? Json(nullptr) : Json(front.reference[j])}});
  }
  const auto assessed = search == nullptr ? std::vector<bayesian::Assessed>{} : search->assessed();
  json["designs"] = Json::array();
  for (const EvaluationRecord& record : front.designs) {
    const bayesian::Assessed* view =
        problem == nullptr ? nullptr : find_assessed(study, *problem, assessed, record);
    json["designs"].push_back(design_json(study, record, problem, view, events));
  }
  if (problem != nullptr && search != nullptr) {
    json["estimated"] = estimated_json(study, *problem, *search, assessed);
  }
  if (events != nullptr && !events->empty()) json["events"] = events_json(study, *events);
  json["hypervolume"] = front.hypervolume;
  json["history"] = Json::array();
  for (const FrontEntry& entry : front.history) {
    json["history"].push_back({{"evaluations", entry.evaluations},
                               {"cpu_time_s", entry.cpu_time},
                               {"hypervolume", entry.hypervolume}});
  }
  return json;
}

}  // namespace parapet::study
