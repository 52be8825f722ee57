// Advice from studies with several objectives, choices, scenarios and confirmations.
#include <cmath>

#include "parapet/designs/error.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/reports/recommendation.hpp"
#include "parapet/study/confirmation.hpp"
#include "scratch_folder.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

/// Retention is to be maximised and the launch length minimised; the force has a limit of 100 N/m.
/// A deflector has an angle, or there is none.
class TradeOff : public ScratchFolder {
 protected:
  TradeOff() {
    const Json spec = Json::parse(R"({
      "name": "two ends",
      "variables": {
        "height_m": {"lower": 0.1, "upper": 0.2, "targets": []},
        "deflector": {"type": "choice", "options": {"none": {}, "plate": {}}},
        "angle_deg": {"lower": 0, "upper": 60, "active_when": {"deflector": ["plate"]}}},
      "objectives": [
        {"name": "retention_efficiency", "metric": "retention_efficiency", "goal": "maximize",
         "statistic": "mean"},
        {"name": "reach_m", "metric": "launch_length_m", "goal": "minimize",
         "statistic": "worst"}],
      "constraints": [{"name": "load", "metric": "barrier_1_peak_force_n_per_m", "upper": 100,
                       "statistic": "worst"}],
      "scenarios": [{"name": "soft", "weight": 0.5}, {"name": "stiff", "weight": 0.5}],
      "fidelity": {"spacings_m": [0.01, 0.02]},
      "method": {"algorithm": "BAYESIAN", "max_evaluations": 9, "seed": 5}})");
    write(folder_ / "study.json", Json{{"format", "parapet-study-state/1"},
                                       {"spec", spec},
                                       {"spec_hash", "0123456789abcdef"},
                                       {"provenance", {{"program_version", "9.9.9"}}}}
                                      .dump());
  }

  records::EvaluationRecord record(double height, std::optional<double> angle, double retention,
                                   double reach, double force, double spacing) {
    records::EvaluationRecord record;
    record.stage = "search";
    record.design = {{"height_m", height}, {"deflector", angle ? 1.0 : 0.0}};
    if (angle) record.design["angle_deg"] = *angle;
    record.options = {{"deflector", angle ? "plate" : "none"}};
    record.ok = true;
    record.metrics = {{"retention_efficiency", retention, ""},
                      {"launch_length_m", reach, ""},
                      {"barrier_1_peak_force_n_per_m", force, ""}};
    record.objectives = {{"retention_efficiency", designs::Goal::maximize, 1.0, retention, false},
                         {"reach_m", designs::Goal::minimize, 1.0, reach, false}};
    record.objective_scalar = reach - retention;
    record.constraints = {{"load", force, std::nullopt, 100.0, force <= 100.0, 100.0 - force}};
    record.feasible = force <= 100.0;
    record.spacing = spacing;
    for (const char* name : {"soft", "stiff"}) {
      record.scenarios.push_back(
          {.name = name, .weight = 0.5, .ok = true, .reason = "", .metrics = record.metrics});
    }
    return record;
  }

  void add(double height, std::optional<double> angle, double retention, double reach,
           double force = 50.0, double spacing = 0.01) {
    records::EvaluationRecord one = record(height, angle, retention, reach, force, spacing);
    one.id = records::evaluation_id(++count_);
    log_ += to_json(one).dump() + "\n";
  }

  /// The front 0001 (0.95, 0.30), 0002 (0.90, 0.12), 0003 (0.60, 0.10), 0004 (0.50, 0.02), and
  /// designs that must never be taken: dominated, infeasible, coarse.
  void add_front() {
    add(0.20, 30.0, 0.95, 0.30);
    add(0.18, std::nullopt, 0.90, 0.12);
    add(0.15, 20.0, 0.60, 0.10);
    add(0.12, 10.0, 0.50, 0.02);
    add(0.17, 25.0, 0.85, 0.20);              // 0005: dominated by 0002
    add(0.16, 35.0, 0.99, 0.01, 150.0);       // 0006: best in all, breaks the limit
    add(0.14, 15.0, 0.99, 0.01, 50.0, 0.02);  // 0007: best in all, but coarse
  }

  void confirm(const std::string& pick, const std::string& role, const std::string& stage,
               double retention, double reach, double force) {
    records::EvaluationRecord one = record(0.18, std::nullopt, retention, reach, force, 0.01);
    one.id = pick + "-" + role;
    one.stage = stage;
    confirmations_ += to_json(one).dump() + "\n";
  }

  /// pareto.json with an estimate at the observed values, s.d. 0.01, and these probabilities.
  void write_pareto(const std::map<std::string, double>& probabilities) {
    Json json{{"format", "parapet-pareto/1"},
              {"spec_hash", "0123456789abcdef"},
              {"hypervolume", 0.2},
              {"designs", Json::array()}};
    json["objectives"] = {{{"name", "retention_efficiency"}, {"reference", 0.4}},
                          {{"name", "reach_m"}, {"reference", 0.4}}};
    json["history"] = {{{"evaluations", 1}, {"cpu_time_s", 1.0}, {"hypervolume", 0.1}},
                       {{"evaluations", 2}, {"cpu_time_s", 2.0}, {"hypervolume", 0.2}}};
    const std::map<std::string, std::pair<double, double>> values{{"0001", {0.95, 0.30}},
                                                                  {"0002", {0.90, 0.12}},
                                                                  {"0003", {0.60, 0.10}},
                                                                  {"0004", {0.50, 0.02}}};
    for (const auto& [id, probability] : probabilities) {
      Json objectives = Json::array();
      for (const double value : {values.at(id).first, values.at(id).second}) {
        objectives.push_back({{"value", value},
                              {"estimate", value},
                              {"lower_95", value - 0.0196},
                              {"upper_95", value + 0.0196}});
      }
      json["designs"].push_back(
          {{"id", id}, {"objectives", objectives}, {"probability_feasible", probability}});
    }
    write(folder_ / "pareto.json", json.dump());
  }

  Recommendation recommended(const study::PickRule& rule = {}) {
    write(folder_ / "evaluations.jsonl", log_);
    if (!confirmations_.empty()) write(folder_ / "confirmations.jsonl", confirmations_);
    return recommend(folder_, rule);
  }

  static bool says(const Recommendation& result, const std::string& words) {
    return result.markdown.find(words) != std::string::npos;
  }

  std::string log_, confirmations_;
  int count_ = 0;
};

