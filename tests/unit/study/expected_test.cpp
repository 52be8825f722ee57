// What a study says of a repeat: which runs count, at which spacing, and how ties are settled.
#include "parapet/study/expected.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "parapet/study/pick.hpp"
#include "parapet/study/predicted.hpp"
#include "taught_study.hpp"

namespace parapet::test {
namespace {

namespace stage = study::confirmation_stage;
using study::Expectation;
using study::Role;

const Expectation& of(const std::vector<Expectation>& list, Role role) {
  return *std::ranges::find(list, role, &Expectation::role);
}

TEST(Expected, RunsCountAtOneSpacing) {
  TaughtStudy taught({0.01, 0.02}, 0.5);
  const std::string id = taught.add(0.07, 30.0, 0.02, 0.80, 0.2);
  EXPECT_EQ(study::repeat_spacing(taught.study, taught.study.designs[0]), 0.02);
  taught.confirm(id, "near-1", stage::near, 0.01, 0.90, 0.25);
  taught.confirm(id, "near-2", stage::near, 0.01, 0.92, 0.27);
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[0]);
  EXPECT_EQ(study::repeat_spacing(taught.study, taught.study.designs[0]), 0.01);
  const study::RepeatEstimate retention = of(list, Role::objective).estimate.value();
  EXPECT_EQ(retention.runs, 2) << "the coarse run is no repeat of the fine ones";
  EXPECT_NEAR(retention.mean, 0.91, 1e-15);
  EXPECT_NEAR(retention.grid.value(), 0.11, 1e-15) << "the coarse run tells of the grid";
}

TEST(Expected, LoadsOfEachBarrierAreAmongThem) {
  TaughtStudy taught({0.01}, 0.5);
  const std::string id = taught.add(0.07, 30.0, 0.01, 0.90, 0.2);
  taught.confirm(id, "near-1", stage::near, 0.01, 0.92, 0.2);
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[0]);
  ASSERT_EQ(list.size(), 4U) << "objective, limit, force and moment";
  EXPECT_EQ(list[2].metric, "barrier_1_design_force_n_per_m");
  EXPECT_NEAR(list[2].estimate->mean, 910.0, 1e-9);
  EXPECT_EQ(list[3].place, 1U);
}

TEST(Expected, ProbabilityIsThatOfARepeat) {
  TaughtStudy taught({0.01}, 0.1);
  const std::string id = taught.add(0.07, 30.0, 0.01, 0.90, 0.0987);
  EXPECT_FALSE(
      study::probability_all_met(study::repeat_expectations(taught.study, taught.study.designs[0])))
      << "one run knows no scatter";
  taught.confirm(id, "near-1", stage::near, 0.01, 0.90, 0.0820);
  taught.confirm(id, "near-2", stage::near, 0.01, 0.90, 0.0990);
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[0]);
  EXPECT_NEAR(study::probability_all_met(list).value(), 0.70, 0.01) << "see repeat_test";
}

TEST(Expected, AbsentMetricsCountByTheirShareOfTheRuns) {
  TaughtStudy taught({0.01}, 0.1);
  const std::string id = taught.add(0.07, 30.0, 0.01, 0.90, 0.3);
  for (const char* role : {"near-1", "near-2"}) {
    taught.confirm(id, role, stage::near, 0.01, 0.90, 0.3);
  }
  const auto forget = [](records::EvaluationRecord& run) {
    solver::Metric& launch = run.metrics[1];
    launch.value.reset();
    launch.absence = solver::Absence::does_not_exist;
  };
  forget(taught.study.confirmations[1]);
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[0]);
  const Expectation& launch = of(list, Role::constraint);
  EXPECT_EQ(launch.absent, 1);
  // 0.3 twice without scatter never meets 0.1; where nothing lands, the limit is met.
  EXPECT_NEAR(launch.probability.value(), 1.0 / 3.0, 1e-12);
}

/// Retention rises with the height; the launch length falls with the angle. The noise is known.
TaughtStudy noisy_study() {
  TaughtStudy taught({0.01}, 0.3, 0.01, 0.01);
  for (int k = 0; k < 12; ++k) {
    const double s = k / 11.0, a = (7 * k % 12) / 11.0;
    taught.add(0.04 + 0.054 * s, 54.0 * a, 0.01, 0.6 + 0.2 * s, 0.29 - 0.2 * a);
  }
  return taught;
}

// The search models what is asked of it; the loads are modelled from its log.
TEST(Expected, LoadsHaveSurrogatesToo) {
  TaughtStudy taught = noisy_study();
  taught.teach();
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[6]);
  const study::RepeatEstimate force = of(list, Role::load).estimate.value();
  EXPECT_EQ(force.runs, 1);
  ASSERT_TRUE(force.lower_95().has_value()) << "one run of a design among twelve others";
  // 1000 times the retention, a straight line in the height without scatter.
  EXPECT_NEAR(force.mean, 1000.0 * (0.6 + 0.2 * 6.0 / 11.0), 10.0);
}

