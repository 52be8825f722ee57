#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "study_fixture.hpp"

namespace parapet::designs {
namespace {

// Everything a study states arrives in its field; what it leaves out takes the default.
TEST(StudySpec, ValuesReachTheirFields) {
  const StudySpec study = parse_study(sound_study(), "folder/study.json");
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.source_file, "folder/study.json");
  ASSERT_EQ(study.variables.size(), 3U);
  EXPECT_EQ(study.variables[0].name, "deflector_angle_deg");  // the order of the file
  EXPECT_EQ(study.variables[0].targets,
            std::vector<std::string>{"/barriers/0/deflector/angle_deg"});
  EXPECT_EQ(study.variables[2].targets, std::vector<std::string>{"/barriers/0/deflector/length_m"});
  EXPECT_EQ(study.variables[2].lower, 0.03);
  EXPECT_EQ(study.variables[2].upper, 0.1);

  ASSERT_EQ(study.objectives.size(), 2U);
  EXPECT_EQ(study.objectives[0].goal, Goal::maximize);
  EXPECT_EQ(study.objectives[0].weight, 1.0);
  EXPECT_FALSE(study.objectives[0].value_when_absent);
  EXPECT_EQ(study.objectives[1].goal, Goal::minimize);
  EXPECT_EQ(study.objectives[1].weight, 0.5);
  EXPECT_EQ(study.objectives[1].scale, 0.4);
  EXPECT_EQ(study.objectives[1].value_when_absent, 0.0);

  ASSERT_EQ(study.constraints.size(), 2U);
  EXPECT_EQ(study.constraints[0].name, "material");
  EXPECT_EQ(study.constraints[0].expression, "upstream_height_m + plate_m");
  EXPECT_FALSE(study.constraints[0].lower);
  EXPECT_EQ(study.constraints[0].scale, 0.19);  // the limit's size
  EXPECT_EQ(study.constraints[1].name, "barrier_2_slam_force_n_per_m");
  EXPECT_EQ(study.constraints[1].lower, 0.0);
  EXPECT_EQ(study.constraints[1].upper, 400.0);
  EXPECT_EQ(study.constraints[1].scale, 400.0);
  EXPECT_TRUE(study.constraints[1].satisfied_when_absent);

