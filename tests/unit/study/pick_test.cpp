#include "parapet/study/pick.hpp"

#include <cmath>

#include "parapet/designs/error.hpp"
#include "parapet/study/comparable.hpp"
#include "trade_off.hpp"

namespace parapet::test {
namespace {

using study::Choice;
using study::parse_pick_rule;

class Pick : public TradeOff {
 protected:
  std::string first(const study::PickRule& rule = {}) const {
    const Choice choice = study::choose(study_, rule);
    return choice.ranked.empty() ? "none" : choice.ranked.front().design->id;
  }
};

TEST_F(Pick, KneeIsTheDefaultAndTheFrontHoldsOnlyWhatCounts) {
  add_front();
  const Choice choice = study::choose(study_, {});
  EXPECT_EQ(choice.kind, study::RuleKind::knee);
  std::vector<std::string> front;
  for (const study::Candidate& candidate : choice.front) front.push_back(candidate.design->id);
  EXPECT_EQ(front, (std::vector<std::string>{"0001", "0002", "0003", "0004"}));
  EXPECT_EQ(choice.ranked.front().design->id, "0002");
  // Scaled: 0002 is at (0.05 / 0.45, 0.10 / 0.28), so 1 - 0.111 - 0.357 over sqrt 2 off the line.
  const double distance = (1.0 - 0.05 / 0.45 - 0.10 / 0.28) / std::sqrt(2.0);
  EXPECT_NEAR(choice.front[1].score, -distance, 1e-12) << "rounding only";
  EXPECT_EQ(choice.knee->ends, (std::vector<std::size_t>{0, 3}));
}

TEST_F(Pick, AStraightFrontIsBalanced) {
  add(0.20, 30.0, 0.90, 0.30);
  add(0.18, 20.0, 0.80, 0.21);
  add(0.15, 20.0, 0.68, 0.08);
  add(0.12, 10.0, 0.60, 0.00);
  const Choice choice = study::choose(study_, {});
  EXPECT_TRUE(choice.no_knee);
  EXPECT_EQ(choice.kind, study::RuleKind::balanced);
  // Scaled: 0002 is at (0.33, 0.7), 0003 at (0.73, 0.27).
  EXPECT_EQ(choice.ranked.front().design->id, "0002");
  EXPECT_FALSE(study::choose(study_, parse_pick_rule("balanced", "", {})).no_knee)
      << "nobody asked for a knee";
}

TEST_F(Pick, WeightsAreOverTheRangesOfTheFront) {
  add_front();
  // Reach alone: its end. Retention ten times as much: its end. Names of objectives or metrics.
  EXPECT_EQ(first(parse_pick_rule("", "reach_m=1", {})), "0004");
  EXPECT_EQ(first(parse_pick_rule("", "launch_length_m=1,retention_efficiency=10", {})), "0001");
  const Choice even =
      study::choose(study_, parse_pick_rule("", "reach_m=1,retention_efficiency=1", {}));
  EXPECT_EQ(even.ranked.front().design->id, "0002");
  EXPECT_NEAR(even.front[1].score, 0.05 / 0.45 + 0.10 / 0.28, 1e-12) << "rounding only";
}

TEST_F(Pick, LimitsTakeTheBestFirstObjectiveWithin) {
  add_front();
  estimate({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  const Choice choice = study::choose(study_, parse_pick_rule("limits", "", {"reach_m<=0.11"}));
  ASSERT_EQ(choice.ranked.size(), 2U);
  EXPECT_EQ(choice.ranked.front().design->id, "0003");
  // One standard deviation (0.01) within the limit: Phi(1), interval given to four digits.
  EXPECT_NEAR(choice.ranked.front().probability_limits.value(), 0.8413, 2e-4);
  EXPECT_EQ(first(parse_pick_rule("limits", "", {"reach_m<=0.01"})), "none");
}

TEST_F(Pick, RuleBestIsTheSpecsWeightedSum) {
  add_front();
  // reach - retention: 0002 has -0.78, the least among the feasible fine designs.
  EXPECT_EQ(first(parse_pick_rule("best", "", {})), "0002");
}

TEST_F(Pick, NamesAnUnknownObjective) {
  add_front();
  try {
    first(parse_pick_rule("", "reach=1", {}));
    FAIL() << "the name went unseen";
  } catch (const designs::InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("--weights"), std::string::npos) << said;
    EXPECT_NE(said.find("retention_efficiency and reach_m"), std::string::npos) << said;
  }
}

TEST_F(Pick, OneObjectiveHasNoKnee) {
  add_front();
  study_.spec.objectives.pop_back();
  for (records::EvaluationRecord& record : study_.designs) record.objectives.pop_back();
  EXPECT_THROW(first(parse_pick_rule("knee", "", {})), designs::InputError);
  EXPECT_EQ(study::choose(study_, {}).kind, study::RuleKind::best);
}

TEST_F(Pick, WhatTheSurrogateDoubtsComesLast) {
  add_front();
  estimate({{"0001", 0.9}, {"0002", 0.3}, {"0003", 0.6}, {"0004", 0.9}});
  const Choice choice = study::choose(study_, {});
  EXPECT_EQ(choice.ranked.back().design->id, "0002");
  EXPECT_FALSE(choice.all_doubtful);
  estimate({{"0001", 0.2}, {"0002", 0.3}, {"0003", 0.1}, {"0004", 0.4}});
  EXPECT_EQ(first(), "0002") << "the rule decides where all are doubtful";
  EXPECT_TRUE(study::choose(study_, {}).all_doubtful);
}

TEST_F(Pick, ARefutedOneGivesWayToTheNext) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.90, 0.12, 120.0);
  const Choice choice = study::choose(study_, {});
  const study::ConfirmedPick confirmed = study::confirmed_pick(study_, choice);
  ASSERT_EQ(confirmed.refuted.size(), 1U);
  EXPECT_EQ(confirmed.refuted.front()->design->id, "0002");
  EXPECT_EQ(confirmed.pick, &choice.ranked[1]);
  EXPECT_EQ(confirmed.verdict, study::Verdict::none) << "the next was not simulated again";
}

TEST(ProbabilityWithin, TakesEachSideAsHalfOfANormal) {
  const study::Estimate skewed{.median = 1.0, .lower_95 = 0.804, .upper_95 = 1.98};
  // s.d. 0.1 below and 0.5 above: Phi(-1) up to 0.9, Phi(1) up to 1.5; s.d. given to four digits.
  EXPECT_NEAR(*study::probability_within(skewed, {"", {}, 0.9}), 0.1587, 1e-4);
  EXPECT_NEAR(*study::probability_within(skewed, {"", {}, 1.5}), 0.8413, 1e-4);
  EXPECT_NEAR(*study::probability_within(skewed, {"", 0.9, 1.5}), 0.6827, 1e-4);
  const study::Estimate exact{.median = 1.0, .lower_95 = 1.0, .upper_95 = 1.0};
  EXPECT_EQ(study::probability_within(exact, {"", {}, 1.0}), 1.0);
  EXPECT_EQ(study::probability_within(exact, {"", {}, 0.9}), 0.0);
  EXPECT_FALSE(study::probability_within({}, {"", {}, 1.0}).has_value());
}

class Comparable : public TradeOff {};

TEST_F(Comparable, TheFinestSpacingThatWasUsedCounts) {
  add(0.15, 20.0, 0.6, 0.1, 50.0, 0.02);
  EXPECT_EQ(study::counted_spacing(study_), 0.02) << "nothing at 0.01 yet";
  add(0.15, 20.0, 0.6, 0.1, 50.0, 0.01);
  EXPECT_EQ(study::counted_spacing(study_), 0.01);
  ASSERT_EQ(study::comparable_designs(study_).size(), 1U);
  study_.designs.back().objective_scalar.reset();
  EXPECT_TRUE(study::comparable_designs(study_).empty());
}

TEST_F(Comparable, ViolationsAreOverTheirScales) {
  add(0.15, 20.0, 0.6, 0.1, 150.0);
  add(0.15, 25.0, 0.6, 0.1, 120.0);
  EXPECT_NEAR(study::violation(study_.spec, study_.designs[0]), 0.5, 1e-12) << "100 is the scale";
  study_.designs.push_back(study_.designs[0]);
  study_.designs.back().constraints[0].value.reset();
  study_.designs.back().constraints[0].margin.reset();
  EXPECT_EQ(study::violation(study_.spec, study_.designs[2]), 1.0) << "a value is asked for";
  const auto ranked = study::ranked_designs(study_, false);
  ASSERT_EQ(ranked.size(), 3U);
  EXPECT_EQ(ranked.front()->id, "0002") << "least outside";
}

}  // namespace
}  // namespace parapet::test
