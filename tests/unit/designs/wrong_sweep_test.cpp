#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

Json sound_sweep() {
  return Json::parse(R"({
    "format": "parapet-sweep/1", "name": "sweep",
    "case": {"barriers": [{"height_m": 0.1}], "numerics": {"spacing_m": 0.01}},
    "rows": [
      {"id": "one", "changes": {"barriers": [{"height_m": 0.2}]},
       "published": {"retention_efficiency": {"value": 0.5, "source": "p. 3"}}},
      {"id": "two", "changes": {"channel": {"length_m": 2}}}]})");
}

const WrongInput wrong_sweeps[] = {
    {"NoRows", R"([{"op": "remove", "path": "/rows"}])", "/rows", "is missing", "a list of at"},
    {"IdTwice", R"([{"op": "replace", "path": "/rows/1/id", "value": "one"}])", "/rows/1/id",
     "another row has this id", "an id of its own"},
    {"IdNamesAFolder", R"([{"op": "replace", "path": "/rows/1/id", "value": "../two"}])",
     "/rows/1/id", "not a name of this form", "letters, digits"},
    {"CaseWrong", R"([{"op": "replace", "path": "/case/barriers/0/height_m", "value": "0.1"}])",
     "/case/barriers/0/height_m", "must not be a text", "a number from 0.001 to 100 [m]"},
    {"ChangeWrong",
     R"([{"op": "replace", "path": "/rows/0/changes/barriers/0/height_m", "value": -1}])",
     "/rows/0/changes/barriers/0/height_m", "is too small", "a number from 0.001 to 100 [m]"},
    {"ChangeMisspelt", R"([{"op": "add", "path": "/rows/1/changes/chanel", "value": {}}])",
     "/rows/1/changes/chanel", "did you mean \"channel\"?", "the keys format"},
    {"ChangeMakesTheBaseImpossible",
     R"([{"op": "replace", "path": "/rows/1/changes/channel/length_m", "value": 1}])",
     "/rows/1/changes", "beyond the channel's end", "or a longer channel"},
    {"PublishedMetricUnknown",
     R"([{"op": "add", "path": "/rows/0/published/retention", "value":
          {"value": 1, "source": "p. 1"}}])",
     "/rows/0/published/retention", "is not a metric of this row", "retention_efficiency"},
    {"PublishedWithoutSource",
     R"([{"op": "remove", "path": "/rows/0/published/retention_efficiency/source"}])",
     "/rows/0/published/retention_efficiency/source", "is missing", "a text that is not empty"},
    {"PublishedWithoutNumber",
     R"([{"op": "remove", "path": "/rows/0/published/retention_efficiency/value"}])",
     "/rows/0/published/retention_efficiency", "states no number", "a value, or a lower"},
};

class WrongSweep : public testing::TestWithParam<WrongInput> {};

// Each mistake gives one issue that names the place, the value and what is allowed.
TEST_P(WrongSweep, GivesOneClearIssue) {
  expect_one_issue(sound_sweep(), GetParam(), parse_sweep);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, WrongSweep, testing::ValuesIn(wrong_sweeps), wrong_input_name);

}  // namespace
}  // namespace parapet::designs