TEST_F(TradeOff, KneeIsTheDefaultAndTheFrontHoldsOnlyWhatCounts) {
  add_front();
  const Recommendation result = recommended();
  std::vector<std::string> front;
  for (const Json& design : result.json["front"]) front.push_back(design["id"]);
  EXPECT_EQ(front, (std::vector<std::string>{"0001", "0002", "0003", "0004"}));
  EXPECT_EQ(result.json["rule"]["name"], "knee");
  EXPECT_EQ(result.json["recommended"]["id"], "0002");
  // Scaled: 0002 is at (0.05 / 0.45, 0.10 / 0.28), so 1 - 0.111 - 0.357 over sqrt 2 off the line.
  const double distance = (1.0 - 0.05 / 0.45 - 0.10 / 0.28) / std::sqrt(2.0);
  EXPECT_NEAR(result.json["front"][1]["score"].get<double>(), -distance, 1e-12);
  EXPECT_TRUE(says(result, "The knee of the front")) << result.markdown;
  EXPECT_TRUE(says(result, "0001 and 0004")) << "the ends are named";
}

TEST_F(TradeOff, OptionsAndStatisticsStandInWords) {
  add_front();
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["recommended"]["design"],
            Json({{"height_m", 0.18}, {"deflector", "none"}}));
  EXPECT_TRUE(says(result, "**height 0.18 m and deflector none** (design 0002)"))
      << result.markdown;
  EXPECT_TRUE(says(result, "reach, worst of the scenarios [m]"));
  EXPECT_TRUE(says(result, "2 scenarios, with their weights: soft (0.5) and stiff (0.5)"));
  EXPECT_TRUE(says(result, "in every scenario"));
  EXPECT_TRUE(says(result, "'{\"height_m\":0.18,\"deflector\":\"none\"}'"))
      << "the command takes options by name";
}

TEST_F(TradeOff, LeavingTheKneeHasItsPrice) {
  add_front();
  const Json leaving = recommended().json["leaving"];
  ASSERT_EQ(leaving.size(), 2U);
  EXPECT_EQ(leaving[0]["next"]["id"], "0001");
  EXPECT_NEAR(leaving[0]["next"]["changes"][0].get<double>(), 0.05, 1e-12);
  EXPECT_NEAR(leaving[0]["next"]["changes"][1].get<double>(), 0.18, 1e-12);
  EXPECT_EQ(leaving[1]["next"]["id"], "0003");
  EXPECT_EQ(leaving[1]["best"]["id"], "0004");
}

