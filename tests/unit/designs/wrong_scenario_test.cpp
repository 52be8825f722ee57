#include "study_fixture.hpp"
#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

Json list_study() {
  Json json = sound_study();
  json["scenarios"] = Json::parse(R"([
      {"name": "dry", "weight": 3, "set": {"yield_stress_pa": 140}},
      {"name": "wet", "set": {"released_volume_m3_per_m": 0.08}}])");
  return json;
}

const WrongInput wrong_lists[] = {
    {"NotAList", R"([{"op": "replace", "path": "/scenarios", "value": 3}])", "/scenarios",
     "must not be a whole number", "a list of at most 1000 entries, or an object"},
    {"WeightZero", R"([{"op": "replace", "path": "/scenarios/0/weight", "value": 0}])",
     "/scenarios/0/weight", "is too small", "a number above 0"},
    {"NameTwice", R"([{"op": "replace", "path": "/scenarios/1/name", "value": "dry"}])",
     "/scenarios/1", "another scenario is called \"dry\" too", "a name of its own"},
    {"UnknownName", R"([{"op": "add", "path": "/scenarios/0/set/yield_stres_pa", "value": 50}])",
     "/scenarios/0/set/yield_stres_pa", "did you mean \"yield_stress_pa\"?",
     "a JSON pointer such as /material/yield_stress_pa"},
    {"UnknownPlace",
     R"([{"op": "add", "path": "/scenarios/0/set/~1material~1colour", "value": 50}])",
     "/scenarios/0/set/~1material~1colour", "is not a number of the case's scene",
     "/material/yield_stress_pa"},
    {"OutOfRange",
     R"([{"op": "replace", "path": "/scenarios/0/set/yield_stress_pa", "value": -1}])",
     "/scenarios/0/set/yield_stress_pa", "dry: -1.0 is too small for /material/yield_stress_pa",
     "a number from 0 to 1000000 [Pa]"},
    {"SetTwice",
     R"([{"op": "add", "path": "/scenarios/0/set/~1material~1yield_stress_pa", "value": 50}])",
     "/scenarios/0/set/~1material~1yield_stress_pa", "which dry sets already", "each place once"},
    {"SetByAVariable",
     R"([{"op": "add", "path": "/scenarios/0/set/upstream_height_m", "value": 0.1}])",
     "/scenarios/0/set/upstream_height_m",
     "sets /barriers/0/height_m, which the variable upstream_height_m changes",
     "a place that no variable changes"},
    {"VolumeAtAHeightThatVaries",
     R"([{"op": "add", "path": "/variables/reservoir_height_m",
          "value": {"lower": 0.1, "upper": 0.3}},
         {"op": "add", "path": "/method/starts/0/reservoir_height_m", "value": 0.2}])",
     "/scenarios/1/set/released_volume_m3_per_m",
     "needs /reservoir/height_m, which the variable reservoir_height_m changes",
     "a place that no variable changes"},
    {"MakesTheCaseImpossible",
     R"([{"op": "replace", "path": "/scenarios/1/set/released_volume_m3_per_m", "value": 0.3}])",
     "/scenarios", "wet makes the case impossible: /case/barriers/0/foot_x_m the barrier overlaps",
     "a foot beyond"},
    // 1 - 0.9^2 = 0.19, ln 0.05 / ln 0.9 = 28.4, 0.05^(1/2) = 0.2236.
    {"QuantileOfTwoEvents",
     R"([{"op": "add", "path": "/objectives/0/statistic", "value": "quantile"}])",
     "/objectives/0/quantile",
     "cannot be told from 2 events: the worst of them bounds it with only 19 % confidence",
     "at least 29 events, or the statistic \"worst\", which of 2 bounds the 0.2236 quantile with "
     "95 %"},
    {"QuantileInAConstraint",
     R"([{"op": "add", "path": "/constraints/1/statistic", "value": "quantile"},
         {"op": "add", "path": "/constraints/1/quantile", "value": 0.5}])",
     "/constraints/1/quantile", "with only 75 % confidence", "at least 5 events"},
    {"QuantileOne",
     R"([{"op": "add", "path": "/objectives/0/statistic", "value": "quantile"},
         {"op": "add", "path": "/objectives/0/quantile", "value": 1}])",
     "/objectives/0/quantile", "is the worst of all events", "the statistic \"worst\""},
};

class WrongList : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongList, GivesOneClearIssue) {
  expect_one_issue(list_study(), GetParam(), parse_study);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, WrongList, testing::ValuesIn(wrong_lists), wrong_input_name);

Json drawn_study() {
  Json json = sound_study();
  json["scenarios"] = Json::parse(R"({"count": 4, "variables": {
      "yield_stress_pa": {"distribution": "lognormal", "mean": 90, "sd": 27},
      "slope_deg": {"distribution": "triangular", "lower": 25, "mode": 26, "upper": 28},
      "density_kg_m3": {"distribution": "uniform", "lower": 1000, "upper": 1200}}})");
  return parse_study(json, "drawn").resolved;  // with its list
}

