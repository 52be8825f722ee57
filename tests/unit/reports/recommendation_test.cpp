#include "parapet/reports/recommendation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "parapet/reports/recommendation_json.hpp"
#include "parapet/reports/recommendation_text.hpp"

namespace parapet::reports {
namespace {

designs::StudySpec spec() {
  return designs::parse_study(designs::Json::parse(R"({
    "format": "parapet-study/1",
    "name": "hand-made",
    "case": {
      "channel": {"length_m": 1.2},
      "reservoir": {"length_m": 0.2, "height_m": 0.1},
      "barriers": [{"foot_x_m": 0.4, "height_m": 0.15,
                    "deflector": {"angle_deg": 30, "length_m": 0.04}}],
      "numerics": {"spacing_m": 0.01},
      "run": {"stop_time_s": 0.5}
    },
    "variables": {
      "deflector_angle_deg": {"lower": 0, "upper": 60},
      "barrier_1_height_m": {"lower": 0.1, "upper": 0.2, "targets": ["/barriers/0/height_m"]}},
    "objectives": [{"metric": "retention_efficiency", "goal": "maximize"}],
    "constraints": [{"name": "reach", "metric": "launch_length_m", "upper": 0.3}]})"),
                              "test");
}

/// Retention is to be maximised with a launch length of at most 0.3 m.
class Study : public testing::Test {
 protected:
  Study()
      : study_{.folder = "hand-made",
               .spec = spec(),
               .spec_hash = "0123456789abcdef",
               .provenance = {{"program_version", "9.9.9"}},
               .state = "done",
               .designs = {}} {}

  records::EvaluationRecord& append(double angle, double height) {
    records::EvaluationRecord record;
    record.id = records::evaluation_id(static_cast<int>(study_.designs.size()) + 1);
    record.stage = "search";
    record.design = {{"deflector_angle_deg", angle}, {"barrier_1_height_m", height}};
    record.spacing = 0.01;
    study_.designs.push_back(std::move(record));
    return study_.designs.back();
  }

  void add(double angle, double height, double retention, std::optional<double> launch,
           const std::string& stage = "search") {
    records::EvaluationRecord& record = append(angle, height);
    record.stage = stage;
    record.ok = true;
    record.metrics = {{"retention_efficiency", retention, ""},
                      {"launch_length_m", launch, launch ? "" : "nothing overflowed"}};
    record.objectives = {{"retention_efficiency", designs::Goal::maximize, 1.0, retention, false}};
    record.objective_scalar = -retention;
    records::ConstraintRecord reach{"reach", launch, std::nullopt, 0.3, !launch || *launch <= 0.3,
                                    {}};
    if (launch) reach.margin = 0.3 - *launch;
    record.constraints = {reach};
    record.feasible = reach.satisfied;
  }

  void add_failed(const std::string& reason) { append(1.0, 0.11).reason = reason; }

  static bool says(const Recommendation& result, const std::string& words) {
    return recommendation_text(result).find(words) != std::string::npos;
  }

  study::LoadedStudy study_;
};

TEST_F(Study, PicksTheBestFeasibleDesignNotTheBestInfeasibleOne) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(30.0, 0.2, 0.95, 0.4);  // better, but lands too far away
  add(45.0, 0.15, 0.8, 0.2);
  add(50.0, 0.12, 0.7, 0.28);
  const Recommendation result = recommend(study_);
  ASSERT_TRUE(result.recommended.has_value());
  EXPECT_EQ(result.recommended->design.id, "0003");
  EXPECT_EQ(std::get<double>(result.recommended->design.design[0].value), 45.0);
  EXPECT_FALSE(result.least_violating.has_value());
  EXPECT_TRUE(says(result, "deflector angle 45°"));
  EXPECT_TRUE(says(result, "0123456789abcdef"));
  EXPECT_TRUE(says(result, "9.9.9"));
}

TEST_F(Study, MarginsAreNegativeOutsideTheLimit) {
  add(45.0, 0.15, 0.8, 0.24, "start");
  const ConstraintResult inside = recommend(study_).recommended.value().design.constraints[0];
  EXPECT_NEAR(inside.margin.value(), 0.06, 1e-12);
  EXPECT_NEAR(inside.margin_percent.value(), 20.0, 1e-9);
  EXPECT_FALSE(inside.active);
  EXPECT_EQ(inside.metric, "launch_length_m");

  study_.designs.clear();
  add(45.0, 0.15, 0.8, 0.36, "start");
  const ConstraintResult outside = recommend(study_).least_violating.value().design.constraints[0];
  EXPECT_NEAR(outside.margin.value(), -0.06, 1e-12);
  EXPECT_FALSE(outside.active);
}

