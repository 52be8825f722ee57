#include <gtest/gtest.h>

#include "study_fixture.hpp"

namespace parapet::designs {
namespace {

std::string hash_of(const Json& case_json) {
  Json json = case_json;
  json["format"] = "parapet-case/1";
  json["name"] = "choices";
  return spec_hash(parse_case(json, "c").resolved);
}

TEST(Choices, ValuesReachTheirFields) {
  const StudySpec study = parse_study(choice_study(), "s");
  const Variable& deflector = study.variables[1];
  EXPECT_EQ(deflector.kind, VariableKind::choice);
  EXPECT_EQ(deflector.lower, 0.0);
  EXPECT_EQ(deflector.upper, 2.0);
  ASSERT_EQ(deflector.options.size(), 3U);
  EXPECT_EQ(deflector.options[0].name, "none");
  EXPECT_EQ(deflector.options[0].removes, std::vector<std::string>{"/barriers/0/deflector"});
  EXPECT_EQ(deflector.options[2].sets.at("/barriers/0/deflector/length_m"), 0.1);
  EXPECT_EQ(study.variables[2].kind, VariableKind::continuous);
  EXPECT_EQ(study.variables[2].active_when->choice, "deflector");
  EXPECT_EQ(study.variables[2].active_when->options, std::vector<int>{1});
  EXPECT_EQ(study.variables[3].kind, VariableKind::integer);
  EXPECT_EQ(study.variables[3].active_when->options, (std::vector<int>{1, 2}));
  // The last barrier is another one for two and for three; the first is always the same.
  EXPECT_EQ(study.variables[4].targets, std::vector<std::string>{"/barriers/N/height_m"});
  EXPECT_EQ(study.variables[5].targets, std::vector<std::string>{"/barriers/0/height_m"});
  EXPECT_EQ(study.method.starts[0], (Design{{"barriers", 1.0},
                                            {"deflector", 0.0},
                                            {"downstream_height_m", 0.2},
                                            {"upstream_height_m", 0.1}}));
}

TEST(Choices, ResolvedReadsBackTheSame) {
  const StudySpec study = parse_study(choice_study(), "s");
  const StudySpec again = parse_study(Json::parse(study.resolved.dump()), "s");
  EXPECT_EQ(study.resolved.dump(), again.resolved.dump());
  EXPECT_EQ(study.resolved["method"]["starts"][0]["barriers"], "two");
}

// Without a deflector the case is the same, to the hash, as one written without it.
TEST(Choices, ADeflectorTakenAwayWasNeverThere) {
  const StudySpec study = parse_study(choice_study(), "s");
  Json bare = choice_study()["case"];
  bare["barriers"][0].erase("deflector");
  bare["barriers"][0]["height_m"] = 0.12;
  bare["barriers"][2]["height_m"] = 0.24;
  const CaseSpec spec = design_case(study, {{"barriers", 2.0},
                                            {"deflector", 0.0},
                                            {"downstream_height_m", 0.24},
                                            {"upstream_height_m", 0.12}});
  EXPECT_FALSE(spec.scene.barriers[0].deflector);
  EXPECT_EQ(spec_hash(spec.resolved), hash_of(bare));
}

// One, two or three barriers; the downstream height is that of the last one.
TEST(Choices, NumberOfBarriers) {
  const StudySpec study = parse_study(choice_study(), "s");
  const Design first{{"deflector", 2.0}, {"deflector_angle_deg", 30.0}, {"upstream_height_m", 0.1}};
  Design one = first, two = first, three = first;
  one["barriers"] = 0.0;
  two["barriers"] = 1.0;
  three["barriers"] = 2.0;
  two["downstream_height_m"] = three["downstream_height_m"] = 0.15;

  const auto scene_of = [&](const Design& design) { return design_case(study, design).scene; };
  EXPECT_EQ(scene_of(one).barriers.size(), 1U);
  EXPECT_EQ(scene_of(one).barriers[0].deflector->length, 0.1);  // set by the option big
  ASSERT_EQ(scene_of(two).barriers.size(), 2U);
  EXPECT_EQ(scene_of(two).barriers[1].height, 0.15);
  ASSERT_EQ(scene_of(three).barriers.size(), 3U);
  EXPECT_EQ(scene_of(three).barriers[1].height, 0.2);
  EXPECT_EQ(scene_of(three).barriers[2].height, 0.15);

  Json bare = choice_study()["case"];
  bare["barriers"].erase(2);
  bare["barriers"].erase(1);
  bare["barriers"][0]["deflector"] = Json::parse(R"({"angle_deg": 30.0, "length_m": 0.1})");
  EXPECT_EQ(spec_hash(design_case(study, one).resolved), hash_of(bare));
}

// Each barrier, however many there are.
TEST(Choices, EachBarrier) {
  Json json = choice_study();
  json["variables"]["barrier_thickness_m"] = Json::parse(R"({"lower": 0.01, "upper": 0.02})");
  json["method"]["starts"] = Json::array();
  const StudySpec study = parse_study(json, "s");
  EXPECT_EQ(study.variables[6].targets, std::vector<std::string>{"/barriers/*/thickness_m"});
  const auto scene = design_case(study, {{"barriers", 1.0}, {"barrier_thickness_m", 0.018}}).scene;
  ASSERT_EQ(scene.barriers.size(), 2U);
  EXPECT_EQ(scene.barriers[0].thickness, 0.018);
  EXPECT_EQ(scene.barriers[1].thickness, 0.018);
}

// An option may make the place that a variable goes to, defaults included, and of two keys that
// exclude each other the one it sets stays.
TEST(Choices, OptionsMakePlaces) {
  Json json = choice_study();
  json["variables"] = Json::parse(R"({
      "layout": {"options": {
        "upright": {"set": {"/barriers/0/stem_lean_deg": 0, "/barriers/1/deflector": {"angle_deg": 20}}},
        "first_only": {"remove": ["/barriers/0"], "set": {"/barriers/0/foot_x_m": 1.3}},
        "four": {"set": {"/barriers/-": {"spacing_m": 0.4, "height_m": 0.1}}}}},
      "lean_deg": {"lower": -10, "upper": 10, "target": "/barriers/0/stem_lean_deg",
                   "active_when": {"layout": "upright"}},
      "lip_m": {"lower": 0.02, "upper": 0.05, "target": "/barriers/1/deflector/length_m",
                "active_when": {"layout": "upright"}}})");
  // What an option sets itself is not for a variable.
  json["variables"]["layout"]["options"]["upright"]["set"] =
      Json::parse(R"({"/barriers/0": {"height_m": 0.1, "stem_lean_deg": 0},
                      "/barriers/1/deflector": {"angle_deg": 20}})");
  json["objectives"].erase(1);
  json.erase("method");
  const StudySpec study = parse_study(json, "s");
  const auto upright =
      design_case(study, {{"layout", 0.0}, {"lean_deg", 5.0}, {"lip_m", 0.03}}).scene;
  EXPECT_NEAR(upright.barriers[0].stem_lean, 5.0 * 3.14159265358979 / 180.0, 1e-14);
  EXPECT_EQ(upright.barriers[1].deflector->length, 0.03);
  const auto shorter = design_case(study, {{"layout", 1.0}}).scene;
  ASSERT_EQ(shorter.barriers.size(), 2U);
  EXPECT_EQ(shorter.barriers[0].foot_x, 1.3);
  EXPECT_EQ(design_case(study, {{"layout", 2.0}}).scene.barriers.size(), 4U);
}

