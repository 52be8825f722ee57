#include "study_fixture.hpp"
#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

const WrongInput wrong_studies[] = {
    // What the schema finds, in the case inside too.
    {"FormatOfACase", R"([{"op": "replace", "path": "/format", "value": "parapet-case/1"}])",
     "/format", "is not what this file should be", "\"parapet-study/1\""},
    {"FormatMissing", R"([{"op": "remove", "path": "/format"}])", "/format", "is missing",
     "\"parapet-study/1\""},
    {"NoVariables", R"([{"op": "remove", "path": "/variables"}])", "/variables", "is missing",
     "an object"},
    {"NoObjectives", R"([{"op": "replace", "path": "/objectives", "value": []}])", "/objectives",
     "has 0 entries", "a list of at least 1 entry"},
    {"KeyMisspelt", R"([{"op": "move", "from": "/objectives", "path": "/objective"}])",
     "/objective", "unknown key; did you mean \"objectives\"?", "the keys format"},
    {"KeyOfTheCaseMisspelt", R"([{"op": "add", "path": "/case/barriers/0/height", "value": 0.1}])",
     "/case/barriers/0/height", "did you mean \"height_m\"?", "the keys foot_x_m"},
    {"CaseOutOfRange", R"([{"op": "add", "path": "/case/channel", "value": {"slope_deg": -5}}])",
     "/case/channel/slope_deg", "is too small", "a number from 0 to 65 [deg]"},
    {"BoundMissing", R"([{"op": "remove", "path": "/variables/plate_m/upper"}])",
     "/variables/plate_m/upper", "is missing", "a number"},
    {"BoundMisspelt",
     R"([{"op": "move", "from": "/variables/plate_m/upper", "path": "/variables/plate_m/uper"}])",
     "/variables/plate_m/uper", "did you mean \"upper\"?", "the keys lower, upper"},
    {"NameNotAWord",
     R"([{"op": "move", "from": "/variables/plate_m", "path": "/variables/Plate length_m"}])",
     "/variables/Plate length_m", "not a name of this form", "lower-case letters"},
    {"GoalUnknown", R"([{"op": "replace", "path": "/objectives/1/goal", "value": "minimise"}])",
     "/objectives/1/goal", "did you mean \"minimize\"?", "\"maximize\", \"minimize\""},
    {"WeightNegative", R"([{"op": "replace", "path": "/objectives/1/weight", "value": -1}])",
     "/objectives/1/weight", "is too small", "a number above 0"},
    {"NoEvaluations", R"([{"op": "replace", "path": "/method/max_evaluations", "value": 0}])",
     "/method/max_evaluations", "is too small", "a whole number from 1"},
    {"AlgorithmEmpty", R"([{"op": "replace", "path": "/method/algorithm", "value": ""}])",
     "/method/algorithm", "is empty", "a text that is not empty"},
    {"SeedNegative", R"([{"op": "add", "path": "/method/seed", "value": -1}])", "/method/seed",
     "is too small", "a whole number from 0"},
    // The base case.
    {"NoCase", R"([{"op": "remove", "path": "/case"}])", "/case", "is missing", "case_file"},
    {"TwoCases", R"([{"op": "add", "path": "/case_file", "value": "a.json"}])", "/case",
     "stands beside case_file", "either a case"},
    {"CaseFileMissing",
     R"([{"op": "remove", "path": "/case"},
         {"op": "add", "path": "/case_file", "value": "no_such_case.json"}])",
     "/case_file", "there is no file no_such_case.json", "relative to this file"},
    {"CaseImpossible",
     R"([{"op": "replace", "path": "/case/barriers/1/spacing_m", "value": 0.03}])",
     "/case/barriers/1/spacing_m", "overlaps barrier 1", "a foot beyond"},
    // Variables.
    {"VariableUnknown",
     R"([{"op": "add", "path": "/variables/upstream_hight_m", "value": {"lower": 0.1, "upper": 0.2}}])",
     "/variables/upstream_hight_m", "did you mean \"upstream_height_m\"?",
     "a target such as /barriers/0/height_m"},
    {"TargetMissing",
     R"([{"op": "replace", "path": "/variables/plate_m/target", "value": "/barriers/0/lenght_m"}])",
     "/variables/plate_m", "/barriers/0/lenght_m is not a number of the case's scene",
     "/barriers/0/deflector/length_m"},
    {"TargetNoPointer",
     R"([{"op": "replace", "path": "/variables/plate_m/target", "value": "length_m"}])",
     "/variables/plate_m", "is not a JSON pointer", "one of /channel/slope_deg"},
    {"TargetNotInTheScene",
     R"([{"op": "replace", "path": "/variables/plate_m/target", "value": "/numerics/spacing_m"}])",
     "/variables/plate_m", "is not a number of the case's scene", "one of /channel/slope_deg"},
    {"TargetAText",
     R"([{"op": "replace", "path": "/variables/plate_m/target", "value": "/channel/wall"}])",
     "/variables/plate_m", "is not a number of the case's scene", "one of /channel/slope_deg"},
    {"TargetNotSet",
     R"([{"op": "add", "path": "/variables/upstream_stem_lean_deg",
          "value": {"lower": -5, "upper": 5}}])",
     "/variables/upstream_stem_lean_deg", "/barriers/0/stem_lean_deg is not set in the case",
     "/barriers/0/height_m"},
    {"TargetOnABareBarrier",
     R"([{"op": "add", "path": "/variables/downstream_deflector_angle_deg",
          "value": {"lower": 0, "upper": 60}}])",
     "/variables/downstream_deflector_angle_deg", "that barrier has no deflector",
     "/barriers/0/deflector/angle_deg"},
    {"TargetTakenTwice",
     R"([{"op": "add", "path": "/variables/deflector_length_m",
          "value": {"lower": 0.03, "upper": 0.1}}])",
     "/variables/deflector_length_m", "which plate_m varies already", "one variable for each"},
    {"TargetGivenTwice",
     R"([{"op": "add", "path": "/variables/plate_m/targets",
          "value": ["/barriers/0/deflector/length_m"]}])",
     "/variables/plate_m/targets", "stands beside target", "either target or targets"},
    {"NameInAnotherUnit",
     R"([{"op": "add", "path": "/variables/drop_deg",
          "value": {"lower": 0.5, "upper": 0.8, "target": "/barriers/1/spacing_m"}}])",
     "/variables/drop_deg", "does not end in the unit of its target /barriers/1/spacing_m",
     "a name that ends in _m"},
    {"BoundsSwapped",
     R"([{"op": "replace", "path": "/variables/deflector_angle_deg",
          "value": {"lower": 75, "upper": 10}}])",
     "/variables/deflector_angle_deg", "lower bound is not below the upper", "lower < upper"},
    {"BoundOutsideTheSchema",
     R"([{"op": "replace", "path": "/variables/deflector_angle_deg/upper", "value": 120}])",
     "/variables/deflector_angle_deg/upper", "is too large for /barriers/0/deflector/angle_deg",
     "a number from -90 to 90 [deg]"},
    // Objectives and constraints.
    {"MetricUnknown",
     R"([{"op": "replace", "path": "/objectives/0/metric", "value": "retention_eficiency"}])",
     "/objectives/0/metric", "did you mean \"retention_efficiency\"?", "launch_length_m"},
    {"MetricOfAnAbsentBarrier",
     R"([{"op": "replace", "path": "/constraints/1/metric",
          "value": "barrier_3_slam_force_n_per_m"}])",
     "/constraints/1/metric", "is not a metric of this case", "barrier_2_slam_force_n_per_m"},
    {"MetricOfAnEarlierVersion",
     R"([{"op": "replace", "path": "/constraints/1/metric",
          "value": "barrier_1_peak_force_n_per_m"}])",
     "/constraints/1/metric", "does not converge with the particle spacing",
     "barrier_1_design_force_n_per_m, the load to design with, or barrier_1_slam_force_n_per_m"},
    {"MetricMayBeAbsent",
     R"([{"op": "replace", "path": "/objectives/1/value_when_absent", "value": null}])",
     "/objectives/1/value_when_absent", "launch_length_m does not exist in every run",
     "a number that counts then"},
    {"MetricTwice",
     R"([{"op": "replace", "path": "/objectives/1/metric", "value": "retention_efficiency"}])",
     "/objectives/1/metric", "is an objective already", "each metric once"},
    {"ConstraintOnNothing", R"([{"op": "remove", "path": "/constraints/1/metric"}])",
     "/constraints/1", "limits nothing", "either a metric or an expression"},
    {"ConstraintOnTwoThings",
     R"([{"op": "add", "path": "/constraints/1/expression", "value": "plate_m"}])",
     "/constraints/1", "limits two things", "either a metric or an expression"},
    {"ConstraintWithoutLimit", R"([{"op": "remove", "path": "/constraints/0/upper"}])",
     "/constraints/0", "has no limit", "lower, upper or both"},
    {"LimitsSwapped", R"([{"op": "replace", "path": "/constraints/1/lower", "value": 500}])",
     "/constraints/1", "lower limit is above its upper", "lower <= upper"},
    {"ConstraintNamedTwice",
     R"([{"op": "add", "path": "/constraints/1/name", "value": "material"}])", "/constraints/1",
     "another constraint is called \"material\" too", "a name of its own"},
    {"ExpressionWithUnknownSymbol",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "plate_m + hight_m"}])",
     "/constraints/0/expression", "unknown symbol \"hight_m\" at character 11",
     "a formula of deflector_angle_deg, upstream_height_m, plate_m"},
    {"ExpressionCutOff",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "plate_m +"}])",
     "/constraints/0/expression", "cannot be read at character 10", "a formula of"},
    {"ExpressionWithoutClosing",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "2 * (plate_m"}])",
     "/constraints/0/expression", "cannot be read", "a formula of"},
    {"ExpressionIsAComparison",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "plate_m <= 0.1"}])",
     "/constraints/0/expression", "is a comparison", "limits stand in the keys lower and upper"},
    {"ExpressionWithADecimalComma",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "0,5 * plate_m"}])",
     "/constraints/0/expression", "has a comma at character 2", "a point as the decimal mark"},
    {"ObjectiveWithoutAnyValue",
     R"j([{"op": "add", "path": "/objectives/-",
          "value": {"expression": "1 / (plate_m - plate_m)", "goal": "minimize"}}])j",
     "/objectives/2/expression", "has no finite value at any of 200 designs",
     "does not divide by zero"},
    {"ConstraintWithoutAnyValue",
     R"j([{"op": "replace", "path": "/constraints/0/expression", "value": "sqrt(-1 - plate_m)"}])j",
     "/constraints/0/expression", "has no finite value at any of 200 designs",
     "does not divide by zero"},
    {"EvaluationsNotWhole",
     R"([{"op": "replace", "path": "/method/max_evaluations", "value": 3.5}])",
     "/method/max_evaluations", "is not a whole number", "a whole number from 1"},
    {"SeedNotWhole", R"([{"op": "add", "path": "/method/seed", "value": 0.5}])", "/method/seed",
     "is not a whole number", "a whole number from 0"},
    {"NameTooLong",
     R"([{"op": "replace", "path": "/name", "value":
          "123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 123456789 1"}])",
     "/name", "is 101 bytes long", "at most 100 bytes"},
    {"NameTooLongInUtf8",
     R"([{"op": "replace", "path": "/case", "value": {"name":
          "\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4"}}])",
     "/case/name", "is 102 bytes long", "at most 100 bytes"},
    {"BeyondABoundByMoreThanRounding",
     R"([{"op": "replace", "path": "/method/starts/0/plate_m", "value": 0.1000000000001}])",
     "/method/starts/0/plate_m", "outside the variable's bounds", "a number from 0.03 to 0.1"},
    {"ExpressionIsConstant",
     R"([{"op": "replace", "path": "/constraints/0/expression", "value": "2 * 3"}])",
     "/constraints/0/expression", "does not depend on any variable", "a formula of"},
    // Starting designs.
    {"StartOutOfBounds",
     R"([{"op": "replace", "path": "/method/starts/0/deflector_angle_deg", "value": 80}])",
     "/method/starts/0/deflector_angle_deg", "outside the variable's bounds",
     "a number from 0.0 to 75.0 [deg]"},
    {"StartIncomplete", R"([{"op": "remove", "path": "/method/starts/0/plate_m"}])",
     "/method/starts/0/plate_m", "is missing", "a number from 0.03 to 0.1 [m]"},
    {"StartOfAnUnknownVariable",
     R"([{"op": "add", "path": "/method/starts/0/plte_m", "value": 0.05}])",
     "/method/starts/0/plte_m", "unknown variable; did you mean \"plate_m\"?",
     "the variables deflector_angle_deg"},
    {"StartImpossible",
     R"([{"op": "replace", "path": "/variables/plate_m/upper", "value": 2},
         {"op": "replace", "path": "/method/starts/0/plate_m", "value": 1.5}])",
     "/method/starts/0", "is not a possible scene: /case/barriers/0/", "above the bed"},
    {"MoreStartsThanEvaluations",
     R"([{"op": "replace", "path": "/method/max_evaluations", "value": 3}])",
     "/method/max_evaluations", "does not even allow the 4 starting designs",
     "at least the number of starts"},
};

class WrongStudy : public testing::TestWithParam<WrongInput> {};

// Each mistake gives one issue that names the place, the value and what is allowed.
TEST_P(WrongStudy, GivesOneClearIssue) {
  expect_one_issue(sound_study(), GetParam(), parse_study);
}

INSTANTIATE_TEST_SUITE_P(Studies, WrongStudy, testing::ValuesIn(wrong_studies), wrong_input_name);

// Independent mistakes come at once.
TEST(WrongStudies, AreReportedTogether) {
  Json json = sound_study();
  json["variables"]["deflector_angle_deg"]["upper"] = -3;
  json["objectives"][0]["metric"] = "retention";
  json["constraints"][0]["expression"] = "plate";
  json["method"]["max_evaluations"] = 1;  // the starts are not judged by a wrong variable
  try {
    parse_study(json, "file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    std::vector<std::string> pointers;
    for (const InputIssue& issue : error.issues()) pointers.push_back(issue.pointer);
    EXPECT_EQ(pointers,
              (std::vector<std::string>{"/variables/deflector_angle_deg", "/objectives/0/metric",
                                        "/constraints/0/expression", "/method/max_evaluations"}))
        << error.what();
  }
}

}  // namespace
}  // namespace parapet::designs