const WrongInput wrong_distributions[] = {
    {"NoCount", R"([{"op": "remove", "path": "/scenarios/count"}])", "/scenarios/count",
     "is missing", "a whole number from 1"},
    {"NoKind", R"([{"op": "remove", "path": "/scenarios/variables/slope_deg/distribution"}])",
     "/scenarios/variables/slope_deg/distribution", "is missing", "\"normal\", \"lognormal\""},
    {"KindUnknown",
     R"([{"op": "replace", "path": "/scenarios/variables/slope_deg/distribution",
          "value": "norma"}])",
     "/scenarios/variables/slope_deg/distribution", "did you mean \"normal\"?", "\"triangular\""},
    {"SpreadNegative",
     R"([{"op": "replace", "path": "/scenarios/variables/yield_stress_pa/sd", "value": -1}])",
     "/scenarios/variables/yield_stress_pa/sd", "is too small", "a number above 0"},
    {"NoMean", R"([{"op": "remove", "path": "/scenarios/variables/yield_stress_pa/mean"}])",
     "/scenarios/variables/yield_stress_pa/mean", "is missing", "a number"},
    {"NoMode", R"([{"op": "remove", "path": "/scenarios/variables/slope_deg/mode"}])",
     "/scenarios/variables/slope_deg/mode", "is missing", "a number"},
    {"MeanOfAUniformOne",
     R"([{"op": "add", "path": "/scenarios/variables/density_kg_m3/mean", "value": 1100}])",
     "/scenarios/variables/density_kg_m3/mean", "has no use in this distribution",
     "lower and upper for uniform"},
    {"ModeOfALognormalOne",
     R"([{"op": "add", "path": "/scenarios/variables/yield_stress_pa/mode", "value": 80}])",
     "/scenarios/variables/yield_stress_pa/mode", "has no use in this distribution", "mean and sd"},
    {"LognormalMeanZero",
     R"([{"op": "replace", "path": "/scenarios/variables/yield_stress_pa/mean", "value": 0}])",
     "/scenarios/variables/yield_stress_pa/mean", "is too small", "a number above 0"},
    {"LimitsSwapped",
     R"([{"op": "replace", "path": "/scenarios/variables/density_kg_m3/upper", "value": 900}])",
     "/scenarios/variables/density_kg_m3", "the lower value is not below the upper",
     "lower < upper"},
    {"ModeOutside",
     R"([{"op": "replace", "path": "/scenarios/variables/slope_deg/mode", "value": 30}])",
     "/scenarios/variables/slope_deg/mode", "is not between", "lower <= mode <= upper"},
    {"CutToNothing",
     R"([{"op": "add", "path": "/scenarios/variables/yield_stress_pa/lower", "value": 5000}])",
     "/scenarios/variables/yield_stress_pa", "next to nothing between", "at least a share of"},
    {"UnknownName",
     R"([{"op": "move", "from": "/scenarios/variables/slope_deg",
          "path": "/scenarios/variables/slop_deg"}])",
     "/scenarios/variables/slop_deg", "did you mean \"slope_deg\"?", "a JSON pointer"},
    {"NameInAnotherUnit",
     R"([{"op": "add", "path": "/scenarios/variables/yield_stress_pa/target",
          "value": "/material/flow_index"}])",
     "/scenarios/variables/yield_stress_pa", "does not end in the unit of its target",
     "a name in the unit of the target"},
    {"SetByAVariable",
     R"([{"op": "add", "path": "/scenarios/variables/upstream_height_m",
          "value": {"distribution": "uniform", "lower": 0.1, "upper": 0.12}}])",
     "/scenarios/variables/upstream_height_m", "which the variable upstream_height_m changes",
     "a place that no variable changes"},
    {"DrawnOutOfRange",
     R"([{"op": "replace", "path": "/scenarios/count", "value": 1},
         {"op": "replace", "path": "/scenarios/variables/density_kg_m3",
          "value": {"distribution": "uniform", "lower": 10, "upper": 20}}])",
     "/scenarios/variables/density_kg_m3", "is too small for /material/density_kg_m3",
     "a number from 100 to 10000 [kg/m3]"},
    // A list that is kept beside other distributions would be used in silence.
    {"ListOfOtherDistributions",
     R"([{"op": "replace", "path": "/scenarios/variables/yield_stress_pa/mean", "value": 91}])",
     "/scenarios/list", "is not what the distributions give", "no list"},
    // COBYLA has no surrogates: its statistics are of the four events alone.
    {"QuantileWithoutSurrogates",
     R"([{"op": "replace", "path": "/objectives/0/statistic", "value": "quantile"}])",
     "/objectives/0/quantile", "cannot be told from 4 events", "at least 29 events"},
    {"ListOfAnotherCount", R"([{"op": "replace", "path": "/scenarios/count", "value": 5}])",
     "/scenarios/list", "is not what the distributions give", "no list"},
};

class WrongDistribution : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongDistribution, GivesOneClearIssue) {
  expect_one_issue(drawn_study(), GetParam(), parse_study);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, WrongDistribution, testing::ValuesIn(wrong_distributions),
                         wrong_input_name);

}  // namespace
}  // namespace parapet::designs