// Two variables of one place are sound when they never exist together.
TEST(Choices, VariablesThatExcludeEachOtherShareAPlace) {
  Json json = choice_study();
  json["variables"]["lip_m"] =
      Json::parse(R"({"lower": 0.08, "upper": 0.1, "target": "/barriers/0/deflector/length_m",
                      "active_when": {"deflector": "large"}})");
  json["variables"]["deflector"]["options"]["large"] = Json::object();
  EXPECT_NO_THROW(parse_study(json, "s"));
}

TEST(Choices, ActiveVariablesAndNames) {
  const StudySpec study = parse_study(choice_study(), "s");
  const Design design{{"barriers", 0.0}, {"deflector", 1.0}};
  EXPECT_TRUE(is_active(study, study.variables[2], design));
  EXPECT_FALSE(is_active(study, study.variables[4], design));
  EXPECT_TRUE(is_active(study, study.variables[5], design));
  EXPECT_FALSE(is_active(study, study.variables[2], {}));
  EXPECT_EQ(option_names(study, design),
            (std::map<std::string, std::string>{{"barriers", "one"}, {"deflector", "plate"}}));
}

// A choice that is inactive takes those that depend on it along.
TEST(Choices, ConditionsChain) {
  Json json = choice_study();
  json["variables"] = Json::parse(R"({
      "deflector": {"options": {"none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
      "datum": {"options": {"bed": {"set": {"/barriers/0/deflector/datum": "bed"}}, "world": {}},
                "active_when": {"deflector": "plate"}},
      "upstream_height_m": {"lower": 0.08, "upper": 0.1, "active_when": {"datum": "bed"}}})");
  json["objectives"].erase(1);
  json.erase("method");
  const StudySpec study = parse_study(json, "s");
  EXPECT_TRUE(check_design(study, {{"deflector", 0.0}}, "d").empty());
  EXPECT_FALSE(is_active(study, study.variables[2], {{"deflector", 0.0}, {"datum", 0.0}}));
  EXPECT_EQ(check_design(study, {{"deflector", 0.0}, {"datum", 0.0}}, "d").size(), 1U);
  const auto issues = check_design(study, {{"deflector", 1.0}, {"datum", 0.0}}, "d");
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues[0].pointer, "/upstream_height_m");
}

