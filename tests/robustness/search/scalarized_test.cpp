// Several objectives for NLopt: fronts of a problem whose front is known.
#include "scalarized.hpp"

#include <algorithm>
#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/problem.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using designs::Scalarization;
using study::Subproblem;

class Scalarized : public FakeStudyTest {
 protected:
  static Json with(const std::string& scalarization) {
    Json json = fake_study();
    json["method"] = Json::parse(R"({"algorithm": "COBYLA", "max_evaluations": 120,
      "pareto_points": 5, "relative_tolerance": 0.001, "start_count": 4})");
    json["method"]["scalarization"] = scalarization;
    return json;
  }
};

TEST(Subproblems, AugmentedChebyshevByHand) {
  const Subproblem problem{.kind = Scalarization::augmented_chebyshev,
                           .ideal = {1.0, -2.0},
                           .range = {2.0, 4.0},
                           .weights = {0.25, 0.75},
                           .limits = {}};
  // (f - ideal)/range = 0.5 and 0.25: max(0.125, 0.1875) + 0.05 0.75
  EXPECT_NEAR(problem.scalar({2.0, -1.0}), 0.1875 + 0.0375, 1e-15);
  EXPECT_TRUE(problem.violations({2.0, -1.0}).empty());
}

TEST(Subproblems, EpsilonConstraintByHand) {
  const Subproblem problem{.kind = Scalarization::epsilon_constraint,
                           .ideal = {0.0, 0.0},
                           .range = {2.0, 4.0},
                           .weights = {},
                           .limits = {1.0}};
  EXPECT_DOUBLE_EQ(problem.scalar({3.0, 5.0}), 1.5);
  EXPECT_EQ(problem.violations({3.0, 5.0}), std::vector<double>{1.0});
}

TEST(Subproblems, BeginWithTheEndsOfTheFrontAndSpreadBetween) {
  Json json = fake_study();
  json["method"]["scalarization"] = "epsilon_constraint";
  const auto study = parsed(json);
  std::vector<records::EvaluationRecord> evaluated(2);
  for (auto& record : evaluated) record.ok = record.feasible = true;
  evaluated[0].objectives = {{"f1", designs::Goal::minimize, 1.0, 1.0, false},
                             {"f2", designs::Goal::minimize, 1.0, 9.0, false}};
  evaluated[1].objectives = {{"f1", designs::Goal::minimize, 1.0, 3.0, false},
                             {"f2", designs::Goal::minimize, 1.0, 5.0, false}};
  EXPECT_EQ(study::make_subproblem(study, evaluated, 0, 5).weights, (std::vector<double>{1, 0}));
  EXPECT_EQ(study::make_subproblem(study, evaluated, 1, 5).weights, (std::vector<double>{0, 1}));
  for (int k = 0; k < 3; ++k) {
    const Subproblem inner = study::make_subproblem(study, evaluated, 2 + k, 5);
    EXPECT_EQ(inner.ideal, (std::vector<double>{1, 5}));
    EXPECT_EQ(inner.range, (std::vector<double>{2, 4}));
    EXPECT_EQ(inner.limits, (std::vector<double>{6.0 + k}));
  }
}

TEST_F(Scalarized, BothKindsReachTheKnownFrontWithinTheBudget) {
  for (const char* kind : {"augmented_chebyshev", "epsilon_constraint"}) {
    const FakeSimulator simulator;
    const auto summary = run(parsed(with(kind)), kind, simulator);
    EXPECT_EQ(summary.state, study::StudyState::done) << summary.message;
    EXPECT_LE(simulator.ended(), 120);
    // The front is sqrt(f1) + sqrt(f2) = 1 with sqrt(f1) from 0 to 1. Five points share it: its
    // ends and three between, found with a tolerance of 1e-3 on the variables (at an end the sum
    // grows by h itself). The largest gap between designs on it would be 0.25 for equal steps;
    // measured 0.07 (Chebyshev) and 0.17.
    std::vector<double> places{0.0, 1.0};
    for (const auto& record : summary.pareto) {
      const double f1 = *record.objectives[0].value, f2 = *record.objectives[1].value;
      if (std::sqrt(f1) + std::sqrt(f2) < 1.01) places.push_back(std::sqrt(f1));
    }
    std::sort(places.begin(), places.end());
    double gap = 0.0;
    for (std::size_t k = 1; k < places.size(); ++k) {
      gap = std::max(gap, places[k] - places[k - 1]);
    }
    EXPECT_LT(gap, 0.35) << kind;
    EXPECT_LT(places[1], 0.1) << kind << ": the front is covered to this end";
    EXPECT_GT(places[places.size() - 2], 0.9) << kind << ": and to the other";
  }
}

TEST_F(Scalarized, StoppedAnywhereItResumesToTheSameLog) {
  const auto study = parsed(with("augmented_chebyshev"));
  run(study, "calm", FakeSimulator());
  for (const int stop : {2, 40, 90}) {
    const std::string out = "out" + std::to_string(stop);
    run(study, out, FakeSimulator({.delays = false, .fails = {}, .cancel_after = stop}));
    EXPECT_EQ(records(out).size(), static_cast<std::size_t>(stop));
    run(study, out, FakeSimulator());
    EXPECT_EQ(records(out), records("calm"));
  }
}

TEST_F(Scalarized, WeightedSumTakesTheWayItAlwaysTook) {
  Json json = with("weighted_sum");
  json["method"].erase("scalarization");
  const auto summary = run(parsed(json), "out", FakeSimulator());
  ASSERT_TRUE(summary.best.has_value());
  // a^2 + h^2 + (1 - a)^2 + h^2 has its minimum 0.5 at a = 0.5, h = 0.
  EXPECT_NEAR(*summary.best->objective_scalar, 0.5, 0.01);
}

TEST_F(Scalarized, ChoicesAreRefusedAtTheDoor) {
  Json json = with("augmented_chebyshev");
  json["variables"]["deflector"] = Json::parse(
      R"({"options": {"short": {"set": {"/barriers/0/deflector/length_m": 0.03}}, "long": {}}})");
  const auto issues = study::method_issues(parsed(json));
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().pointer, "/method/algorithm");
  EXPECT_NE(issues.front().problem.find("knows no choices"), std::string::npos);
  EXPECT_NE(issues.front().allowed.find("BAYESIAN"), std::string::npos);
}

TEST_F(Scalarized, IntegersAreRoundedAndEachDesignSimulatedOnce) {
  Json json = with("augmented_chebyshev");
  json["variables"]["deflector_angle_deg"]["type"] = "integer";
  const FakeSimulator simulator;
  run(parsed(json), "out", simulator);
  for (const auto& [id, line] : records("out")) {
    const double angle = line["design"]["deflector_angle_deg"].get<double>();
    EXPECT_EQ(angle, std::round(angle));
  }
  for (const auto& [what, times] : simulator.counts()) EXPECT_EQ(times, 1) << what;
}

}  // namespace
}  // namespace parapet::test
