// Advice from studies with several objectives, choices, scenarios and confirmations.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "parapet/reports/recommendation_json.hpp"
#include "parapet/reports/recommendation_text.hpp"
#include "parapet/reports/study_plots.hpp"
#include "trade_off.hpp"

namespace parapet::reports {
namespace {

using study::parse_pick_rule;

class Advice : public test::TradeOff {
 protected:
  Recommendation recommended(const study::PickRule& rule = {}) const {
    return recommend(study_, rule);
  }

  static std::string id(const Recommendation& result) {
    return result.recommended ? result.recommended->design.id : "none";
  }

  static bool says(const Recommendation& result, const std::string& words) {
    return recommendation_text(result).find(words) != std::string::npos;
  }
};

TEST_F(Advice, NamesTheKneeAndTheEndsOfTheFront) {
  add_front();
  const Recommendation result = recommended();
  ASSERT_EQ(result.front.size(), 4U);
  EXPECT_EQ(result.front[3].id, "0004");
  EXPECT_EQ(result.rule.kind, study::RuleKind::knee);
  EXPECT_EQ(id(result), "0002");
  EXPECT_TRUE(says(result, "The knee of the front")) << recommendation_text(result);
  EXPECT_TRUE(says(result, "0001 and 0004")) << "the ends are named";
}

TEST_F(Advice, OptionsAndStatisticsStandInWords) {
  add_front();
  const Recommendation result = recommended();
  const WrittenDesign& design = result.recommended->design.design;
  ASSERT_EQ(design.size(), 2U);
  EXPECT_EQ(std::get<double>(design[0].value), 0.18);
  EXPECT_EQ(std::get<std::string>(design[1].value), "none");
  EXPECT_EQ(result.study.objectives[1].statistic, "worst of the scenarios");
  EXPECT_TRUE(says(result, "**height 0.18 m and deflector none** (design 0002)"))
      << recommendation_text(result);
  EXPECT_TRUE(says(result, "reach, worst of the scenarios [m]"));
  EXPECT_TRUE(says(result, "2 scenarios, with their weights: soft (0.5) and stiff (0.5)"));
  EXPECT_TRUE(says(result, "in every scenario"));
  EXPECT_TRUE(says(result, "'{\"height_m\":0.18,\"deflector\":\"none\"}'"))
      << "the command takes options by name";
}

TEST_F(Advice, LeavingTheKneeHasItsPrice) {
  add_front();
  const std::vector<WayOut> leaving = recommended().leaving;
  ASSERT_EQ(leaving.size(), 2U);
  EXPECT_EQ(leaving[0].next.id, "0001");
  EXPECT_NEAR(leaving[0].next.changes[0], 0.05, 1e-12);
  EXPECT_NEAR(leaving[0].next.changes[1], 0.18, 1e-12);
  EXPECT_EQ(leaving[1].next.id, "0003");
  EXPECT_EQ(leaving[1].best.id, "0004");
}

TEST_F(Advice, SaysTheRuleInWords) {
  add_front();
  EXPECT_TRUE(says(recommended(parse_pick_rule("", "reach_m=1,retention_efficiency=1", {})),
                   "least weighted sum is taken (weights: reach 1 and retention efficiency 1)"));
  EXPECT_TRUE(says(recommended(parse_pick_rule("", "reach_m=1", {})), "; 0 for the others"));
  EXPECT_TRUE(says(recommended(parse_pick_rule("best", "", {})), "the spec's own weights"));
}

TEST_F(Advice, LimitsHaveAProbability) {
  add_front();
  estimate({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  const Recommendation result = recommended(parse_pick_rule("limits", "", {"reach_m<=0.11"}));
  EXPECT_EQ(id(result), "0003");
  // One standard deviation (0.01) within the limit: Phi(1), interval given to four digits.
  EXPECT_NEAR(result.recommended->probability_limits.value(), 0.8413, 2e-4);
  EXPECT_TRUE(says(result, "has a probability of 84 %")) << recommendation_text(result);
}

TEST_F(Advice, LimitsThatNothingMeetsShowTheFront) {
  add_front();
  const Recommendation none = recommended(parse_pick_rule("limits", "", {"reach_m<=0.01"}));
  EXPECT_FALSE(none.recommended.has_value());
  EXPECT_FALSE(none.least_violating.has_value());
  EXPECT_TRUE(none.rule.allows_none);
  EXPECT_TRUE(says(none, "but none of them the rule's limits")) << recommendation_text(none);
  EXPECT_TRUE(says(none, "## The trade-off")) << "the front shows what can be had";
}

TEST_F(Advice, EstimatesStandBesideWhatWasSimulated) {
  add_front();
  estimate({{"0002", 0.9}, {"0003", 0.6}});
  const Recommendation result = recommended();
  ASSERT_EQ(result.recommended->estimates.size(), 2U);
  EXPECT_EQ(result.recommended->estimates[1].estimate.median, 0.12);
  EXPECT_EQ(result.recommended->probability_feasible, 0.9);
  EXPECT_FALSE(result.front[0].probability_feasible.has_value());
  EXPECT_TRUE(says(result, "| 0.12 (0.1004 to 0.1396) |")) << recommendation_text(result);
  EXPECT_TRUE(says(result, "within the interval"));
}

TEST_F(Advice, SaysThatAllAreDoubtful) {
  add_front();
  estimate({{"0001", 0.2}, {"0002", 0.3}, {"0003", 0.1}, {"0004", 0.4}});
  EXPECT_TRUE(says(recommended(), "No design that the rule allows reaches 50 %"));
}

TEST_F(Advice, AConfirmedPickStatesItsScatter) {
  add_front();
  confirm("0002", "near-2", study::confirmation_stage::near, 0.88, 0.10, 70.0);
  confirm("0002", "near-1", study::confirmation_stage::near, 0.92, 0.14, 60.0);
  const Recommendation result = recommended();
  ASSERT_TRUE(result.confirmation.has_value());
  EXPECT_EQ(result.confirmation->verdict, study::Verdict::confirmed);
  EXPECT_EQ(result.confirmation->runs[0].id, "0002-near-1") << "by id, not as they ended";
  ASSERT_EQ(result.confirmation->spread.size(), 3U) << "two objectives and the load";
  const Spread& spread = result.confirmation->spread[0];
  EXPECT_EQ(spread.least, 0.88);
  EXPECT_EQ(spread.greatest, 0.92);
  EXPECT_EQ(spread.runs, 3);
  EXPECT_NEAR(spread.standard_deviation, 0.02, 1e-12);  // of 0.90, 0.92, 0.88
  EXPECT_TRUE(says(result, "**Confirmed by 2 further runs**")) << recommendation_text(result);
}

TEST_F(Advice, ARunOutsideTheRulesLimitsIsSaid) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.92, 0.14, 60.0);
  confirm("0002", "near-2", study::confirmation_stage::near, 0.88, 0.10, 70.0);
  const Recommendation result = recommended(parse_pick_rule("", "", {"reach_m<=0.13"}));
  EXPECT_EQ(id(result), "0002");
  EXPECT_TRUE(says(result, "0002-near-1 lies outside")) << recommendation_text(result);
}

TEST_F(Advice, ARefutedPickGivesWayToTheNext) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.90, 0.12, 120.0);
  confirm("0002", "near-2", study::confirmation_stage::near, 0.90, 0.12, 130.0);
  const Recommendation result = recommended();
  EXPECT_NE(id(result), "0002");
  EXPECT_EQ(result.confirmation->verdict, study::Verdict::none)
      << "the next was not simulated again";
  ASSERT_EQ(result.confirmation->refuted.size(), 1U);
  EXPECT_EQ(result.confirmation->refuted[0].id, "0002");
  EXPECT_EQ(result.confirmation->refuted[0].violated, std::vector<std::string>{"load"});
  EXPECT_TRUE(says(result, "load was violated")) << recommendation_text(result);
}

