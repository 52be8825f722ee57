// Designs of experiments: laid out as their names say, refused designs counted, worked off in
// order.
#include "parapet/study/experiments.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "fake_study.hpp"
#include "parapet/study/problem.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::Experiments;

class ExperimentsTest : public FakeStudyTest {
 protected:
  static Json with(const std::string& algorithm, int evaluations) {
    Json json = fake_study();
    json["constraints"].erase(0);  // the formula
    json["method"]["algorithm"] = algorithm;
    json["method"]["max_evaluations"] = evaluations;
    return json;
  }
};

TEST_F(ExperimentsTest, FirstSobolPointIsTheCentreAndEveryQuarterGetsItsShare) {
  const Experiments plan = study::lay_out_experiments(parsed(with("SOBOL", 15)));
  ASSERT_EQ(plan.designs.size(), 15U);
  EXPECT_EQ(plan.designs.front().at("deflector_angle_deg"), 30.0);
  EXPECT_NEAR(plan.designs.front().at("upstream_height_m"), 0.07, 1e-15);
  // With the corner that is left out, 16 points: four in each quarter of either variable.
  std::array<int, 4> angle{}, height{};
  for (const auto& design : plan.designs) {
    ++angle.at(static_cast<std::size_t>(4.0 * scaled_angle(design)));
    ++height.at(static_cast<std::size_t>(4.0 * scaled_height(design)));
  }
  EXPECT_EQ(angle, (std::array<int, 4>{3, 4, 4, 4}));
  EXPECT_EQ(height, (std::array<int, 4>{3, 4, 4, 4}));
}

TEST_F(ExperimentsTest, LatinHypercubeHasOneDesignInEveryStratumOfEveryVariable) {
  const Experiments plan = study::lay_out_experiments(parsed(with("LATIN_HYPERCUBE", 20)));
  std::set<int> angle, height;
  for (const auto& design : plan.designs) {
    angle.insert(static_cast<int>(20.0 * scaled_angle(design)));
    height.insert(static_cast<int>(20.0 * scaled_height(design)));
  }
  EXPECT_EQ(angle.size(), 20U);
  EXPECT_EQ(height.size(), 20U);
  EXPECT_EQ(study::lay_out_experiments(parsed(with("LATIN_HYPERCUBE", 20))).designs, plan.designs);
  Json other = with("LATIN_HYPERCUBE", 20);
  other["method"]["seed"] = 4;
  EXPECT_NE(study::lay_out_experiments(parsed(other)).designs, plan.designs);
}

TEST_F(ExperimentsTest, FullFactorialCombinesLevelsIntegersAndOptions) {
  Json json = with("FULL_FACTORIAL", 100);
  json["method"]["points_per_variable"] = 4;
  json["variables"]["deflector"] =
      Json::parse(R"({"options": {"none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}})");
  // The angle exists with the plate only: 4 heights without, 4 x 4 with it.
  Json angle = json["variables"]["deflector_angle_deg"];
  angle["active_when"] = Json::parse(R"({"deflector": ["plate"]})");
  json["variables"].erase("deflector_angle_deg");
  json["variables"]["deflector_angle_deg"] = angle;
  const Experiments plan = study::lay_out_experiments(parsed(json));
  EXPECT_EQ(plan.designs.size(), 20U);
  const std::set<designs::Design> different(plan.designs.begin(), plan.designs.end());
  EXPECT_EQ(different.size(), 20U);
  EXPECT_EQ(std::count_if(plan.designs.begin(), plan.designs.end(),
                          [](const auto& design) { return design.at("deflector") == 0.0; }),
            4);
  EXPECT_EQ(different.count(
                {{"deflector", 1.0}, {"deflector_angle_deg", 60.0}, {"upstream_height_m", 0.1}}),
            1U)
      << "the bounds themselves";
}

TEST_F(ExperimentsTest, FullFactorialBeyondTheBudgetIsRefusedAtTheDoor) {
  const auto issues = study::method_issues(parsed(with("FULL_FACTORIAL", 8)));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().pointer, "/method/max_evaluations");
  EXPECT_EQ(issues.front().allowed, "at least 9");
  EXPECT_TRUE(study::method_issues(parsed(with("FULL_FACTORIAL", 9))).empty());
}

