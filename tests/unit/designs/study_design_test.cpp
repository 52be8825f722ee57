#include <gtest/gtest.h>

#include <cmath>

#include "study_fixture.hpp"

namespace parapet::designs {
namespace {

DesignReading read(const std::string& text) {
  return read_design(parse_study(choice_study(), "s"), Json::parse(text), "--design");
}

// Options by name, numbers for the rest, nothing for what is not there; and back again.
TEST(ReadDesign, TakesWhatPeopleWrite) {
  const DesignReading reading = read(
      R"({"barriers": "one", "deflector": "plate", "deflector_angle_deg": 45,
          "deflector_length_m": 0.05, "upstream_height_m": 0.1})");
  EXPECT_TRUE(reading.issues.empty());
  EXPECT_EQ(reading.design, (Design{{"barriers", 0.0},
                                    {"deflector", 1.0},
                                    {"deflector_angle_deg", 45.0},
                                    {"deflector_length_m", 0.05},
                                    {"upstream_height_m", 0.1}}));
  const StudySpec study = parse_study(choice_study(), "s");
  EXPECT_TRUE(check_design(study, reading.design, "d").empty());
  EXPECT_EQ(design_json(study, reading.design),
            Json::parse(R"({"barriers": "one", "deflector": "plate", "deflector_angle_deg": 45.0,
                            "deflector_length_m": 0.05, "upstream_height_m": 0.1})"));
}

struct WrongDesign {
  const char* text;
  std::vector<std::string> lines;
};

// Everything wrong, each with its place, and nothing said of what hangs on a wrong choice.
TEST(ReadDesign, FindsEverything) {
  const WrongDesign wrong[] = {
      {R"({"barriers": "one", "deflector": "none", "upstream_height_m": 0.1,
           "downstream_height_m": 0.2})",
       {"--design: /downstream_height_m: 0.2: does not exist under the options that the design "
        "takes; allowed: no value, or the choice barriers \"two\" or \"three\""}},
      {R"({"barriers": "two", "deflector": "none", "upstream_height_m": 0.1})",
       {"--design: /downstream_height_m: is missing; allowed: a number from 0.1 to 0.25 [m]"}},
      {R"({"barriers": "one", "deflector": "plat", "upstream_height_m": 0.1})",
       {"--design: /deflector: \"plat\": is not an option of deflector; did you mean \"plate\"?; "
        "allowed: one of the options \"none\", \"plate\", \"big\""}},
      {R"({"barriers": "one", "deflector": 1, "upstream_height_m": 0.1})",
       {"--design: /deflector: 1: is not the name of an option; allowed: one of the options "
        "\"none\", \"plate\", \"big\""}},
      {R"({"deflector": "none", "upstream_height_m": "high"})",
       {"--design: /barriers: is missing; allowed: one of the options \"one\", \"two\", \"three\"",
        "--design: /upstream_height_m: \"high\": is not a number; allowed: a number from 0.08 to "
        "0.16 [m]"}},
      {R"({"barriers": "one", "deflector": "big", "deflector_angle_deg": 30.5,
           "upstream_height_m": 0.1})",
       {"--design: /deflector_angle_deg: 30.5: is not a whole number; allowed: a whole number from "
        "0 to 75 [deg]"}},
      {"[1, 2]",
       {"--design: [1,2]: is not an object; allowed: an object of values by variable, for "
        "example {\"deflector_angle_deg\": 45}"}}};
  for (const WrongDesign& design : wrong) {
    std::vector<std::string> lines;
    for (const InputIssue& issue : read(design.text).issues) lines.push_back(to_string(issue));
    EXPECT_EQ(lines, design.lines);
  }
}

// What a sum or a conversion of units loses is not beyond a bound.
TEST(ReadDesign, TakesValuesOneUnitInTheLastPlaceBeyondABoundAsTheBound) {
  const StudySpec study = parse_study(sound_study(), "s");
  for (const int steps : {1, 2, 4}) {
    double high = 0.1, low = 0.03, zero = 0.0;
    for (int k = 0; k < steps; ++k) {
      high = std::nextafter(high, 1.0);
      low = std::nextafter(low, 0.0);
      zero -= 1e-15;  // of a range of 75
    }
    const DesignReading above = read_design(
        study, Json{{"deflector_angle_deg", zero}, {"upstream_height_m", 0.1}, {"plate_m", high}},
        "d");
    ASSERT_TRUE(above.issues.empty()) << to_string(above.issues.front());
    EXPECT_EQ(above.design.at("plate_m"), 0.1);
    EXPECT_EQ(above.design.at("deflector_angle_deg"), 0.0);
    const DesignReading below = read_design(
        study, Json{{"deflector_angle_deg", 1}, {"upstream_height_m", 0.1}, {"plate_m", low}}, "d");
    ASSERT_TRUE(below.issues.empty()) << to_string(below.issues.front());
    EXPECT_EQ(below.design.at("plate_m"), 0.03);
  }
  EXPECT_FALSE(
      read_design(
          study,
          Json{{"deflector_angle_deg", 1}, {"upstream_height_m", 0.1}, {"plate_m", 0.1 + 1e-14}},
          "d")
          .issues.empty());
}

// Nor in a case: the schema's own bounds.
TEST(ReadCase, TakesNumbersOneUnitInTheLastPlaceBeyondABoundAsTheBound) {
  Json json =
      Json::parse(R"({"format": "parapet-case/1", "name": "c", "numerics": {"spacing_m": 0.01},
    "reservoir": {"length_m": 1, "height_m": 1}, "channel": {"length_m": 5}})");
  json["channel"]["slope_deg"] = std::nextafter(65.0, 100.0);
  const CaseSpec spec = parse_case(json, "c");
  EXPECT_EQ(spec.resolved["channel"]["slope_deg"], 65.0);
  json["channel"]["slope_deg"] = 65.0000001;
  EXPECT_THROW(parse_case(json, "c"), InputError);
}

// The same rules for designs as numbers.
TEST(CheckDesign, KnowsChoices) {
  const StudySpec study = parse_study(choice_study(), "s");
  const auto lines = [&](const Design& design) {
    std::vector<std::string> result;
    for (const InputIssue& issue : check_design(study, design, "d")) {
      result.push_back(to_string(issue));
    }
    return result;
  };
  const Design sound{{"barriers", 0.0}, {"deflector", 0.0}, {"upstream_height_m", 0.1}};
  EXPECT_TRUE(lines(sound).empty());
  Design design = sound;
  design["barriers"] = 1.5;
  EXPECT_EQ(lines(design), std::vector<std::string>{"d: /barriers: 1.5: is not the number of an "
                                                    "option; allowed: a whole number from 0 to 2"});
  design = sound;
  design["deflector_length_m"] = 0.05;
  EXPECT_EQ(lines(design),
            std::vector<std::string>{"d: /deflector_length_m: 0.05: does not exist under the "
                                     "options that the design takes; allowed: no value, or the "
                                     "choice deflector \"plate\""});
}

}  // namespace
}  // namespace parapet::designs
