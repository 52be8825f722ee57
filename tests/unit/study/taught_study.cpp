#include "taught_study.hpp"

#include <algorithm>

#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/front.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/study_surrogates.hpp"

namespace parapet::test {
namespace {

designs::StudySpec spec_of(const std::vector<double>& spacings, double launch_limit,
                           double retention_noise, double launch_noise) {
  designs::Json json = designs::Json::parse(R"({
    "format": "parapet-study/1",
    "name": "taught",
    "case": {
      "channel": {"length_m": 1.2},
      "reservoir": {"length_m": 0.2, "height_m": 0.1},
      "barriers": [{"foot_x_m": 0.4, "height_m": 0.06,
                    "deflector": {"angle_deg": 30, "length_m": 0.04}}],
      "run": {"stop_time_s": 0.5}
    },
    "variables": {
      "height_m": {"lower": 0.04, "upper": 0.1, "targets": ["/barriers/0/height_m"]},
      "angle_deg": {"lower": 0, "upper": 60, "targets": ["/barriers/0/deflector/angle_deg"]}
    },
    "objectives": [{"metric": "retention_efficiency", "goal": "maximize"}],
    "constraints": [{"metric": "launch_length_m"}],
    "method": {"algorithm": "BAYESIAN", "max_evaluations": 40, "seed": 1}})");
  json["constraints"][0]["upper"] = launch_limit;
  json["fidelity"]["spacings_m"] = spacings;
  if (retention_noise >= 0.0) {
    json["fidelity"]["noise"] = {
        {"retention_efficiency", std::vector<double>(spacings.size(), retention_noise)},
        {"launch_length_m", std::vector<double>(spacings.size(), launch_noise)}};
  }
  return designs::parse_study(json, "test");
}

}  // namespace

TaughtStudy::TaughtStudy(const std::vector<double>& spacings, double launch_limit,
                         double retention_noise, double launch_noise)
    : study{.folder = "taught",
            .spec = spec_of(spacings, launch_limit, retention_noise, launch_noise),
            .spec_hash = "0123456789abcdef",
            .provenance = {{"program_version", "9.9.9"}},
            .state = "done",
            .designs = {}} {}

records::EvaluationRecord TaughtStudy::record(const std::string& id, double height, double angle,
                                              double spacing, double retention,
                                              double launch) const {
  records::EvaluationRecord one;
  one.id = id;
  one.stage = "search";
  one.design = {{"height_m", height}, {"angle_deg", angle}};
  one.ok = true;
  one.spacing = spacing;
  one.metrics = {{"retention_efficiency", retention, ""},
                 {"launch_length_m", launch, ""},
                 {"barrier_1_design_force_n_per_m", 1000.0 * retention, ""},
                 {"barrier_1_design_moment_nm_per_m", 50.0 * retention, ""}};
  const study::Score score = study::score(study.spec, one.design, one.metrics);
  one.objectives = score.objectives;
  one.objective_scalar = score.objective_scalar;
  one.constraints = score.constraints;
  one.feasible = score.feasible;
  return one;
}

std::string TaughtStudy::add(double height, double angle, double spacing, double retention,
                             double launch) {
  const std::string id = records::evaluation_id(static_cast<int>(study.designs.size()) + 1);
  study.designs.push_back(record(id, height, angle, spacing, retention, launch));
  return id;
}

void TaughtStudy::confirm(const std::string& id, const std::string& role, const std::string& stage,
                          double spacing, double retention, double launch) {
  const auto design = std::ranges::find(study.designs, id, &records::EvaluationRecord::id);
  records::EvaluationRecord one =
      record(id + "-" + role, design->design.at("height_m"), design->design.at("angle_deg"),
             spacing, retention, launch);
  one.stage = stage;
  study.confirmations.push_back(std::move(one));
}

designs::Json TaughtStudy::teach() {
  const study::SearchProblem problem = study::make_search_problem(study.spec);
  bayesian::Search search(problem.problem, study::make_search_options(study.spec));
  for (const records::EvaluationRecord& one : study.designs) {
    search.tell_external(study::to_point(study.spec, one.design),
                         study::level_of(problem, one.spacing).value(),
                         study::observation(study.spec, problem, one));
  }
  designs::Json json = study::surrogates_json(study.spec, problem, search);
  study.surrogates = study::StudySurrogates::of(study.spec, json, study.designs);
  return json;
}

}  // namespace parapet::test
