// Terms, and expressions of metrics: what they stand for, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "study_fixture.hpp"
#include "study_parts.hpp"
#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

/// plate, a term of it, a cost of plate and moment, and the launch beside it.
Json cost_study() {
  Json study = sound_study();
  study["terms"] = Json::parse(R"json({
    "all_plate_m": "upstream_height_m + plate_m",
    "doubled_m": "2 * all_plate_m",
    "spill": {"expression": "launch_length_m / 0.4 + exp(0 * 1e-3)",
              "values_when_absent": {"launch_length_m": 0}}})json");
  study["objectives"] = Json::parse(R"([
    {"name": "cost", "goal": "minimize", "statistic": "worst",
     "expression": "2400 * doubled_m + 15 * barrier_1_design_moment_nm_per_m - spill"},
    {"name": "plate", "expression": "all_plate_m", "goal": "minimize"}])");
  study["constraints"] = Json::parse(R"json([
    {"name": "reach", "expression": "launch_length_m + landing_speed_m_s", "upper": 2,
     "values_when_absent": {"launch_length_m": 0, "landing_speed_m_s": 0.5}}])json");
  return study;
}

// Each use of a term is its expression in brackets, terms of terms included; the metrics of all and
// the values that terms give are the goal's.
TEST(StudyTerms, AreWrittenOut) {
  const StudySpec study = parse_study(cost_study(), "s");
  ASSERT_EQ(study.terms.size(), 3U);
  EXPECT_EQ(study.terms[1].name, "doubled_m");
  EXPECT_EQ(study.terms[1].formula, "2 * (upstream_height_m + plate_m)");
  EXPECT_TRUE(study.terms[1].metrics.empty());
  const Objective& cost = study.objectives[0];
  EXPECT_EQ(cost.formula,
            "2400 * (2 * (upstream_height_m + plate_m)) + 15 * barrier_1_design_moment_nm_per_m - "
            "(launch_length_m / 0.4 + exp(0 * 1e-3))");
  EXPECT_EQ(cost.metrics,
            (std::vector<std::string>{"barrier_1_design_moment_nm_per_m", "launch_length_m"}));
  EXPECT_EQ(cost.values_when_absent, (std::map<std::string, double>{{"launch_length_m", 0.0}}));
  EXPECT_FALSE(cost.is_of_design());
  EXPECT_TRUE(study.objectives[1].is_of_design());
  EXPECT_FALSE(study.constraints[0].is_of_design());
}

// What is resolved reads back as itself, and a study without terms resolves as before.
TEST(StudyTerms, ResolveToThemselves) {
  const StudySpec study = parse_study(cost_study(), "s");
  EXPECT_EQ(parse_study(study.resolved, "s").resolved, study.resolved);
  EXPECT_EQ(study.resolved["terms"]["doubled_m"], "2 * all_plate_m");
  const Json without = parse_study(sound_study(), "s").resolved;
  EXPECT_FALSE(without.contains("terms"));
  EXPECT_FALSE(without["objectives"][0].contains("values_when_absent"));
}

// The formula made ready gives what the plain one gives; division by zero is no value.
TEST(Formula, IsTheSameAsTheExpression) {
  const std::string text = "a * sin(b) + max(a, 2) / b";
  Formula formula(text, {"a", "b", "unused"});
  for (const double a : {0.5, 3.0}) {
    for (const double b : {0.25, -1.5}) {
      EXPECT_EQ(formula.value({a, b, 7.0}), evaluate_expression(text, {{"a", a}, {"b", b}}));
    }
  }
  EXPECT_FALSE(std::isfinite(formula.value({1.0, 0.0, 7.0})));
  EXPECT_THROW(Formula("a + c", {"a"}), InputError);
}

TEST(Names, AreFoundAndReplacedWhole) {
  EXPECT_EQ(names_in("2e3 * ab + a*cos(ab) - 1.5e-3"),
            (std::vector<std::string>{"ab", "a", "cos"}));
  EXPECT_EQ(with_names_replaced("a + ab - 1e3 * a", {{"a", "x + 1"}, {"e3", "wrong"}}),
            "(x + 1) + ab - 1e3 * (x + 1)");
}

