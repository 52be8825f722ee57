#include "parapet/reports/recommendation.hpp"

#include <cmath>
#include <optional>

#include "parapet/designs/error.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "scratch_folder.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

/// Retention is to be maximised with a launch length of at most 0.3 m.
class Study : public ScratchFolder {
 protected:
  Study() {
    const Json spec = Json::parse(R"({
      "name": "hand-made",
      "variables": {"deflector_angle_deg": {"lower": 0, "upper": 60, "targets": []},
                    "barrier_1_height_m": {"lower": 0.1, "upper": 0.2, "targets": []}},
      "objectives": [{"metric": "retention_efficiency", "goal": "maximize"}],
      "constraints": [{"name": "reach", "metric": "launch_length_m", "upper": 0.3}]})");
    write(folder_ / "study.json", Json{{"format", "parapet-study-state/1"},
                                       {"spec", spec},
                                       {"spec_hash", "0123456789abcdef"},
                                       {"provenance", {{"program_version", "9.9.9"}}}}
                                      .dump());
  }

  void add(double angle, double height, double retention, std::optional<double> launch,
           const std::string& stage = "search") {
    records::EvaluationRecord record;
    record.id = records::evaluation_id(++count_);
    record.stage = stage;
    record.design = {{"deflector_angle_deg", angle}, {"barrier_1_height_m", height}};
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
    record.spacing = 0.01;
    log_ += to_json(record).dump() + "\n";
  }

  void add_failed(const std::string& reason) {
    records::EvaluationRecord record;
    record.id = records::evaluation_id(++count_);
    record.stage = "search";
    record.design = {{"deflector_angle_deg", 1.0}, {"barrier_1_height_m", 0.11}};
    record.reason = reason;
    record.spacing = 0.01;
    log_ += to_json(record).dump() + "\n";
  }

  Recommendation recommended() {
    write(folder_ / "evaluations.jsonl", log_);
    return recommend(folder_);
  }

  std::string log_;
  int count_ = 0;
};

TEST_F(Study, PicksTheBestFeasibleDesignNotTheBestInfeasibleOne) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(30.0, 0.2, 0.95, 0.4);  // better, but lands too far away
  add(45.0, 0.15, 0.8, 0.2);
  add(50.0, 0.12, 0.7, 0.28);
  const Recommendation result = recommended();
  EXPECT_TRUE(result.feasible);
  EXPECT_EQ(result.json["recommended"]["id"], "0003");
  EXPECT_EQ(result.json["recommended"]["design"]["deflector_angle_deg"], 45.0);
  EXPECT_TRUE(result.json["least_violating"].is_null());
  EXPECT_NE(result.markdown.find("deflector angle 45°"), std::string::npos);
  EXPECT_NE(result.markdown.find("0123456789abcdef"), std::string::npos);
  EXPECT_NE(result.markdown.find("9.9.9"), std::string::npos);
}

TEST_F(Study, MarginsAreNegativeOutsideTheLimit) {
  add(45.0, 0.15, 0.8, 0.24, "start");
  const Json inside = recommended().json["recommended"]["constraints"][0];
  EXPECT_NEAR(inside["margin"].get<double>(), 0.06, 1e-12);
  EXPECT_NEAR(inside["margin_percent"].get<double>(), 20.0, 1e-9);
  EXPECT_FALSE(inside["active"].get<bool>());
  EXPECT_EQ(inside["metric"], "launch_length_m");

  log_.clear();
  add(45.0, 0.15, 0.8, 0.36, "start");
  const Json outside = recommended().json["least_violating"]["constraints"][0];
  EXPECT_NEAR(outside["margin"].get<double>(), -0.06, 1e-12);
  EXPECT_FALSE(outside["active"].get<bool>());
}

TEST_F(Study, AConstraintNearItsLimitIsActive) {
  add(45.0, 0.15, 0.8, 0.296, "start");  // 1.3 % of the limit left; active is below 2 %
  const Recommendation result = recommended();
  EXPECT_TRUE(result.json["recommended"]["constraints"][0]["active"].get<bool>());
  EXPECT_NE(result.markdown.find("at its limit: launch length"), std::string::npos);
}

