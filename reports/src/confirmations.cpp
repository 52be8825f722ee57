#include "confirmations.hpp"

#include <algorithm>
#include <cmath>

#include "recommendation_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::vector<study::ConfirmationRun> runs_of(const StudyLog& log) {
  std::vector<study::ConfirmationRun> runs;
  for (const LoggedDesign& line : log.confirmations) {
    runs.push_back({line.id, line.stage, line.ok && line.feasible});
  }
  return runs;
}

const char* word(study::Verdict verdict) {
  if (verdict == study::Verdict::none) return "none";
  return verdict == study::Verdict::confirmed ? "confirmed" : "refuted";
}

Json run_json(const LoggedDesign& run) {
  Json json{{"id", run.id},
            {"stage", run.stage},
            {"spacing_m", optional_json(run.spacing)},
            {"ok", run.ok},
            {"reason", run.reason},
            {"feasible", run.feasible},
            {"objectives", Json::array()},
            {"violated", Json::array()}};
  for (const LoggedObjective& objective : run.objectives) {
    json["objectives"].push_back(optional_json(objective.value));
  }
  for (const LoggedConstraint& constraint : run.constraints) {
    if (!constraint.satisfied) json["violated"].push_back(constraint.name);
  }
  return json;
}

/// How far the answer moves between the design and those near to it, at one spacing: for each
/// objective, and for each constraint with a value.
Json spread_json(const std::string& name, const std::string& of, std::vector<double> values) {
  Json json{{"name", name}, {"metric", of}, {"runs", values.size()}};
  const auto [least, greatest] = std::ranges::minmax(values);
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  json["least"] = least;
  json["greatest"] = greatest;
  json["standard_deviation"] = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return json;
}

Json spreads_json(const LoggedDesign& pick, const std::vector<const LoggedDesign*>& near) {
  Json list = Json::array();
  const auto add = [&](const std::string& name, const std::string& of, auto value_in) {
    std::vector<double> values;
    if (const auto own = value_in(pick)) values.push_back(*own);
    for (const LoggedDesign* run : near) {
      if (const auto value = value_in(*run)) values.push_back(*value);
    }
    if (values.size() > 1) list.push_back(spread_json(name, of, std::move(values)));
  };
  for (std::size_t j = 0; j < pick.objectives.size(); ++j) {
    if (!pick.objectives[j].on_metric) continue;
    add(pick.objectives[j].metric, pick.objectives[j].of, [j](const LoggedDesign& design) {
      return j < design.objectives.size() ? design.objectives[j].value : std::nullopt;
    });
  }
  for (std::size_t k = 0; k < pick.constraints.size(); ++k) {
    const LoggedConstraint& constraint = pick.constraints[k];
    const auto same = [&](const LoggedObjective& objective) {
      return objective.of == constraint.of && objective.statistic == constraint.statistic;
    };
    if (!constraint.on_metric || std::ranges::any_of(pick.objectives, same)) continue;
    add(constraint.name, constraint.of, [k](const LoggedDesign& design) {
      return k < design.constraints.size() ? design.constraints[k].value : std::nullopt;
    });
  }
  return list;
}

}  // namespace

Confirmed confirmed_pick(const StudyLog& log, const Choice& choice) {
  Confirmed result;
  const std::vector<study::ConfirmationRun> runs = runs_of(log);
  const auto tried =
      std::min(choice.ranked.size(), static_cast<std::size_t>(study::most_confirmed_designs));
  for (std::size_t k = 0; k < tried; ++k) {
    const Candidate& candidate = choice.ranked[k];
    const study::Verdict verdict = study::verdict_of(candidate.design->id, runs);
    if (verdict == study::Verdict::refuted) {
      result.refuted.push_back(&candidate);
      continue;
    }
    result.pick = &candidate;
    result.verdict = verdict;
    return result;
  }
  if (!choice.ranked.empty()) {
    result.pick = &choice.ranked.front();
    result.verdict = study::Verdict::refuted;
  }
  return result;
}

Json confirmation_json(const StudyLog& log, const Confirmed& confirmed) {
  if (confirmed.pick == nullptr) return nullptr;
  const LoggedDesign& pick = *confirmed.pick->design;
  Json json{{"verdict", word(confirmed.verdict)},
            {"runs", Json::array()},
            {"spread", Json::array()},
            {"refuted", Json::array()}};
  std::vector<const LoggedDesign*> runs, near;
  for (const LoggedDesign& run : log.confirmations) {
    if (study::confirms(run.id, pick.id)) runs.push_back(&run);
  }
  std::ranges::sort(runs, {}, &LoggedDesign::id);  // the file has the order in which they ended
  for (const LoggedDesign* run : runs) {
    json["runs"].push_back(run_json(*run));
    if (run->stage == study::confirmation_stage::near && run->ok) near.push_back(run);
  }
  json["spread"] = spreads_json(pick, near);
  for (const Candidate* candidate : confirmed.refuted) {
    Json violated = Json::array();
    for (const LoggedDesign& run : log.confirmations) {
      if (!study::confirms(run.id, candidate->design->id)) continue;
      for (const LoggedConstraint& constraint : run.constraints) {
        if (!constraint.satisfied &&
            std::ranges::find(violated, Json(constraint.name)) == violated.end()) {
          violated.push_back(constraint.name);
        }
      }
    }
    json["refuted"].push_back({{"id", candidate->design->id}, {"violated", violated}});
  }
  return json;
}

}  // namespace parapet::reports