TEST_F(TradeOff, WeightsAreOverTheRangesOfTheFront) {
  add_front();
  // Reach alone: its end. Retention ten times as much: its end. Names of objectives or metrics.
  EXPECT_EQ(recommended(study::parse_pick_rule("", "reach_m=1", {})).json["recommended"]["id"],
            "0004");
  EXPECT_EQ(recommended(study::parse_pick_rule("", "launch_length_m=1,retention_efficiency=10", {}))
                .json["recommended"]["id"],
            "0001");
  const Recommendation even =
      recommended(study::parse_pick_rule("", "reach_m=1,retention_efficiency=1", {}));
  EXPECT_EQ(even.json["recommended"]["id"], "0002");
  EXPECT_NEAR(even.json["front"][1]["score"].get<double>(), 0.05 / 0.45 + 0.10 / 0.28, 1e-12);
  EXPECT_TRUE(says(even, "least weighted sum"));
}

TEST_F(TradeOff, LimitsTakeTheBestFirstObjectiveWithin) {
  add_front();
  write_pareto({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  const Recommendation result =
      recommended(study::parse_pick_rule("limits", "", {"reach_m<=0.11"}));
  EXPECT_EQ(result.json["recommended"]["id"], "0003");
  // One standard deviation (0.01) within the limit: Phi(1), interval given to four digits.
  EXPECT_NEAR(result.json["recommended"]["probability_limits"].get<double>(), 0.8413, 2e-4);
  EXPECT_TRUE(says(result, "has a probability of 84 %")) << result.markdown;

  const Recommendation none = recommended(study::parse_pick_rule("limits", "", {"reach_m<=0.01"}));
  EXPECT_FALSE(none.feasible);
  EXPECT_TRUE(none.json["recommended"].is_null());
  EXPECT_TRUE(says(none, "but none of them the rule's limits")) << none.markdown;
  EXPECT_TRUE(says(none, "## The trade-off")) << "the front shows what can be had";
}

TEST_F(TradeOff, NamesAnUnknownObjective) {
  add_front();
  try {
    recommended(study::parse_pick_rule("", "reach=1", {}));
    FAIL() << "the name went unseen";
  } catch (const designs::InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("--weights"), std::string::npos) << said;
    EXPECT_NE(said.find("retention_efficiency and reach_m"), std::string::npos) << said;
  }
}

TEST_F(TradeOff, WhatTheSurrogateDoubtsComesLast) {
  add_front();
  write_pareto({{"0001", 0.9}, {"0002", 0.3}, {"0003", 0.6}, {"0004", 0.9}});
  const Recommendation result = recommended();
  EXPECT_NE(result.json["recommended"]["id"], "0002");
  EXPECT_GE(result.json["recommended"]["probability_feasible"].get<double>(), 0.5);
  EXPECT_FALSE(result.json["rule"]["all_doubtful"].get<bool>());

  write_pareto({{"0001", 0.2}, {"0002", 0.3}, {"0003", 0.1}, {"0004", 0.4}});
  const Recommendation doubtful = recommended();
  EXPECT_EQ(doubtful.json["recommended"]["id"], "0002")
      << "the rule decides where all are doubtful";
  EXPECT_TRUE(says(doubtful, "No design that the rule allows reaches 50 %"));
}

TEST_F(TradeOff, EstimatesOfAnotherSpecAreNotUsed) {
  add_front();
  write_pareto({{"0002", 0.3}});
  Json json = Json::parse(content(folder_ / "pareto.json"));
  json["spec_hash"] = "fedcba9876543210";
  write(folder_ / "pareto.json", json.dump());
  const Recommendation result = recommended();
  EXPECT_TRUE(result.json["recommended"]["probability_feasible"].is_null());
  EXPECT_EQ(result.json["recommended"]["id"], "0002");
}

TEST_F(TradeOff, AConfirmedPickStatesItsScatter) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.92, 0.14, 60.0);
  confirm("0002", "near-2", study::confirmation_stage::near, 0.88, 0.10, 70.0);
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["confirmation"]["verdict"], "confirmed");
  const Json spread = result.json["confirmation"]["spread"][0];
  EXPECT_EQ(spread["least"], 0.88);
  EXPECT_EQ(spread["greatest"], 0.92);
  EXPECT_NEAR(spread["standard_deviation"].get<double>(), 0.02, 1e-12);  // of 0.90, 0.92, 0.88
  EXPECT_TRUE(says(result, "**Confirmed**"));
}