TEST_F(Advice, ThreeRefutedPicksAreSaidToBeSo) {
  add_front();
  for (const char* one : {"0001", "0002", "0003", "0004"}) {
    confirm(one, "near-1", study::confirmation_stage::near, 0.90, 0.12, 120.0);
  }
  const Recommendation result = recommended();
  EXPECT_EQ(id(result), "0002");
  EXPECT_EQ(result.confirmation->verdict, study::Verdict::refuted);
  EXPECT_EQ(result.confirmation->refuted.size(), 3U);
  EXPECT_TRUE(says(result, "**Not confirmed**: the 3 designs tried"));
  EXPECT_TRUE(says(result, "did not hold"));
}

TEST(Verdict, CountsNearDesignsAndSpacingsApart) {
  const auto verdict = [](const std::vector<study::ConfirmationRun>& runs) {
    return study::verdict_of("0007", runs);
  };
  using namespace study::confirmation_stage;
  EXPECT_EQ(verdict({}), study::Verdict::none);
  EXPECT_EQ(verdict({{"00070-near-1", near, false}}), study::Verdict::none) << "another design's";
  EXPECT_EQ(verdict({{"0007-near-1", near, false}, {"0007-near-2", near, true}}),
            study::Verdict::confirmed);
  EXPECT_EQ(verdict({{"0007-near-1", near, false}}), study::Verdict::refuted);
  EXPECT_EQ(verdict({{"0007-near-1", near, true}, {"0007-5mm", spacing, false}}),
            study::Verdict::refuted);
  EXPECT_EQ(verdict({{"0007-finest", finest, true}}), study::Verdict::confirmed);
}

