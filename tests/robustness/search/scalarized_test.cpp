// Several objectives for NLopt: fronts of a problem whose front is known.
#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/problem.hpp"
#include "scalarized.hpp"

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

TEST_F(Scalarized, BothKindsReachTheKnownFrontWithinTheBudget) {
  for (const char* kind : {"augmented_chebyshev", "epsilon_constraint"}) {
    const FakeSimulator simulator;
    const auto summary = run(parsed(with(kind)), kind, simulator);
    EXPECT_EQ(summary.state, study::StudyState::done) << summary.message;
    EXPECT_LE(simulator.ended(), 120);
    // Five points on the front sqrt(f1) + sqrt(f2) = 1, found with a tolerance of 1e-3 on the
    // variables. Near an end of the front the sum grows with h, so h within 0.01 is 1.01 or less;
    // measured below 1.01.
    int near = 0;
    double least_f1 = 10.0, least_f2 = 10.0;
    for (const auto& record : summary.pareto) {
      const double f1 = *record.objectives[0].value, f2 = *record.objectives[1].value;
      if (std::sqrt(f1) + std::sqrt(f2) < 1.02) ++near;
      least_f1 = std::min(least_f1, f1);
      least_f2 = std::min(least_f2, f2);
    }
    EXPECT_GE(near, 4) << kind;
    EXPECT_LT(least_f1, 0.05) << kind << ": the front is covered to this end";
    EXPECT_LT(least_f2, 0.05) << kind << ": and to the other";
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