TEST_F(TradeOff, ARunOutsideTheRulesLimitsIsSaid) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.92, 0.14, 60.0);
  confirm("0002", "near-2", study::confirmation_stage::near, 0.88, 0.10, 70.0);
  const Recommendation result = recommended(study::parse_pick_rule("", "", {"reach_m<=0.13"}));
  EXPECT_EQ(result.json["recommended"]["id"], "0002");
  EXPECT_TRUE(says(result, "0002-near-1 lies outside")) << result.markdown;
}

TEST_F(TradeOff, ARefutedPickGivesWayToTheNext) {
  add_front();
  confirm("0002", "near-1", study::confirmation_stage::near, 0.90, 0.12, 120.0);
  confirm("0002", "near-2", study::confirmation_stage::near, 0.90, 0.12, 130.0);
  const Recommendation result = recommended();
  EXPECT_NE(result.json["recommended"]["id"], "0002");
  EXPECT_EQ(result.json["confirmation"]["verdict"], "none") << "the next was not simulated again";
  EXPECT_EQ(result.json["confirmation"]["refuted"][0]["id"], "0002");
  EXPECT_TRUE(says(result, "load was violated")) << result.markdown;
}

TEST_F(TradeOff, ThreeRefutedPicksAreSaidToBeSo) {
  add_front();
  for (const char* id : {"0001", "0002", "0003", "0004"}) {
    confirm(id, "near-1", study::confirmation_stage::near, 0.90, 0.12, 120.0);
  }
  const Recommendation result = recommended();
  EXPECT_EQ(result.json["recommended"]["id"], "0002");
  EXPECT_EQ(result.json["confirmation"]["verdict"], "refuted");
  EXPECT_EQ(result.json["confirmation"]["refuted"].size(), 3U);
  EXPECT_TRUE(says(result, "**Not confirmed.**"));
  EXPECT_TRUE(says(result, "it did not hold"));
}

TEST(Verdict, CountsNearDesignsAndSpacingsApart) {
  const auto verdict = [](std::vector<study::ConfirmationRun> runs) {
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

TEST_F(TradeOff, DrawsTheFrontAndTheProgress) {
  add_front();
  write_pareto({{"0001", 0.9}, {"0002", 0.9}, {"0003", 0.9}, {"0004", 0.9}});
  const Recommendation result = recommended();
  const auto drawn = draw_study_plots(folder_, result.json);
  EXPECT_EQ(drawn, (std::vector<std::string>{"front.png", "hypervolume.png"}));
  for (const std::string& file : drawn) {
    EXPECT_TRUE(content(folder_ / file).starts_with("\x89PNG")) << file;
    EXPECT_TRUE(says(result, "(" + file + ")"));
  }
}

TEST_F(TradeOff, RuleBestIsTheSpecsWeightedSum) {
  add_front();
  // reach - retention: 0002 has -0.78, the least among the feasible fine designs.
  EXPECT_EQ(recommended(study::parse_pick_rule("best", "", {})).json["recommended"]["id"], "0002");
}

TEST_F(TradeOff, NothingFeasibleGivesNoFront) {
  add(0.16, 35.0, 0.99, 0.01, 150.0);
  const Recommendation result = recommended();
  EXPECT_FALSE(result.feasible);
  EXPECT_TRUE(result.json["front"].empty());
  EXPECT_EQ(result.json["least_violating"]["id"], "0001");
  EXPECT_TRUE(draw_study_plots(folder_, result.json).empty());
}

TEST_F(TradeOff, TellsWhichVariablesMatter) {
  add_front();
  const Json index{{"value", 0.62}, {"lower_95", 0.5}, {"upper_95", 0.7}};
  Json variable{{"name", "deflector"}, {"first", index}, {"total", index}};
  variable["main_effect"] = {{"at", {"none", "plate"}}, {"mean", {0.7, 0.8}}};
  const Json metric{{"metric", "retention_efficiency"},
                    {"designs", 40},
                    {"q_squared", 0.8},
                    {"varies", true},
                    {"variables", {variable}}};
  write(folder_ / "sensitivity.json", Json{{"format", "parapet-sensitivity/1"},
                                           {"spec_hash", "0123456789abcdef"},
                                           {"metrics", {metric}}}
                                          .dump());
  const Recommendation result = recommended();
  EXPECT_TRUE(says(result, "| deflector | 0.62 (0.50 to 0.70) |")) << result.markdown;
  EXPECT_TRUE(says(result, "0.7 with none and 0.8 with plate"));
}

}  // namespace
}  // namespace parapet::reports
