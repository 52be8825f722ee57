#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

Json sound_case() {
  return Json::parse(R"({
    "format": "parapet-case/1", "name": "two barriers",
    "channel": {"slope_deg": 26, "length_m": 3.0},
    "reservoir": {"length_m": 0.3, "height_m": 0.2},
    "barriers": [
      {"foot_x_m": 1.1, "height_m": 0.1, "deflector": {"angle_deg": 45, "length_m": 0.065}},
      {"spacing_m": 0.7, "height_m": 0.25}],
    "solids": [{"vertices_m": [[2.5, 0], [2.6, 0], [2.6, 0.05]]}],
    "numerics": {"spacing_m": 0.01},
    "run": {"stop_time_s": 2}})");
}

const WrongInput wrong_cases[] = {
    // What the schema finds.
    {"FormatMissing", R"([{"op": "remove", "path": "/format"}])", "/format", "is missing",
     "\"parapet-case/1\""},
    {"FormatOfAStudy", R"([{"op": "replace", "path": "/format", "value": "parapet-study/1"}])",
     "/format", "is not what this file should be", "\"parapet-case/1\""},
    {"NameMissing", R"([{"op": "remove", "path": "/name"}])", "/name", "is missing",
     "a text that is not empty"},
    {"NameMisspelt", R"([{"op": "move", "from": "/name", "path": "/nmae"}])", "/nmae",
     "unknown key; did you mean \"name\"?", "the keys format, name"},
    {"NameEmpty", R"([{"op": "replace", "path": "/name", "value": ""}])", "/name", "is empty",
     "a text that is not empty"},
    {"KeyMisspelt", R"([{"op": "add", "path": "/barriers/0/heigth_m", "value": 0.2}])",
     "/barriers/0/heigth_m", "unknown key; did you mean \"height_m\"?", "the keys foot_x_m"},
    {"KeyWithoutUnit", R"([{"op": "add", "path": "/barriers/1/thickness", "value": 0.2}])",
     "/barriers/1/thickness", "did you mean \"thickness_m\"?", "the keys foot_x_m"},
    {"KeyInForeignUnit", R"([{"op": "add", "path": "/numerics/spacing_mm", "value": 5}])",
     "/numerics/spacing_mm", "did you mean \"spacing_m\"?", "the keys spacing_m"},
    {"KeyUnlikeAny", R"([{"op": "add", "path": "/weather", "value": "rain"}])", "/weather",
     "unknown key", "the keys format, name, description, channel"},
    {"TextForNumber", R"([{"op": "replace", "path": "/channel/slope_deg", "value": "26"}])",
     "/channel/slope_deg", "must not be a text", "a number from 0 to 65 [deg]"},
    {"NullForNumber", R"([{"op": "replace", "path": "/barriers/0/height_m", "value": null}])",
     "/barriers/0/height_m", "must not be null", "a number from 0.001 to 100 [m]"},
    {"ListForObject", R"([{"op": "replace", "path": "/channel", "value": []}])", "/channel",
     "must not be a list", "an object with the keys slope_deg"},
    {"ObjectForList", R"([{"op": "replace", "path": "/barriers", "value": {}}])", "/barriers",
     "must not be an object", "a list of at most 20 entries"},
    {"NumberForDeflector", R"([{"op": "replace", "path": "/barriers/0/deflector", "value": 45}])",
     "/barriers/0/deflector", "must not be a whole number", "or null"},
    {"HeightNegative", R"([{"op": "replace", "path": "/barriers/0/height_m", "value": -0.1}])",
     "/barriers/0/height_m", "is too small", "a number from 0.001 to 100 [m]"},
    {"SlopeTooSteep", R"([{"op": "replace", "path": "/channel/slope_deg", "value": 89}])",
     "/channel/slope_deg", "is too large", "a number from 0 to 65 [deg]"},
    {"GravityZero", R"([{"op": "add", "path": "/channel/gravity_m_s2", "value": 0}])",
     "/channel/gravity_m_s2", "is too small", "a number above 0 up to 2000 [m/s2]"},
    {"SpacingOfZero", R"([{"op": "replace", "path": "/barriers/1/spacing_m", "value": 0}])",
     "/barriers/1/spacing_m", "is too small", "a number above 0 up to 1000 [m]"},
    {"WordUnknown", R"([{"op": "add", "path": "/channel/wall", "value": "noslip"}])",
     "/channel/wall", "is not known; did you mean \"no_slip\"?",
     "one of \"no_slip\", \"free_slip\""},
    {"IntegratorUnknown", R"([{"op": "add", "path": "/numerics/integrator", "value": "rk4"}])",
     "/numerics/integrator", "is not known", "\"rk4_explicit\""},
    {"FractionForWholeNumber",
     R"([{"op": "add", "path": "/numerics/cg_max_iterations", "value": 1.5}])",
     "/numerics/cg_max_iterations", "is not a whole number", "a whole number from 1 to 100000"},
    {"BodyWithTwoCorners",
     R"([{"op": "replace", "path": "/solids/0/vertices_m", "value": [[0, 0], [1, 0]]}])",
     "/solids/0/vertices_m", "has 2 entries", "a list of 3 to 1000 entries"},
    {"CornerInSpace",
     R"([{"op": "replace", "path": "/solids/0/vertices_m/1", "value": [1, 2, 3]}])",
     "/solids/0/vertices_m/1", "has 3 entries", "a list of 2 entries"},
    // Keys that exclude or need each other.
    {"FirstBarrierWithSpacing", R"([{"op": "add", "path": "/barriers/0/spacing_m", "value": 1}])",
     "/barriers/0/spacing_m", "the first barrier has no previous one", "foot_x_m"},
    {"LaterBarrierWithoutPlace", R"([{"op": "remove", "path": "/barriers/1/spacing_m"}])",
     "/barriers/1/spacing_m", "is missing", "from the previous barrier's foot"},
    {"LaterBarrierPlacedTwice", R"([{"op": "add", "path": "/barriers/1/foot_x_m", "value": 2}])",
     "/barriers/1/spacing_m", "stands beside foot_x_m", "either foot_x_m or spacing_m"},
    {"StemInclinedTwice",
     R"([{"op": "add", "path": "/barriers/0/stem_lean_deg", "value": 5},
         {"op": "add", "path": "/barriers/0/stem_inclination", "value": "vertical"}])",
     "/barriers/0/stem_lean_deg", "stands beside stem_inclination", "either stem_inclination"},
    // What is impossible although each number is in its own range.
    {"BarriersOverlap", R"([{"op": "replace", "path": "/barriers/1/spacing_m", "value": 0.05}])",
     "/barriers/1/spacing_m", "overlaps barrier 1 upstream of it", "a foot beyond x = "},
    {"BarrierBeyondTheEnd", R"([{"op": "replace", "path": "/barriers/1/spacing_m", "value": 2}])",
     "/barriers/1/spacing_m", "beyond the channel's end", "or a longer channel"},
    {"BarrierInTheReservoir",
     R"([{"op": "replace", "path": "/barriers/0/foot_x_m", "value": 0.2}])", "/barriers/0/foot_x_m",
     "overlaps the reservoir", "a foot beyond x = "},
    {"DeflectorReachesTheReservoir",
     R"([{"op": "replace", "path": "/barriers/0/foot_x_m", "value": 0.38}])",
     "/barriers/0/foot_x_m", "overlaps the reservoir", "a foot beyond x = 0.4"},
    {"BarrierThroughTheTop",
     R"([{"op": "replace", "path": "/barriers/1/height_m", "value": 1.8},
         {"op": "replace", "path": "/barriers/1/spacing_m", "value": 1.2}])",
     "/barriers/1/height_m", "m above the bed", "below /channel/height_m, 1.5 [m]"},
    {"DeflectorHitsTheBed",
     R"([{"op": "replace", "path": "/barriers/0/deflector/length_m", "value": 0.3},
         {"op": "replace", "path": "/barriers/0/deflector/angle_deg", "value": -10}])",
     "/barriers/0/deflector/angle_deg", "tip is too close to the bed", "0.01 m, above the bed"},
    {"DeflectorFoldsOntoTheStem",
     R"([{"op": "replace", "path": "/barriers/0/deflector/angle_deg", "value": -75}])",
     "/barriers/0/deflector/angle_deg", "folds onto its stem", "from -60 to 90 [deg]"},
    {"DeflectorPointsDownstream",
     R"([{"op": "add", "path": "/barriers/0/stem_lean_deg", "value": 20},
         {"op": "replace", "path": "/barriers/0/deflector/angle_deg", "value": 80}])",
     "/barriers/0/deflector/angle_deg", "points downstream of its stem", "(here 100)"},
    {"StemLiesDown", R"([{"op": "add", "path": "/barriers/0/stem_lean_deg", "value": 50}])",
     "/barriers/0/stem_lean_deg", "leans 76 deg", "within 68 deg"},
    {"TooCoarse", R"([{"op": "replace", "path": "/numerics/spacing_m", "value": 0.06}])",
     "/numerics/spacing_m", "too coarse: the reservoir is only 0.2 m across", "at most 0.05 [m]"},
    {"TooFine",
     R"([{"op": "replace", "path": "/reservoir", "value": {"length_m": 1, "height_m": 1}},
         {"op": "replace", "path": "/barriers/0/foot_x_m", "value": 1.5},
         {"op": "add", "path": "/numerics/sound_speed_m_s", "value": 60},
         {"op": "replace", "path": "/numerics/spacing_m", "value": 0.0004}])",
     "/numerics/spacing_m", "would hold 6.25e+06 particles", "at least 0.0004472 [m]"},
    {"BarrierBelowTheResolution",
     R"([{"op": "replace", "path": "/barriers/1/height_m", "value": 0.015}])",
     "/barriers/1/height_m", "too low to be resolved", "two particle spacings, 0.02 [m]"},
    {"DeflectorBelowTheResolution",
     R"([{"op": "replace", "path": "/barriers/0/deflector/length_m", "value": 0.005}])",
     "/barriers/0/deflector/length_m", "too short to be resolved", "or no deflector"},
    {"SoundTooSlow", R"([{"op": "add", "path": "/numerics/sound_speed_m_s", "value": 10}])",
     "/numerics/sound_speed_m_s", "is too low: falling 0.662 m to the gauge",
     "at least five times that speed, 18.02 [m/s]"},
    {"BlockLongerThanTheChannel",
     R"([{"op": "replace", "path": "/barriers", "value": []},
         {"op": "replace", "path": "/solids", "value": []},
         {"op": "replace", "path": "/reservoir/length_m", "value": 3.5}])",
     "/reservoir/length_m", "not shorter than the channel", "less than /channel/length_m, 3 [m]"},
    {"BlockHigherThanTheChannel",
     R"([{"op": "add", "path": "/channel/height_m", "value": 0.2},
         {"op": "replace", "path": "/barriers", "value": []}])",
     "/reservoir/height_m", "not lower than the channel", "less than /channel/height_m, 0.2 [m]"},
    {"GaugeBeyondTheEnd",
     R"([{"op": "replace", "path": "/barriers", "value": []},
         {"op": "add", "path": "/channel/monitor_x_m", "value": 3.5}])",
     "/channel/monitor_x_m", "beyond the channel's end", "at most /channel/length_m, 3 [m]"},
    {"ApproachOfOtherBarriers",
     R"([{"op": "add", "path": "/approach",
          "value": [{"front_velocity_m_s": 2, "flow_depth_max_m": null}]}])",
     "/approach", "has 1 places", "one for each of the 2 barriers, or no such key"},
    {"ApproachWithoutADepth",
     R"([{"op": "add", "path": "/approach", "value": [{"front_velocity_m_s": 2}]}])",
     "/approach/0/flow_depth_max_m", "is missing", ""},
    {"SidesCross",
     R"([{"op": "replace", "path": "/solids/0/vertices_m",
          "value": [[2.5, 0], [2.6, 0.1], [2.6, 0], [2.5, 0.12]]}])",
     "/solids/0/vertices_m", "sides cross each other", "corners in order"},
    {"CornersOnOneLine",
     R"([{"op": "replace", "path": "/solids/0/vertices_m", "value": [[2, 0], [2.1, 0], [2.2, 0]]}])",
     "/solids/0/vertices_m", "encloses no area", "not on one line"},
    {"BodyInTheReservoir",
     R"([{"op": "replace", "path": "/solids/0/vertices_m",
          "value": [[0.1, 0.1], [0.15, 0.1], [0.15, 0.15]]}])",
     "/solids/0/vertices_m", "reaches into the reservoir", "x from 0 to 0.3 m"},
    {"BodyThroughABarrier",
     R"([{"op": "replace", "path": "/solids/0/vertices_m",
          "value": [[1.7, 0.05], [1.9, 0.05], [1.9, 0.1]]}])",
     "/solids/0/vertices_m", "overlaps barrier 2", "clear of the barriers"},
    {"IntervalLongerThanTheRun",
     R"([{"op": "add", "path": "/run/series_interval_s", "value": 3},
         {"op": "add", "path": "/run/settled", "value": {"window_s": 3}}])",
     "/run/series_interval_s", "is longer than the run", "at most /run/stop_time_s, 2 [s]"},
    {"WindowShorterThanTheInterval",
     R"([{"op": "add", "path": "/run/settled", "value": {"window_s": 0.001}}])",
     "/run/settled/window_s", "shorter than the interval", "at least /run/series_interval_s"},
};