// A plate that is not there has no length, and a choice counts as its option's number.
TEST(Choices, ExpressionsCountWhatIsNotThereAsZero) {
  const StudySpec study = parse_study(choice_study(), "s");
  const std::string plate = study.objectives[1].expression;
  EXPECT_DOUBLE_EQ(
      evaluate_expression(study, plate,
                          {{"barriers", 0.0}, {"deflector", 0.0}, {"upstream_height_m", 0.1}}),
      0.1);
  EXPECT_DOUBLE_EQ(evaluate_expression(study, plate,
                                       {{"barriers", 1.0},
                                        {"deflector", 1.0},
                                        {"deflector_length_m", 0.05},
                                        {"downstream_height_m", 0.2},
                                        {"upstream_height_m", 0.1}}),
                   0.35);
  EXPECT_DOUBLE_EQ(evaluate_expression(study, "10 * (barriers + 1)", {{"barriers", 2.0}}), 30.0);
}

// What a search may get wrong is found before a case is made of it.
TEST(Choices, DesignCaseRefusesWhatDoesNotExist) {
  const StudySpec study = parse_study(choice_study(), "s");
  EXPECT_THROW(design_case(study, {{"barriers", 3.0}}), InputError);
  EXPECT_THROW(design_case(study, {{"barriers", 0.5}}), InputError);
  EXPECT_THROW(design_case(study, {{"barriers", 0.0}, {"downstream_height_m", 0.2}}), InputError);
}

// The check of a study goes through every combination, and so there is a limit.
TEST(Choices, TooManyCombinations) {
  Json json = choice_study();
  for (int k = 0; k < 10; ++k) {
    json["variables"]["choice_" + std::to_string(k)] =
        Json::parse(R"({"options": {"a": {}, "b": {}}})");
  }
  json["method"]["starts"] = Json::array();
  try {
    parse_study(json, "s");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].pointer, "/variables");
    EXPECT_NE(error.issues()[0].problem.find("more than 1000 combinations"), std::string::npos);
  }
}

}  // namespace
}  // namespace parapet::designs