// Over a barrier that holds everything nothing lands; what the launch of other designs says of this
// one's is no estimate of it.
TEST(Expected, WhatNoRunOfTheDesignHasIsNotEstimatedFromOthers) {
  TaughtStudy taught = noisy_study();
  taught.teach();
  solver::Metric& launch = taught.study.designs[6].metrics[1];
  launch.value.reset();
  launch.absence = solver::Absence::does_not_exist;
  const auto list = study::repeat_expectations(taught.study, taught.study.designs[6]);
  const Expectation& limit = of(list, Role::constraint);
  EXPECT_EQ(limit.absent, 1);
  EXPECT_FALSE(limit.estimate.has_value());
  EXPECT_EQ(limit.probability, 1.0);
}

// Where two spacings agree by chance nothing has converged: the difference passes through 0 there.
TEST(Expected, GridUncertaintyIsThatOfTheStudyAtLeast) {
  TaughtStudy taught({0.01, 0.02}, 0.5, 0.002, 0.002);
  for (int k = 0; k < 24; ++k) {
    const double s = k % 12 / 11.0, a = (7 * k % 12) / 11.0;
    const bool fine = k < 12;
    const double change = fine ? 0.0 : 0.2 * (s - 0.5);
    taught.add(0.04 + 0.06 * s, 60.0 * a, fine ? 0.01 : 0.02, 0.6 + 0.2 * s + change, 0.1);
  }
  taught.teach();
  const study::Expectation middle =
      of(study::repeat_expectations(taught.study, taught.study.designs[5]), Role::objective);
  EXPECT_EQ(middle.estimate->grid_source, study::GridSource::levels);
  // At s = 0.45 the spacings differ by 0.01; over the study the root mean square is 0.063.
  EXPECT_NEAR(middle.estimate->grid.value(), 0.063, 0.01);
}

TEST(Surrogates, LeaveOneOutIntervalsHoldPossibleValues) {
  TaughtStudy taught({0.01}, 0.5);
  for (int k = 0; k < 12; ++k) {
    const double s = k / 11.0;
    // Half of the designs retain everything and throw nothing.
    taught.add(0.04 + 0.06 * s, 60.0 * (7 * k % 12) / 11.0, 0.01, std::min(1.0, 0.8 + 0.4 * s),
               std::max(0.0, 0.1 - 0.2 * s));
  }
  const designs::Json json = taught.teach();
  bool any_at_end = false;
  for (const designs::Json& metric : json["metrics"]) {
    const bool share = metric["metric"] == "retention_efficiency";
    for (const char* key : {"mean", "lower_95", "upper_95"}) {
      for (const designs::Json& one : metric["surrogate"]["leave_one_out"][key]) {
        const double value = one.get<double>();
        EXPECT_GE(value, 0.0) << metric["name"] << " " << key;
        EXPECT_TRUE(!share || value <= 1.0) << key;
        any_at_end = any_at_end || value == 0.0 || (share && value == 1.0);
      }
    }
  }
  EXPECT_TRUE(any_at_end) << "the normal distribution went beyond";
}

TEST(Ties, GoToTheDesignWithMoreMargin) {
  TaughtStudy taught = noisy_study();
  // 0.005 apart at a noise of 0.01: not to be told apart. The better one all but breaks the limit.
  const std::string better = taught.add(0.1, 0.0, 0.01, 0.815, 0.297);
  const std::string safer = taught.add(0.1, 60.0, 0.01, 0.810, 0.09);
  EXPECT_EQ(study::choose(taught.study, {}).ranked.front().design->id, better)
      << "without surrogates nothing is known of the uncertainty";
  taught.teach();
  const study::Choice choice = study::choose(taught.study, {});
  EXPECT_EQ(choice.draws, 512);
  EXPECT_EQ(choice.ranked.front().design->id, safer);
  const auto tied = [&](const std::string& id) {
    return id == choice.first_by_rule || std::ranges::count(choice.tied, id) > 0;
  };
  EXPECT_TRUE(tied(better));
  EXPECT_TRUE(tied(safer));
  EXPECT_FALSE(tied("0001")) << "0.2 behind";
}

TEST(Ties, AClearLeaderHasNone) {
  TaughtStudy taught = noisy_study();
  const std::string best = taught.add(0.1, 60.0, 0.01, 0.95, 0.09);
  taught.teach();
  const study::Choice choice = study::choose(taught.study, {});
  EXPECT_EQ(choice.ranked.front().design->id, best);
  EXPECT_TRUE(choice.tied.empty()) << choice.tied.front();
  EXPECT_GT(choice.ranked.front().share.value(), 0.95);
}