TEST_F(Study, AConstraintNearItsLimitIsActive) {
  add(45.0, 0.15, 0.8, 0.296, "start");  // 1.3 % of the limit left; active is below 2 %
  const Recommendation result = recommend(study_);
  EXPECT_TRUE(result.recommended->design.constraints[0].active);
  EXPECT_TRUE(says(result, "| active |"));
}

TEST_F(Study, AnAbsentMetricHasNoMarginButHolds) {
  add(45.0, 0.2, 0.99, std::nullopt, "start");
  const Recommendation result = recommend(study_);
  const ConstraintResult& constraint = result.recommended->design.constraints[0];
  EXPECT_FALSE(constraint.margin.has_value());
  EXPECT_TRUE(constraint.satisfied);
  EXPECT_TRUE(says(result, "holds (no value)"));
  EXPECT_TRUE(says(result, "nothing overflowed"));
}

TEST_F(Study, AlternativesAreFeasibleAndApartFromEachOther) {
  add(45.0, 0.15, 0.80, 0.2);
  add(46.0, 0.152, 0.79, 0.2);  // less than 5 % of each range from the first
  add(20.0, 0.15, 0.78, 0.2);
  add(21.0, 0.15, 0.77, 0.2);  // too near to the third
  add(45.0, 0.19, 0.76, 0.5);  // not feasible
  for (int k = 0; k < 6; ++k) add(20.0, 0.1 + 0.006 * k, 0.7 - 0.01 * k, 0.2);
  const std::vector<Alternative> list = recommend(study_).alternatives;
  ASSERT_EQ(list.size(), 5U);
  EXPECT_EQ(list[0].design.id, "0003");
  for (std::size_t a = 0; a < list.size(); ++a) {
    for (std::size_t b = a + 1; b < list.size(); ++b) {
      const auto &one = list[a].design.variables, &other = list[b].design.variables;
      const double angle = std::abs(one[0].value - other[0].value) / 60.0;
      const double height = std::abs(one[1].value - other[1].value) / 0.1;
      EXPECT_GE(std::max(angle, height), 0.05 - 1e-12);
    }
  }
}

TEST_F(Study, MarksWhatTheScatterCannotRank) {
  // Retention follows the angle but for 0.01 up and down in turn.
  for (int k = 0; k < 16; ++k) {
    add(4.0 * k, 0.1 + 0.1 * std::fmod(0.445 * k, 1.0),
        0.3 + 0.005 * 4.0 * k + (k % 2 == 0 ? 0.01 : -0.01), 0.2);
  }
  const Recommendation result = recommend(study_);
  EXPECT_EQ(result.recommended->design.id, "0015");
  const double scatter = result.effects[0].scatter.value();
  bool any = false, all = true;
  for (const Alternative& one : result.alternatives) {
    const double behind = result.recommended->design.objectives[0].value.value() -
                          one.design.objectives[0].value.value();
    EXPECT_EQ(one.within_scatter, behind < 2.0 * scatter) << one.design.id;
    any = any || *one.within_scatter;
    all = all && *one.within_scatter;
  }
  EXPECT_TRUE(any);
  EXPECT_FALSE(all);
  EXPECT_TRUE(says(result, "the data cannot rank 0016 against"));
}

TEST_F(Study, ReportsTheImprovementOverTheBestFeasibleStart) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(60.0, 0.1, 0.9, 0.5, "start");  // better, but not feasible
  add(45.0, 0.15, 0.75, 0.2);
  const Improvement improvement = recommend(study_).improvement.value();
  EXPECT_EQ(improvement.start_id, "0001");
  EXPECT_TRUE(improvement.start_feasible);
  const ObjectiveChange& objective = improvement.objectives[0];
  EXPECT_NEAR(objective.change.value(), 0.15, 1e-12);
  EXPECT_NEAR(objective.change_percent.value(), 25.0, 1e-9);
  EXPECT_TRUE(objective.better.value());
}

TEST_F(Study, RecoversAKnownLinearResponse) {
  for (int k = 0; k < 16; ++k) {
    const double angle = 60.0 * std::fmod(0.618 * k, 1.0);
    const double height = 0.1 + 0.1 * std::fmod(0.445 * k, 1.0);
    add(angle, height, 0.3 + 0.002 * angle + 2.0 * height, 0.5 - 0.005 * angle);
  }
  const std::vector<MetricResponse> effects = recommend(study_).effects;
  EXPECT_EQ(effects[0].metric, "retention_efficiency");
  EXPECT_EQ(effects[0].model, "linear");
  const VariableResponse& angle = effects[0].variables[0];
  EXPECT_EQ(angle.variable, "deflector_angle_deg");
  const double span = angle.tried_to - angle.tried_from;
  EXPECT_NEAR(angle.change.value(), 0.002 * span, 1e-10);  // exact but for rounding
  EXPECT_TRUE(angle.says.starts_with("rises by"));
  EXPECT_EQ(effects[1].metric, "launch_length_m");
  EXPECT_TRUE(effects[1].variables[0].says.starts_with("falls by"));
  EXPECT_FALSE(effects[1].variables[1].clear);
}