// Counted, not laid out: these would fill the memory.
TEST_F(ExperimentsTest, CountsComeBeforeDesigns) {
  Json json = with("FULL_FACTORIAL", 1000);
  json["method"]["points_per_variable"] = 1000;
  auto issues = study::method_issues(parsed(json));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().pointer, "/method/max_evaluations");
  EXPECT_EQ(issues.front().allowed, "at least 1000000");
  json["variables"]["thickness_m"] =
      Json::parse(R"({"lower": 0.01, "upper": 0.02, "target": "/barriers/0/thickness_m"})");
  issues = study::method_issues(parsed(json));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().pointer, "/method/points_per_variable");
  EXPECT_NE(issues.front().problem.find("1e+09 designs"), std::string::npos)
      << issues.front().problem;
  // A million designs of a sequence are sound, and cost nothing before they run.
  for (const char* algorithm : {"SOBOL", "LATIN_HYPERCUBE"}) {
    EXPECT_TRUE(study::method_issues(parsed(with(algorithm, 1000000))).empty()) << algorithm;
  }
}

TEST_F(ExperimentsTest, StartsCountWhereTheyAreNotAmongTheLevels) {
  Json json = with("FULL_FACTORIAL", 9);
  json["method"]["starts"] =
      Json::parse(R"([{"deflector_angle_deg": 30, "upstream_height_m": 0.04}])");
  EXPECT_TRUE(study::method_issues(parsed(json)).empty()) << "one of the nine";
  json["method"]["starts"] =
      Json::parse(R"([{"deflector_angle_deg": 31, "upstream_height_m": 0.04}])");
  const auto issues = study::method_issues(parsed(json));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().allowed, "at least 10");
}

// With a constraint on a formula the designs must be looked at, but no more than the budget kept.
TEST_F(ExperimentsTest, ConstrainedFactorialIsComparedWhileItIsLaidOut) {
  Json json = fake_study();
  json["method"] = Json::parse(
      R"({"algorithm": "FULL_FACTORIAL", "max_evaluations": 20, "points_per_variable": 900})");
  const auto issues = study::method_issues(parsed(json));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().pointer, "/method/max_evaluations");
  json["method"]["points_per_variable"] = 4;
  EXPECT_TRUE(study::method_issues(parsed(json)).empty()) << "16 less the corner";
}

// Only constraints that there are get the blame.
TEST_F(ExperimentsTest, ObjectiveWithoutAValueIsNamed) {
  Json json = with("BAYESIAN", 6);
  // Finite on a sliver of the box, which the check of the study may find and the search does not.
  json["objectives"][1] = {{"name", "sliver"},
                           {"expression", "sqrt(deflector_angle_deg - 59.9999999)"},
                           {"goal", "minimize"}};
  try {
    const auto summary = run(parsed(json), "out", FakeSimulator());
    if (summary.state == study::StudyState::failed) {
      EXPECT_NE(summary.message.find("sliver"), std::string::npos) << summary.message;
      EXPECT_EQ(summary.message.find("constraints"), std::string::npos) << summary.message;
    }
  } catch (const designs::InputError& error) {
    EXPECT_EQ(error.issues().front().pointer, "/objectives/1/expression");
  }
}

TEST_F(ExperimentsTest, RefusedDesignsAreCountedAndNotSimulated) {
  Json json = fake_study();  // a + h <= 1.7 refuses one of nine
  json["method"] = Json::parse(R"({"algorithm": "FULL_FACTORIAL", "max_evaluations": 9})");
  const FakeSimulator simulator;
  const auto summary = run(parsed(json), "out", simulator, 2);
  EXPECT_EQ(summary.rejected, 1);
  EXPECT_EQ(simulator.ended(), 8);
  EXPECT_EQ(summary.state, study::StudyState::done);
}

TEST_F(ExperimentsTest, ListIsWorkedOffInOrderAndResumed) {
  Json json = with("LIST", 5);
  json["method"]["starts"] = Json::parse(R"([
    {"deflector_angle_deg": 1, "upstream_height_m": 0.05},
    {"deflector_angle_deg": 2, "upstream_height_m": 0.05},
    {"deflector_angle_deg": 3, "upstream_height_m": 0.05}])");
  const auto study = parsed(json);
  run(study, "calm", FakeSimulator(), 2);
  run(study, "out", FakeSimulator({.delays = false, .fails = {}, .cancel_after = 1}), 2);
  run(study, "out", FakeSimulator(), 2);
  EXPECT_EQ(records("out"), records("calm"));
  EXPECT_EQ(records("calm").at("0002")["design"]["deflector_angle_deg"], 2.0);
  EXPECT_EQ(this->json("calm", "pareto.json")["designs"][0]["objectives"][0]["estimate"], nullptr)
      << "there is no surrogate";
  EXPECT_FALSE(std::filesystem::exists(folder / "calm/surrogates.json"));
}

}  // namespace
}  // namespace parapet::test