class WrongCase : public testing::TestWithParam<WrongInput> {};

// Each mistake gives one issue that names the place, the value and what is allowed.
TEST_P(WrongCase, GivesOneClearIssue) {
  expect_one_issue(sound_case(), GetParam(), parse_case);
}

INSTANTIATE_TEST_SUITE_P(Cases, WrongCase, testing::ValuesIn(wrong_cases), wrong_input_name);

// All mistakes of a file come at once, in the order of the file.
TEST(WrongCases, AreReportedTogether) {
  Json json = sound_case();
  json["channel"]["slope_deg"] = "steep";
  json["barriers"][0]["deflector"]["angle_deg"] = 120;
  json["barriers"][1]["hight_m"] = 0.25;
  json["numerics"]["spacing_m"] = -1;
  try {
    parse_case(json, "file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 4U) << error.what();
    EXPECT_EQ(error.issues()[0].pointer, "/channel/slope_deg");
    EXPECT_EQ(error.issues()[1].pointer, "/barriers/0/deflector/angle_deg");
    EXPECT_EQ(error.issues()[2].pointer, "/barriers/1/hight_m");
    EXPECT_EQ(error.issues()[3].pointer, "/numerics/spacing_m");
  }
}

// A document that is no object at all.
TEST(WrongCases, ATopLevelListIsOneIssue) {
  try {
    parse_case(Json::array({1, 2}), "file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].pointer, "");
    EXPECT_EQ(error.issues()[0].problem, "must not be a list");
  }
}

// JSON text cannot hold one, a program can.
TEST(WrongCases, ANumberThatIsNotFiniteIsRefused) {
  Json json = sound_case();
  json["barriers"][0]["height_m"] = std::numeric_limits<double>::quiet_NaN();
  try {
    parse_case(json, "file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].problem, "is not a finite number");
  }
}

// The line a user sees.
TEST(InputIssues, ReadAsOneLine) {
  EXPECT_EQ(to_string(InputIssue{"a.json", "/barriers/0/height_m", "-1", "is too small",
                                 "a number from 0.001 to 100 [m]"}),
            "a.json: /barriers/0/height_m: -1: is too small; allowed: a number from 0.001 to 100 "
            "[m]");
  EXPECT_EQ(to_string(InputIssue{"a.json", "/name", "", "is missing", "a text"}),
            "a.json: /name: is missing; allowed: a text");
}

}  // namespace
}  // namespace parapet::designs