TEST(Predicted, AWorseRunRefutesAndABetterOneDoesNot) {
  TaughtStudy taught = noisy_study();
  taught.teach();
  const study::Choice choice = study::choose(taught.study, {});
  const study::Pick pick = study::pick_of(choice.ranked.front());
  const double mean = pick.predicted.at(0)->mean;
  const auto run = [&](const char* id, double retention) {
    records::EvaluationRecord one =
        taught.record(pick.id + id, pick.design.at("height_m"), pick.design.at("angle_deg"), 0.01,
                      retention, 0.1);
    one.stage = stage::near;
    return study::confirmation_run(taught.study.spec, pick, one);
  };
  // The noise is 0.01: 0.005 off is scatter, 0.2 is not.
  EXPECT_TRUE(run("-near-1", mean - 0.005).as_predicted);
  EXPECT_FALSE(run("-near-1", mean - 0.2).as_predicted);
  EXPECT_TRUE(run("-near-1", mean + 0.2).as_predicted);
  EXPECT_EQ(study::verdict_of(pick.id, {run("-near-1", mean - 0.2)}), study::Verdict::refuted);
  EXPECT_EQ(study::verdict_of(pick.id, {run("-near-1", mean)}), study::Verdict::confirmed);
}

TEST(Predicted, FormulasAloneConfirmNothing) {
  TaughtStudy taught({0.01}, 0.3);
  taught.add(0.07, 30.0, 0.01, 0.9, 0.1);
  taught.study.spec.constraints.clear();
  const study::Choice choice = study::choose(taught.study, {});
  const study::Pick pick = study::pick_of(choice.ranked.front());
  records::EvaluationRecord near = taught.record("0001-near-1", 0.07, 30.0, 0.01, 0.5, 0.1);
  near.stage = stage::near;
  const study::ConfirmationRun run = study::confirmation_run(taught.study.spec, pick, near);
  EXPECT_FALSE(run.tested);
  EXPECT_EQ(study::verdict_of("0001", {run}), study::Verdict::none);
}

/// A cost of the height and of the load, which falls with the retention; runs scatter by 0.0004.
TaughtStudy costed_study() {
  TaughtStudy taught({0.01}, 0.3, 0.01, 0.01);
  designs::Objective& cost = taught.study.spec.objectives.front();
  cost = {};
  cost.name = "cost_m";
  cost.goal = designs::Goal::minimize;
  cost.expression = cost.formula = "height_m + 0.04 * (1 - retention_efficiency)";
  cost.metrics = {"retention_efficiency"};
  for (int k = 0; k < 12; ++k) {
    const double s = k / 11.0, a = (7 * k % 12) / 11.0, scatter = k % 2 == 0 ? 0.01 : -0.01;
    taught.add(0.04 + 0.054 * s, 54.0 * a, 0.01, 0.6 + 0.2 * s + scatter, 0.1);
  }
  taught.teach();
  return taught;
}

TEST(Expected, AnExpressionOfMetricsIsNoExactFormula) {
  const TaughtStudy taught = costed_study();
  const study::Expectation cost =
      of(study::repeat_expectations(taught.study, taught.study.designs[6]), Role::objective);
  EXPECT_FALSE(cost.exact);
  const double truth = 0.04 + 0.054 * 6.0 / 11.0 + 0.04 * (0.4 - 0.2 * 6.0 / 11.0);
  ASSERT_TRUE(cost.estimate && cost.estimate->scatter);
  EXPECT_GT(*cost.estimate->scatter, 0.0);
  EXPECT_NEAR(cost.estimate->mean, truth, 3.0 * 0.0004) << "three deviations of a run";
}

// Half a per cent of the heights is 0.0003 m: of the cost that is no news, of the load it would be.
TEST(Predicted, OfAnExpressionTheLongerPlateOfANearDesignIsNoSurprise) {
  const TaughtStudy taught = costed_study();
  const study::Choice choice = study::choose(taught.study, {});
  const study::Pick pick = study::pick_of(choice.ranked.front());
  const double height = pick.design.at("height_m"), angle = pick.design.at("angle_deg");
  const records::EvaluationRecord& own = *choice.ranked.front().design;
  const double retention = own.metrics.front().value.value();
  const auto run = [&](double near_height, double near_retention) {
    records::EvaluationRecord one =
        taught.record(pick.id + "-near-1", near_height, angle, 0.01, near_retention, 0.1);
    one.stage = stage::near;
    return study::confirmation_run(taught.study.spec, pick, one).as_predicted;
  };
  EXPECT_TRUE(run(height + 0.01, retention)) << "0.01 m more plate, far beyond the scatter";
  EXPECT_FALSE(run(height, retention - 0.25)) << "0.01 m more by the load alone";
}

}  // namespace
}  // namespace parapet::test