TEST_F(Study, AnAbsentMetricHasNoMarginButHolds) {
  add(45.0, 0.2, 0.99, std::nullopt, "start");
  const Recommendation result = recommended();
  const Json constraint = result.json["recommended"]["constraints"][0];
  EXPECT_TRUE(constraint["margin"].is_null());
  EXPECT_TRUE(constraint["satisfied"].get<bool>());
  EXPECT_NE(result.markdown.find("holds (no value)"), std::string::npos);
  EXPECT_NE(result.markdown.find("nothing overflowed"), std::string::npos);
}

TEST_F(Study, AlternativesAreFeasibleAndApartFromEachOther) {
  add(45.0, 0.15, 0.80, 0.2);
  add(46.0, 0.152, 0.79, 0.2);  // less than 5 % of each range from the first
  add(20.0, 0.15, 0.78, 0.2);
  add(21.0, 0.15, 0.77, 0.2);  // too near to the third
  add(45.0, 0.19, 0.76, 0.5);  // not feasible
  for (int k = 0; k < 6; ++k) add(20.0, 0.1 + 0.006 * k, 0.7 - 0.01 * k, 0.2);
  const Json list = recommended().json["alternatives"];
  ASSERT_EQ(list.size(), 5U);
  EXPECT_EQ(list[0]["id"], "0003");
  for (std::size_t a = 0; a < list.size(); ++a) {
    for (std::size_t b = a + 1; b < list.size(); ++b) {
      const Json &one = list[a]["design"], &other = list[b]["design"];
      const double angle = std::abs(one["deflector_angle_deg"].get<double>() -
                                    other["deflector_angle_deg"].get<double>()) /
                           60.0;
      const double height = std::abs(one["barrier_1_height_m"].get<double>() -
                                     other["barrier_1_height_m"].get<double>()) /
                            0.1;
      EXPECT_GE(std::max(angle, height), 0.05 - 1e-12);
    }
  }
}

TEST_F(Study, ReportsTheImprovementOverTheBestFeasibleStart) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(60.0, 0.1, 0.9, 0.5, "start");  // better, but not feasible
  add(45.0, 0.15, 0.75, 0.2);
  const Json improvement = recommended().json["improvement"];
  EXPECT_EQ(improvement["start_id"], "0001");
  EXPECT_TRUE(improvement["start_feasible"].get<bool>());
  const Json& objective = improvement["objectives"][0];
  EXPECT_NEAR(objective["change"].get<double>(), 0.15, 1e-12);
  EXPECT_NEAR(objective["change_percent"].get<double>(), 25.0, 1e-9);
  EXPECT_TRUE(objective["better"].get<bool>());
}

TEST_F(Study, RecoversAKnownLinearResponse) {
  for (int k = 0; k < 16; ++k) {
    const double angle = 60.0 * std::fmod(0.618 * k, 1.0);
    const double height = 0.1 + 0.1 * std::fmod(0.445 * k, 1.0);
    add(angle, height, 0.3 + 0.002 * angle + 2.0 * height, 0.5 - 0.005 * angle);
  }
  const Recommendation result = recommended();
  const Json& fit = result.json["effects"][0];
  EXPECT_EQ(fit["metric"], "retention_efficiency");
  EXPECT_EQ(fit["model"], "linear");
  const Json& angle = fit["variables"]["deflector_angle_deg"];
  const double span = angle["tried_to"].get<double>() - angle["tried_from"].get<double>();
  EXPECT_NEAR(angle["change"].get<double>(), 0.002 * span, 1e-10);  // exact but for rounding
  EXPECT_TRUE(angle["says"].get<std::string>().starts_with("rises by"));
  const Json& reach = result.json["effects"][1];
  EXPECT_EQ(reach["metric"], "launch_length_m");
  EXPECT_TRUE(
      reach["variables"]["deflector_angle_deg"]["says"].get<std::string>().starts_with("falls by"));
  EXPECT_FALSE(reach["variables"]["barrier_1_height_m"]["clear"].get<bool>());
}

