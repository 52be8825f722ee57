// Twenty-five kinds of wrong spec: each ends with exit code 2 and one line that names the place.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

struct WrongSpec {
  const char* name;
  std::function<void(Json&)> spoil;  // of tiny_study()
  std::vector<std::string> words;    // on standard error
};

void PrintTo(const WrongSpec& wrong, std::ostream* out) {
  *out << wrong.name;
}

class WrongStudy : public ::testing::TestWithParam<WrongSpec> {};

TEST_P(WrongStudy, OptimizeAndCheckEndWithTwoAndNameThePlace) {
  const TemporaryFolder folder;
  Json study = tiny_study();
  GetParam().spoil(study);
  folder.write("spec.json", study.dump());
  for (const char* verb : {"check", "optimize"}) {
    const Outcome outcome = run_program(folder.path(), {verb, "spec.json"});
    EXPECT_EQ(outcome.exit_code, 2) << verb << ": " << outcome.err;
    for (const std::string& words : GetParam().words)
      EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "spec.json", outcome.err);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one clear error:\n"
                                                                           << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "runs")) << "nothing may be begun";
}

INSTANTIATE_TEST_SUITE_P(
    Specs, WrongStudy,
    ::testing::Values(
        WrongSpec{"NoFormat", [](Json& s) { s.erase("format"); }, {"/format"}},
        WrongSpec{"UnknownFormat",
                  [](Json& s) { s["format"] = "parapet-study/9"; },
                  {"/format", "parapet-study/9"}},
        WrongSpec{"UnknownKey", [](Json& s) { s["varables"] = 1; }, {"varables"}},
        WrongSpec{"NoVariables", [](Json& s) { s["variables"] = Json::object(); }, {"/variables"}},
        WrongSpec{"UnknownVariable",
                  [](Json& s) {
                    s["variables"]["colour"] = {{"lower", 0}, {"upper", 1}};
                  },
                  {"/variables/colour"}},
        WrongSpec{"BoundsSwapped",
                  [](Json& s) { s["variables"]["upstream_height_m"]["lower"] = 0.2; },
                  {"/variables/upstream_height_m"}},
        WrongSpec{"NoObjective", [](Json& s) { s["objectives"] = Json::array(); }, {"/objectives"}},
        WrongSpec{"UnknownMetric",
                  [](Json& s) { s["objectives"][0]["metric"] = "beauty"; },
                  {"/objectives/0/metric", "beauty"}},
        WrongSpec{"UnknownGoal",
                  [](Json& s) { s["objectives"][0]["goal"] = "improve"; },
                  {"/objectives/0/goal", "improve", "maximize"}},
        WrongSpec{"ZeroWeight",
                  [](Json& s) { s["objectives"][0]["weight"] = 0; },
                  {"/objectives/0/weight"}},
        WrongSpec{"ObjectiveMayBeAbsent",
                  [](Json& s) { s["objectives"][0]["metric"] = "launch_length_m"; },
                  {"/objectives/0/value_when_absent"}},
        WrongSpec{"ConstraintOnNothing",
                  [](Json& s) { s["constraints"][0].erase("expression"); },
                  {"/constraints/0"}},
        WrongSpec{"ConstraintOnTwoThings",
                  [](Json& s) { s["constraints"][0]["metric"] = "retention_efficiency"; },
                  {"/constraints/0"}},
        WrongSpec{"ConstraintWithoutLimit",
                  [](Json& s) { s["constraints"][0].erase("upper"); },
                  {"/constraints/0"}},
        WrongSpec{"ExpressionSyntax",
                  [](Json& s) { s["constraints"][0]["expression"] = "upstream_height_m +"; },
                  {"/constraints/0/expression"}},
        WrongSpec{"ExpressionName",
                  [](Json& s) { s["constraints"][0]["expression"] = "height + 1"; },
                  {"/constraints/0/expression", "height"}},
        WrongSpec{"UnknownAlgorithm",
                  [](Json& s) { s["method"]["algorithm"] = "MAGIC"; },
                  {"/method/algorithm", "MAGIC"}},
        WrongSpec{"GradientAlgorithm",
                  [](Json& s) { s["method"]["algorithm"] = "SLSQP"; },
                  {"/method/algorithm", "SLSQP"}},
        WrongSpec{"LocalAlgorithmNotTaken",
                  [](Json& s) { s["method"]["local_algorithm"] = "SBPLX"; },
                  {"/method/local_algorithm", "SBPLX"}},
        WrongSpec{"BudgetBelowStarts",
                  [](Json& s) { s["method"]["max_evaluations"] = 2; },
                  {"/method/max_evaluations"}},
        WrongSpec{"ToleranceAboveStep",
                  [](Json& s) { s["method"]["relative_tolerance"] = 0.6; },
                  {"/method/relative_tolerance"}},
        WrongSpec{"StepTooLong",
                  [](Json& s) { s["method"]["initial_step"] = 0.9; },
                  {"/method/initial_step"}},
        WrongSpec{"StartOutsideBounds",
                  [](Json& s) { s["method"]["starts"][0]["deflector_angle_deg"] = 80; },
                  {"/method/starts/0/deflector_angle_deg", "80"}},
        WrongSpec{"StartIncomplete",
                  [](Json& s) { s["method"]["starts"][0].erase("deflector_angle_deg"); },
                  {"/method/starts/0/deflector_angle_deg"}},
        WrongSpec{"CaseWrongType",
                  [](Json& s) { s["case"]["barriers"][0]["height_m"] = "high"; },
                  {"/case/barriers/0/height_m", "high"}},
        WrongSpec{"CaseOutOfRange",
                  [](Json& s) { s["case"]["channel"]["slope_deg"] = 100; },
                  {"/case/channel/slope_deg", "100"}},
        WrongSpec{"CaseMissingFile",
                  [](Json& s) {
                    s.erase("case");
                    s["case_file"] = "nowhere.json";
                  },
                  {"nowhere.json"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(WrongText, SyntaxErrorNamesTheLine) {
  const TemporaryFolder folder;
  folder.write("broken.json", "{\n  \"format\": \"parapet-study/1\",\n  oops\n}\n");
  const Outcome outcome = run_program(folder.path(), {"optimize", "broken.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "broken.json", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "line 3", outcome.err);
}

TEST(WrongText, EmptyFileIsNotJson) {
  const TemporaryFolder folder;
  folder.write("empty.json", "");
  const Outcome outcome = run_program(folder.path(), {"simulate", "empty.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "empty.json", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "is not JSON", outcome.err);
}

}  // namespace
}  // namespace parapet::test