  EXPECT_EQ(study.method.max_evaluations, 20);
  EXPECT_EQ(study.method.start_count, 3);
  ASSERT_EQ(study.method.starts.size(), 1U);
  EXPECT_EQ(study.method.starts[0].at("plate_m"), 0.05);
}

// The schema's defaults of a method, an objective and a constraint are the structs' own.
TEST(StudyDefaults, AreTheStructDefaults) {
  Json json = sound_study();
  json.erase("method");
  json.erase("constraints");
  json["objectives"] = Json::parse(R"([{"metric": "retention_efficiency"}])");
  const StudySpec study = parse_study(json, "s");
  const Method expected;
  EXPECT_EQ(study.method.algorithm, expected.algorithm);
  EXPECT_EQ(study.method.local_algorithm, expected.local_algorithm);
  EXPECT_EQ(study.method.max_evaluations, expected.max_evaluations);
  EXPECT_EQ(study.method.max_time_s, expected.max_time_s);
  EXPECT_EQ(study.method.relative_tolerance, expected.relative_tolerance);
  EXPECT_EQ(study.method.seed, expected.seed);
  EXPECT_EQ(study.method.starts, expected.starts);
  EXPECT_EQ(study.method.start_count, expected.start_count);
  EXPECT_EQ(study.method.initial_step, expected.initial_step);
  EXPECT_EQ(study.objectives[0].goal, Objective{}.goal);
  EXPECT_EQ(study.objectives[0].weight, Objective{}.weight);
  EXPECT_EQ(study.objectives[0].scale, Objective{}.scale);
  json["constraints"] = Json::parse(R"([{"metric": "retention_efficiency", "lower": 0}])");
  const Constraint constraint = parse_study(json, "s").constraints.at(0);
  EXPECT_EQ(constraint.scale, Constraint{}.scale);  // a limit of 0 has no size
  EXPECT_EQ(constraint.satisfied_when_absent, Constraint{}.satisfied_when_absent);
}

// The resolved study reads back as the same study.
TEST(StudySpec, ResolvedReadsBackTheSame) {
  const StudySpec study = parse_study(sound_study(), "s");
  const StudySpec again = parse_study(Json::parse(study.resolved.dump()), "s");
  EXPECT_EQ(study.resolved.dump(), again.resolved.dump());
  EXPECT_EQ(study.base_case.dump(), again.base_case.dump());
  EXPECT_EQ(spec_hash(study.resolved), spec_hash(again.resolved));
}

// The names that Parapet knows vary what they say.
TEST(StudySpec, KnownNamesReachTheScene) {
  Json json = sound_study();
  json["case"]["barriers"][1]["deflector"] = Json::object();
  json["variables"] = Json::parse(R"({
      "deflector_angle_deg": {"lower": 0, "upper": 75},
      "deflector_length_m": {"lower": 0.03, "upper": 0.1},
      "upstream_height_m": {"lower": 0.06, "upper": 0.16},
      "downstream_height_m": {"lower": 0.1, "upper": 0.3},
      "barrier_spacing_m": {"lower": 0.3, "upper": 0.9},
      "upstream_foot_x_m": {"lower": 0.8, "upper": 1.3},
      "barrier_thickness_m": {"lower": 0.01, "upper": 0.03},
      "downstream_deflector_angle_deg": {"lower": 0, "upper": 75},
      "slope_deg": {"lower": 20, "upper": 30},
      "yield_stress_pa": {"lower": 50, "upper": 150}})");
  json.erase("constraints");
  json.erase("method");
  const StudySpec study = parse_study(json, "s");
  const CaseSpec spec = design_case(study, {{"deflector_angle_deg", 33.3},
                                            {"deflector_length_m", 0.07},
                                            {"upstream_height_m", 0.12},
                                            {"downstream_height_m", 0.2},
                                            {"barrier_spacing_m", 0.5},
                                            {"upstream_foot_x_m", 1.0},
                                            {"barrier_thickness_m", 0.02},
                                            {"downstream_deflector_angle_deg", 12.0},
                                            {"slope_deg", 21.0},
                                            {"yield_stress_pa", 77.0}});
  constexpr double radian = std::numbers::pi / 180.0;
  const solver::Barrier &first = spec.scene.barriers[0], &last = spec.scene.barriers[1];
  EXPECT_DOUBLE_EQ(first.deflector->angle, 33.3 * radian);
  EXPECT_EQ(first.deflector->length, 0.07);
  EXPECT_EQ(first.height, 0.12);
  EXPECT_EQ(first.foot_x, 1.0);
  EXPECT_EQ(first.thickness, 0.02);
  EXPECT_EQ(last.thickness, 0.02);
  EXPECT_EQ(last.height, 0.2);
  EXPECT_DOUBLE_EQ(last.foot_x, 1.5);
  EXPECT_DOUBLE_EQ(last.deflector->angle, 12.0 * radian);
  EXPECT_DOUBLE_EQ(spec.scene.slope, 21.0 * radian);
  EXPECT_EQ(spec.scene.material.yield_stress, 77.0);
  // The resolved case of a design holds its values verbatim.
  EXPECT_EQ(spec.resolved["barriers"][0]["deflector"]["angle_deg"].get<double>(), 33.3);
}

// One variable may drive several inputs.
TEST(StudySpec, SeveralTargets) {
  Json json = sound_study();
  json["variables"]["upstream_height_m"] = Json::parse(
      R"({"lower": 0.05, "upper": 0.3, "targets": ["/barriers/0/height_m", "/barriers/1/height_m"]})");
  const CaseSpec spec = design_case(parse_study(json, "s"), {{"upstream_height_m", 0.2}});
  EXPECT_EQ(spec.scene.barriers[0].height, 0.2);
  EXPECT_EQ(spec.scene.barriers[1].height, 0.2);
}

