// What the asynchronous search leaves behind: events, failures, and designs that are not feasible.
#include <algorithm>
#include <cmath>

#include "fake_study.hpp"
#include "parapet/records/evaluation_log.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::StudyState;

class SearchOutcome : public FakeStudyTest {};

TEST_F(SearchOutcome, LogHoldsEveryEventAndTheirStatistics) {
  Json json = fake_study_with_scenarios();
  json["objectives"][0]["statistic"] = "quantile";
  json["objectives"][0]["quantile"] = 0.36;  // three events bound no higher one
  run(parsed(json), "out", FakeSimulator(), 2);
  for (const auto& [id, line] : records("out")) {
    const auto design = line["design"].get<designs::Design>();
    const double a = scaled_angle(design), h = scaled_height(design);
    ASSERT_EQ(line["scenarios"].size(), 3U);
    EXPECT_EQ(line["scenarios"][2]["name"], "stiff");
    EXPECT_EQ(line["scenarios"][2]["weight"], 0.2);
    // Half of the events, by weight, are soft, the best one: the quantile is its value.
    EXPECT_NEAR(line["objectives"][0]["value"].get<double>(), a * a + h * h + 0.05, 1e-12);
    // 0.5 0.05 + 0.3 0.1 + 0.2 0.2
    EXPECT_NEAR(line["metrics"]["barrier_1_slam_force_n_per_m"].get<double>(),
                a * a + h * h + 0.095, 1e-12);
    EXPECT_EQ(line["cpu_time_s"], 3.0);
    const Json event = this->json("out", "evaluations/" + id + "-stiff.json");
    EXPECT_EQ(event["format"], "parapet-simulation/1");
    EXPECT_EQ(event["design"], line["design"]);
  }
}

TEST_F(SearchOutcome, FailedDesignsAreRecordedAndNeverRecommended) {
  const FakeSimulator simulator(
      {.delays = false,
       .fails = [](const designs::Design& design) { return scaled_angle(design) < 0.4; },
       .cancel_after = -1});
  Json json = fake_study_with_scenarios();
  json["method"]["starts"] =
      Json::parse(R"([{"deflector_angle_deg": 6, "upstream_height_m": 0.05}])");
  const auto summary = run(parsed(json), "out", simulator, 2);
  int failed = 0;
  for (const auto& [id, line] : records("out")) {
    if (line["status"] != "failed") continue;
    ++failed;
    EXPECT_EQ(line["reason"], "scenario soft: it broke");
    EXPECT_EQ(line["feasible"], false);
  }
  EXPECT_GE(failed, 1) << "the starting design is one";
  ASSERT_FALSE(summary.pareto.empty());
  for (const auto& record : summary.pareto) EXPECT_GE(scaled_angle(record.design), 0.4);
}

TEST_F(SearchOutcome, EveryDesignFailingIsAFailedStudy) {
  const FakeSimulator simulator(
      {.delays = false, .fails = [](const designs::Design&) { return true; }, .cancel_after = -1});
  const auto summary = run(parsed(fake_study()), "out", simulator);
  EXPECT_EQ(summary.state, StudyState::failed);
  EXPECT_NE(summary.message.find("it broke"), std::string::npos) << summary.message;
  EXPECT_FALSE(summary.best.has_value());
  EXPECT_TRUE(summary.pareto.empty());
}

TEST_F(SearchOutcome, InfeasibleDesignsAreNeitherBestNorInTheFront) {
  Json json = fake_study();
  // Only h <= 0.2 is feasible, and the front wants h = 0.
  json["constraints"][1]["lower"] = 0.9;
  const auto summary = run(parsed(json), "out", FakeSimulator(), 2);
  int infeasible = 0;
  for (const auto& [id, line] : records("out")) {
    infeasible += line["feasible"].get<bool>() ? 0 : 1;
  }
  EXPECT_GE(infeasible, 1) << "nothing was tested";
  ASSERT_TRUE(summary.best.has_value());
  EXPECT_LE(scaled_height(summary.best->design), 0.2 + 1e-9);
  const Json pareto = this->json("out", "pareto.json");
  ASSERT_GE(pareto["designs"].size(), 1U);
  for (const Json& one : pareto["designs"]) {
    EXPECT_LE(scaled_height(one["design"].get<designs::Design>()), 0.2 + 1e-9);
    for (const Json& constraint : one["constraints"]) EXPECT_EQ(constraint["satisfied"], true);
  }
}

}  // namespace
}  // namespace parapet::test