const WrongInput wrong_terms[] = {
    {"UnknownSymbol",
     R"([{"op": "replace", "path": "/objectives/0/expression",
          "value": "barrier_1_design_momentum_nm_per_m + doubled_m"}])",
     "/objectives/0/expression", "did you mean \"barrier_1_design_moment_nm_per_m\"?",
     "plate_m, all_plate_m, doubled_m, spill, or of metrics of the case"},
    {"UnknownSymbolInATerm",
     R"([{"op": "replace", "path": "/terms/all_plate_m", "value": "upstream_heigth_m"}])",
     "/terms/all_plate_m", "did you mean \"upstream_height_m\"?", "a formula of"},
    {"UnknownSymbolInATermWithValues",
     R"([{"op": "replace", "path": "/terms/spill/expression", "value": "launch_lenght_m"}])",
     "/terms/spill/expression", "did you mean \"launch_length_m\"?", "a formula of"},
    {"TermThatUsesItself",
     R"([{"op": "replace", "path": "/terms/all_plate_m", "value": "all_plate_m + plate_m"}])",
     "/terms/all_plate_m", "uses itself: all_plate_m -> all_plate_m", "do not hang on each other"},
    {"TermsInARing",
     R"([{"op": "replace", "path": "/terms/all_plate_m", "value": "doubled_m / 2"}])",
     "/terms/doubled_m", "uses itself: all_plate_m -> doubled_m -> all_plate_m",
     "do not hang on each other"},
    {"TermWithAVariablesName",
     R"([{"op": "add", "path": "/terms/plate_m", "value": "upstream_height_m"}])", "/terms/plate_m",
     "has the name of a variable", "a name of its own"},
    {"TermWithAMetricsName",
     R"([{"op": "add", "path": "/terms/launch_length_m", "value": "upstream_height_m"}])",
     "/terms/launch_length_m", "has the name of a metric", "a name of its own"},
    {"TermThatIsAComparison",
     R"([{"op": "replace", "path": "/terms/all_plate_m", "value": "plate_m < 1"}])",
     "/terms/all_plate_m", "is a comparison", "lower and upper"},
    {"TermThatIsNoText", R"([{"op": "replace", "path": "/terms/all_plate_m", "value": 3}])",
     "/terms/all_plate_m", "must not be a whole number", "a text that is not empty, or an object"},
    {"TermWithoutAnyValue",
     R"j([{"op": "replace", "path": "/terms/doubled_m", "value": "sqrt(-1 - plate_m)"},
          {"op": "replace", "path": "/objectives/0/expression", "value": "spill"}])j",
     "/terms/doubled_m", "has no finite value at any of 200 designs", "does not divide by zero"},
    {"MetricThatMayNotExist", R"([{"op": "remove", "path": "/terms/spill/values_when_absent"}])",
     "/terms/spill/values_when_absent/launch_length_m",
     "launch_length_m does not exist in every run", "\"values_when_absent\": {\"launch_length_m\""},
    {"MetricThatMayNotExistInAConstraint",
     R"([{"op": "remove", "path": "/constraints/0/values_when_absent/landing_speed_m_s"}])",
     "/constraints/0/values_when_absent/landing_speed_m_s",
     "landing_speed_m_s does not exist in every run", "a number that counts then"},
    {"ValueOfAMetricThatIsNotUsed",
     R"([{"op": "add", "path": "/objectives/0/values_when_absent",
          "value": {"launch_lenght_m": 0}}])",
     "/objectives/0/values_when_absent/launch_lenght_m",
     "is not used by the expression; did you mean \"launch_length_m\"?", "launch_length_m"},
    {"TwoValuesOfOneMetric",
     R"([{"op": "add", "path": "/objectives/0/values_when_absent",
          "value": {"launch_length_m": 1}}])",
     "/objectives/0/values_when_absent", "the value 1, and the term spill the value 0",
     "one value for each metric"},
    {"ValuesWithoutAnExpression",
     R"([{"op": "replace", "path": "/objectives/1", "value": {"metric": "launch_length_m",
          "value_when_absent": 0, "values_when_absent": {"launch_length_m": 0}}}])",
     "/objectives/1/values_when_absent", "has no use without an expression", "value_when_absent"},
    {"OneValueForAnExpression",
     R"([{"op": "add", "path": "/objectives/0/value_when_absent", "value": 0}])",
     "/objectives/0/value_when_absent", "the values belong to the metrics of the expression",
     "values_when_absent: a number for each of barrier_1_design_moment_nm_per_m, launch_length_m"},
    {"StatisticOfAFormulaOfTheDesign",
     R"([{"op": "add", "path": "/objectives/1/statistic", "value": "worst"}])",
     "/objectives/1/statistic", "an expression is the same in every event", "no statistic"},
};

class WrongTerm : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongTerm, GivesOneClearIssue) {
  expect_one_issue(cost_study(), GetParam(),
                   [](const Json& json, const std::string& file) { parse_study(json, file); });
}

INSTANTIATE_TEST_SUITE_P(Terms, WrongTerm, testing::ValuesIn(wrong_terms), wrong_input_name);

// Terms of terms that double each time would fill the memory.
TEST(StudyTerms, ThatGrowWithoutEndAreRefused) {
  Json study = sound_study();
  study["terms"]["t_0"] = "plate_m + upstream_height_m";
  for (int k = 1; k < 40; ++k) {
    const std::string before = "t_" + std::to_string(k - 1);
    study["terms"]["t_" + std::to_string(k)] = before + " * " + before;
  }
  try {
    parse_study(study, "s");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("with its terms written out"), std::string::npos);
  }
}

}  // namespace
}  // namespace parapet::designs