// Without a second barrier there is nothing downstream to vary.
TEST(StudySpec, DownstreamNamesNeedASecondBarrier) {
  Json json = sound_study();
  json["case"]["barriers"].erase(1);
  json["constraints"].erase(1);
  json["variables"]["downstream_height_m"] = Json::parse(R"({"lower": 0.1, "upper": 0.2})");
  try {
    parse_study(json, "s");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_NE(error.issues()[0].problem.find("needs a barrier that the case does not have"),
              std::string::npos);
  }
}

// A design that makes the scene impossible says which variable did it.
TEST(DesignCase, NamesTheVariableOfAnImpossibleScene) {
  const StudySpec study = parse_study(sound_study(), "study.json");
  try {
    design_case(study, {{"upstream_height_m", 5.0}});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].file, "study.json");
  }
  try {
    design_case(study, {{"upstream_height_m", -1.0}});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].pointer, "/case/barriers/0/height_m");
    EXPECT_NE(error.issues()[0].problem.find("set by the variable upstream_height_m"),
              std::string::npos);
  }
  EXPECT_THROW(design_case(study, {{"height", 0.1}}), InputError);
}

// Missing, unknown and out-of-bounds values, all at once.
TEST(CheckDesign, FindsEverything) {
  const StudySpec study = parse_study(sound_study(), "s");
  EXPECT_TRUE(
      check_design(study,
                   {{"deflector_angle_deg", 0.0}, {"upstream_height_m", 0.16}, {"plate_m", 0.05}},
                   "--design")
          .empty());
  const auto issues = check_design(
      study, {{"deflector_angle", 20.0}, {"upstream_height_m", 0.5}, {"plate_m", 0.05}},
      "--design");
  ASSERT_EQ(issues.size(), 3U);
  EXPECT_EQ(to_string(issues[0]),
            "--design: /deflector_angle_deg: is missing; allowed: a number from 0.0 to 75.0 [deg]");
  EXPECT_EQ(to_string(issues[1]),
            "--design: /upstream_height_m: 0.5: is outside the variable's bounds; allowed: a "
            "number from 0.06 to 0.16 [m]");
  EXPECT_EQ(issues[2].pointer, "/deflector_angle");
  EXPECT_NE(issues[2].problem.find("did you mean \"deflector_angle_deg\"?"), std::string::npos);
}

class StudyOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("parapet_") + test->name());
    std::filesystem::create_directories(folder_ / "cases");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  std::filesystem::path folder_;
};

// case_file is relative to the study, and the resolved study no longer needs it.
TEST_F(StudyOnDisk, ReadsItsCaseFile) {
  Json study = sound_study();
  Json inner = study["case"];
  inner["format"] = "parapet-case/1";
  inner["name"] = "of its own";
  study.erase("case");
  study["case_file"] = "cases/base.json";
  write("cases/base.json", inner.dump());
  write("study.json", study.dump());
  const StudySpec spec = load_study(folder_ / "study.json");
  EXPECT_EQ(spec.base_case.at("name"), "of its own");
  EXPECT_FALSE(spec.resolved.contains("case_file"));
  EXPECT_EQ(parse_study(spec.resolved, "elsewhere").base_case.dump(), spec.base_case.dump());
}

// A mistake in the case file is reported there.
TEST_F(StudyOnDisk, BlamesTheCaseFile) {
  Json study = sound_study();
  study.erase("case");
  study["case_file"] = "cases/base.json";
  write("cases/base.json",
        R"({"format": "parapet-case/1", "name": "x", "barriers": [{"height": 1}]})");
  write("study.json", study.dump());
  try {
    load_study(folder_ / "study.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    EXPECT_EQ(error.issues()[0].file, (folder_ / "cases/base.json").string());
    EXPECT_EQ(error.issues()[0].pointer, "/barriers/0/height");
  }
}

}  // namespace
}  // namespace parapet::designs