TEST_F(Study, AdmitsThatFewDesignsTellNothing) {
  add(0.0, 0.1, 0.6, 0.25, "start");
  add(45.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["effects"][0]["model"], "none");
  EXPECT_EQ(result.json["effects"][0]["variables"]["deflector_angle_deg"]["says"],
            "the data cannot tell");
  EXPECT_NE(result.markdown.find("the data cannot tell"), std::string::npos);
}

TEST_F(Study, DoesNotRecommendWhenNothingIsFeasible) {
  add(0.0, 0.1, 0.9, 0.6, "start");
  add(45.0, 0.15, 0.5, 0.33);  // least outside, though worst in the objective
  add(30.0, 0.15, 0.7, 0.45);
  const Recommendation result = recommended();
  EXPECT_FALSE(result.feasible);
  EXPECT_TRUE(result.json["recommended"].is_null());
  EXPECT_EQ(result.json["least_violating"]["id"], "0002");
  EXPECT_NEAR(result.json["least_violating"]["violation"].get<double>(), 0.1, 1e-9);
  EXPECT_TRUE(result.json["alternatives"].empty());
  EXPECT_TRUE(result.markdown.starts_with("# No arrangement to recommend"));
  EXPECT_NE(result.markdown.find("**violated**"), std::string::npos);
}

TEST_F(Study, FailedDesignsAreListedAndNeverChosen) {
  add_failed("the time step fell to zero");
  add(45.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["recommended"]["id"], "0002");
  EXPECT_EQ(result.json["failed"][0]["id"], "0001");
  EXPECT_NE(result.markdown.find("0001: the time step fell to zero"), std::string::npos);
}

TEST_F(Study, OnlyFailuresGiveNoRecommendation) {
  add_failed("the time step fell to zero");
  const Recommendation result = recommended();
  EXPECT_FALSE(result.feasible);
  EXPECT_TRUE(result.json["least_violating"].is_null());
  EXPECT_NE(result.markdown.find("No simulation ended well"), std::string::npos);
}

TEST_F(Study, PassesOverAHalfWrittenLastLine) {
  add(45.0, 0.15, 0.75, 0.2);
  const std::string whole = log_;
  add(50.0, 0.18, 0.99, 0.2);
  log_.resize(whole.size() + 40);
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["recommended"]["id"], "0001");
  EXPECT_EQ(result.json["study"]["evaluations"], 1);
  EXPECT_FALSE(result.json["study"]["log_complete"].get<bool>());
  EXPECT_EQ(content(folder_ / "evaluations.jsonl"), log_) << "reading does not repair";
}

TEST_F(Study, NamesADamagedLineInTheMiddle) {
  add(45.0, 0.15, 0.75, 0.2);
  log_ += "{\"id\": \"0002\", \n";
  add(50.0, 0.18, 0.8, 0.2);
  try {
    recommended();
    FAIL() << "the damage went unseen";
  } catch (const designs::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("evaluations.jsonl:2"), std::string::npos)
        << error.what();
  }
}

TEST_F(Study, NamesWhatIsMissing) {
  EXPECT_THROW(recommend(folder_), designs::InputError);  // no log yet
  EXPECT_THROW(recommended(), designs::InputError);       // an empty one
  write(folder_ / "study.json", "{\"format\": \"something\"}");
  EXPECT_THROW(recommend(folder_), designs::InputError);
  write(folder_ / "study.json", "{");
  EXPECT_THROW(recommend(folder_), designs::InputError);
  std::filesystem::remove(folder_ / "study.json");
  EXPECT_THROW(recommend(folder_), designs::InputError);
}

TEST_F(Study, SaysWhenADesignLiesAtABound) {
  add(60.0, 0.15, 0.75, 0.2);
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["recommended"]["variables"][0]["at_bound"], "upper");
  EXPECT_NE(result.markdown.find("at its upper bound"), std::string::npos);
}

TEST_F(Study, TheSameLogGivesTheSameBytes) {
  add(45.0, 0.15, 0.75, 0.2, "start");
  add(30.0, 0.12, 0.7, 0.25);
  const Recommendation once = recommended();
  const Recommendation twice = recommended();
  EXPECT_EQ(once.json.dump(), twice.json.dump());
  EXPECT_EQ(once.markdown, twice.markdown);
}

}  // namespace
}  // namespace parapet::reports