TEST_F(Advice, DrawsTheFrontAndTheProgress) {
  add_front();
  estimate({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  const Recommendation result = recommended();
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("parapet_advice_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto drawn = draw_study_plots(folder, result);
  EXPECT_EQ(drawn, (std::vector<std::string>{"front.png", "hypervolume.png"}));
  for (const std::string& file : drawn) {
    std::string magic(4, ' ');
    std::ifstream(folder / file, std::ios::binary).read(magic.data(), 4);
    EXPECT_EQ(magic, "\x89PNG") << file;
    EXPECT_TRUE(says(result, "(" + file + ")"));
  }
  std::filesystem::remove_all(folder);
}

TEST_F(Advice, NothingFeasibleGivesNoFront) {
  add(0.16, 35.0, 0.99, 0.01, 150.0);
  const Recommendation result = recommended();
  EXPECT_FALSE(result.recommended.has_value());
  EXPECT_TRUE(result.front.empty());
  EXPECT_EQ(result.least_violating.value().design.id, "0001");
  EXPECT_TRUE(draw_study_plots("nowhere", result).empty());
}

TEST_F(Advice, TellsWhichVariablesMatter) {
  add_front();
  const study::SobolIndex index{.value = 0.62, .lower_95 = 0.5, .upper_95 = 0.7};
  const study::MainEffect choice{
      .at = {"none", "plate"}, .mean = {0.7, 0.8}, .lower_95 = {}, .upper_95 = {}};
  const study::MainEffect curve{
      .at = {0.1, 0.15, 0.18, 0.2}, .mean = {0.7, 0.6, 0.8, 0.75}, .lower_95 = {}, .upper_95 = {}};
  study_.sensitivity = study::Sensitivity{
      .study_name = "two ends",
      .spec_hash = "0123456789abcdef",
      .source = "surrogates.json",
      .domain = "the box",
      .realisations = 24,
      .base_points = 1024,
      .metrics = {
          {.name = "retention_efficiency",
           .metric = "retention_efficiency",
           .statistic = "",
           .designs = 40,
           .q_squared = 0.8,
           .varies = true,
           .variables = {{"deflector", index, index, choice}, {"height_m", index, index, curve}}}}};
  const Recommendation result = recommended();
  EXPECT_TRUE(says(result, "| deflector | 0.62 (0.50 to 0.70) |")) << recommendation_text(result);
  EXPECT_TRUE(says(result, "0.7 with none and 0.8 with plate"));
  EXPECT_TRUE(says(result, "0.7 at 0.1 m, 0.6 at 0.15 m, 0.8 at 0.18 m and 0.75 at 0.2 m"));
  EXPECT_EQ(recommendation_json(result)["sensitivity"], to_json(*study_.sensitivity));
}

TEST_F(Advice, IsWrittenAsJson) {
  add_front();
  estimate({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  confirm("0002", "near-1", study::confirmation_stage::near, 0.92, 0.14, 60.0);
  const designs::Json json =
      recommendation_json(recommended(parse_pick_rule("", "", {"reach_m<=0.13"})));
  EXPECT_EQ(json["rule"]["limits"].dump(),
            R"([{"objective":"reach_m","lower":null,"upper":0.13}])");
  EXPECT_EQ(json["confirmation"]["verdict"], "confirmed");
  EXPECT_EQ(json["confirmation"]["runs"][0]["objectives"].dump(), "[0.92,0.14]");
  EXPECT_EQ(json["front"][0]["design"].dump(),
            R"({"height_m":0.2,"deflector":"plate","angle_deg":30.0})");
  EXPECT_EQ(json["front"][0]["within_limits"], false);
  EXPECT_EQ(json["front"][0]["objectives"][1]["statistic"], "worst of the scenarios");
  EXPECT_EQ(json["leaving"][0]["next"]["id"], "0001");
  EXPECT_EQ(json["hypervolume"]["reference"].dump(), "[0.4,0.4]");
  EXPECT_EQ(json["hypervolume"]["history"][1]["hypervolume"], 0.2);
  EXPECT_TRUE(json["effects"].empty()) << "there is no fit over options";
  EXPECT_EQ(json["study"]["scenarios"][1]["name"], "stiff");
  EXPECT_EQ(json["study"]["variables"][1]["options"].dump(), R"(["none","plate"])");
  EXPECT_FALSE(json["alternatives"][0].contains("within_scatter"));
}

}  // namespace
}  // namespace parapet::reports