TEST_F(Study, AdmitsThatFewDesignsTellNothing) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(45.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommend(study_);
  EXPECT_EQ(result.effects[0].model, "none");
  EXPECT_EQ(result.effects[0].variables[0].says, "the data cannot tell");
  EXPECT_TRUE(says(result, "the data cannot tell"));
}

TEST_F(Study, DoesNotRecommendWhenNothingIsFeasible) {
  add(0.0, 0.1, 0.9, 0.6, "start");
  add(45.0, 0.15, 0.5, 0.33);  // least outside, though worst in the objective
  add(30.0, 0.15, 0.7, 0.45);
  const Recommendation result = recommend(study_);
  EXPECT_FALSE(result.recommended.has_value());
  EXPECT_FALSE(result.confirmation.has_value());
  ASSERT_TRUE(result.least_violating.has_value());
  EXPECT_EQ(result.least_violating->design.id, "0002");
  EXPECT_NEAR(result.least_violating->violation, 0.1, 1e-9);
  EXPECT_TRUE(result.alternatives.empty());
  EXPECT_TRUE(recommendation_text(result).starts_with("# No arrangement to recommend"));
  EXPECT_TRUE(says(result, "**violated**"));
}

TEST_F(Study, FailedDesignsAreListedAndNeverChosen) {
  add_failed("the time step fell to zero");
  add(45.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommend(study_);
  EXPECT_EQ(result.recommended->design.id, "0002");
  EXPECT_EQ(result.failed[0].id, "0001");
  EXPECT_TRUE(says(result, "0001: the time step fell to zero"));
}

TEST_F(Study, OnlyFailuresGiveNoRecommendation) {
  add_failed("the time step fell to zero");
  const Recommendation result = recommend(study_);
  EXPECT_FALSE(result.recommended.has_value());
  EXPECT_FALSE(result.least_violating.has_value());
  EXPECT_EQ(result.shown(), nullptr);
  EXPECT_TRUE(says(result, "No simulation succeeded"));
}

TEST_F(Study, CaveatsTellOfWhatIsNotFinished) {
  add(45.0, 0.15, 0.75, 0.2);
  const std::size_t always = recommend(study_).caveats.size();
  study_.log_complete = false;
  study_.state = "running";
  study_.unsettled = {"0001"};
  const Recommendation result = recommend(study_);
  EXPECT_EQ(result.caveats.size(), always + 3);
  EXPECT_FALSE(result.study.log_complete);
  EXPECT_TRUE(says(result, "The last line of the log is not complete"));
  EXPECT_TRUE(says(result, "its state is \"running\""));
  EXPECT_TRUE(
      says(result, "1 of 1 runs, that of the recommended design among them, ended at the stop"));
}

TEST_F(Study, SaysWhenADesignLiesAtABound) {
  add(60.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommend(study_);
  EXPECT_EQ(result.recommended->design.variables[0].at_bound, Bound::upper);
  EXPECT_EQ(result.recommended->design.variables[1].at_bound, Bound::none);
  EXPECT_TRUE(says(result, "at its upper bound"));
}

TEST_F(Study, IsWrittenAsJson) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(60.0, 0.15, 0.75, std::nullopt);
  const designs::Json json = recommendation_json(recommend(study_));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys,
            (std::vector<std::string>{
                "format", "study", "page_one", "rule", "feasible", "recommended", "confirmation",
                "least_violating", "front", "leaving", "hypervolume", "improvement", "alternatives",
                "effects", "sensitivity", "failed", "caveats", "reproduce", "definitions"}));
  EXPECT_EQ(json["format"], "parapet-recommendation/1");
  const designs::Json& best = json["recommended"];
  EXPECT_EQ(best["design"].dump(), R"({"deflector_angle_deg":60.0,"barrier_1_height_m":0.15})");
  EXPECT_EQ(best["variables"][0]["at_bound"], "upper");
  EXPECT_EQ(best["objectives"][0].dump(),
            R"({"name":"retention_efficiency","metric":"retention_efficiency",)"
            R"("goal":"maximize","weight":1.0,"value":0.75,"absent":false})");
  EXPECT_EQ(best["constraints"][0].dump(),
            R"({"name":"reach","metric":"launch_length_m","value":null,"lower":null,"upper":0.3,)"
            R"("satisfied":true,"margin":null,"margin_percent":null,"active":false})");
  EXPECT_EQ(best["metrics_absent"].dump(), R"({"launch_length_m":"nothing overflowed"})");
  EXPECT_TRUE(json["least_violating"].is_null());
  EXPECT_EQ(json["alternatives"][0]["within_scatter"], false);
  EXPECT_EQ(json["reproduce"]["provenance"]["program_version"], "9.9.9");
}

}  // namespace
}  // namespace parapet::reports
