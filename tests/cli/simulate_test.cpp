// parapet simulate: its files, and that threads change nothing but the timing.
#include <gtest/gtest.h>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

TEST(Simulate, WritesResultAndSeries) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome outcome = run_program(folder.path(), {"simulate", "case.json", "--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto out = folder / "runs/tiny-simulate";
  const std::string text = file_text(out / "result.json");
  EXPECT_TRUE(text.ends_with("}\n"));
  const Json result = Json::parse(text);
  EXPECT_EQ(result["format"], "parapet-result/1");
  EXPECT_EQ(result["status"], "ok");
  EXPECT_EQ(result["name"], "tiny");
  EXPECT_EQ(result["provenance"]["spacing_m"], 0.02);
  EXPECT_EQ(result["provenance"]["integrator"], "implicit_viscosity");
  EXPECT_FALSE(result["provenance"].contains("threads"));
  EXPECT_EQ(result["timing"]["threads"], 1);
  EXPECT_EQ(result["case"]["format"], "parapet-case/1");
  const Json& mass = result["mass"];
  // The block is 0.2 m x 0.1 m of 1135 kg/m3, filled exactly by the lattice.
  EXPECT_NEAR(mass["released_kg_per_m"].get<double>(), 22.7, 1e-9);
  for (const auto& [key, value] : result["metrics"].items()) {
    EXPECT_EQ(value.is_null(), result["metrics_absent"].contains(key)) << key;
  }
  const std::string series = file_text(out / "series.csv");
  EXPECT_TRUE(series.starts_with("time_s,"));
  // A sample every 0.035 sqrt(H0/g) = 3.54 ms of half a second, the first at 0, and the header.
  EXPECT_EQ(line_count(out / "series.csv"), 143U);
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "nan", series);
}

// With the run without barriers, the result says which coefficient of a hand formula gives its
// load.
TEST(Simulate, ComparesTheLoadWithTheUndisturbedFlow) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  spec["gauges"] = {{"depth_window_ratio", 1.0}, {"front_mass_share", 0.05}};  // of 50 particles
  folder.write("case.json", spec.dump());
  const Outcome outcome =
      run_program(folder.path(), {"simulate", "case.json", "--out", "out", "--approach"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "alpha of alpha rho v^2 h ", outcome.out);
  const Json result = Json::parse(file_text(folder / "out/result.json"));
  const Json approach = Json::parse(file_text(folder / "out/approach.json"));
  const Json& flow = approach["barriers"][0];
  EXPECT_EQ(result["case"]["approach"][0]["flow_depth_max_m"], flow["flow_depth_max_m"]);
  const double v = flow["front_velocity_m_s"].get<double>(),
               h = flow["flow_depth_max_m"].get<double>();
  const double force = result["metrics"]["barrier_1_design_force_n_per_m"].get<double>();
  EXPECT_NEAR(result["metrics"]["barrier_1_hydrodynamic_coefficient"].get<double>(),
              force / (1135.0 * v * v * h), 1e-9);
  EXPECT_EQ(flow["hydrostatic_coefficient"],
            result["metrics"]["barrier_1_hydrostatic_coefficient"]);
  EXPECT_EQ(approach["profile"]["x_m"].size(), approach["profile"]["flow_depth_max_m"].size());
  // without it they are absent, and nothing else is changed
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
  const Json plain = Json::parse(file_text(folder / "out/result.json"));
  EXPECT_TRUE(plain["metrics"]["barrier_1_hydrodynamic_coefficient"].is_null());
  EXPECT_EQ(plain["metrics"]["barrier_1_design_force_n_per_m"], force);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/approach.json")) << "of the run before";
}

TEST(Simulate, ApproachNeedsABarrier) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  spec.erase("barriers");
  folder.write("case.json", spec.dump());
  const Outcome outcome = run_program(folder.path(), {"simulate", "case.json", "--approach"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "there is no barrier to approach", outcome.err);
}

TEST(Simulate, WritesThePressuresOfTheDesignLoad) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome outcome =
      run_program(folder.path(), {"simulate", "case.json", "--out", "out", "--picture"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json result = Json::parse(file_text(folder / "out/result.json"));
  ASSERT_EQ(result["loads"].size(), 2U) << "stem and deflector";
  std::size_t strips = 0;
  for (const Json& part : result["loads"]) {
    double force = 0.0;
    for (std::size_t k = 0; k < part["pressure_pa"].size(); ++k, ++strips) {
      force += part["pressure_pa"][k].get<double>() *
               (part["edge_m"][k + 1].get<double>() - part["edge_m"][k].get<double>());
    }
    EXPECT_NEAR(force, part["normal_force_n_per_m"].get<double>(), 1e-9);
  }
  EXPECT_EQ(line_count(folder / "out/pressure.csv"), strips + 1);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/pressure.png"));
}

TEST(Simulate, PrintsASummaryAndWithAllEveryMetric) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome brief = run_program(folder.path(), {"simulate", "case.json", "--out", "out"});
  ASSERT_EQ(brief.exit_code, 0) << brief.err;
  for (const char* words : {"  held back ", " % of the debris", "  load on barrier 1 ", " N/m"}) {
    EXPECT_PRED_FORMAT2(IsSubstring, words, brief.out);
  }
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "retention_efficiency", brief.out);
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, " in 0 s", brief.out);  // it took some time
  const Outcome whole =
      run_program(folder.path(), {"simulate", "case.json", "--out", "out", "--all"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const Json result = Json::parse(file_text(folder / "out/result.json"));
  EXPECT_PRED_FORMAT2(IsSubstring, "  held back ", whole.out);
  for (const auto& [key, value] : result["metrics"].items()) {
    EXPECT_PRED_FORMAT2(IsSubstring, "  " + key + " ", whole.out);
  }
}

TEST(Simulate, ThreadsChangeNothingButTheTiming) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  // Enough particles that two threads really share the work (blocks of 128).
  spec["numerics"]["spacing_m"] = 0.01;
  spec["run"]["stop_time_s"] = 0.25;
  folder.write("case.json", spec.dump());
  std::vector<std::string> results, series;
  for (const char* threads : {"1", "2"}) {
    const std::string out = std::string("threads-") + threads;
    const Outcome outcome =
        run_program(folder.path(), {"simulate", "case.json", "--threads", threads, "--out", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    Json result = Json::parse(file_text(folder / out / "result.json"));
    EXPECT_EQ(result["timing"]["threads"], std::stoi(threads));
    result.erase("timing");
    results.push_back(result.dump());
    series.push_back(file_text(folder / out / "series.csv"));
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(series[0], series[1]);
}

TEST(Simulate, JobsRunSideBySideWithUncertaintyAndChangeNoResult) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  spec["run"]["stop_time_s"] = 0.1;
  folder.write("case.json", spec.dump());
  std::vector<std::string> results;
  for (const char* jobs : {"1", "2"}) {
    const std::string out = std::string("jobs-") + jobs;
    const Outcome outcome = run_program(
        folder.path(), {"simulate", "case.json", "--uncertainty", "--jobs", jobs, "--out", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    Json result = Json::parse(file_text(folder / out / "result.json"));
    EXPECT_EQ(result["timing"]["threads"], 1);
    EXPECT_FALSE(result["uncertainty"]["retention_efficiency"].is_null());
    result.erase("timing");
    results.push_back(result.dump());
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(Simulate, FramesAndPictureChangeNoResult) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome plain =
      run_program(folder.path(), {"simulate", "case.json", "--threads", "1", "--out", "plain"});
  const Outcome rich = run_program(
      folder.path(), {"simulate", "case.json", "--threads", "1", "--out", "rich", "--frames",
                      "--frame-interval-s", "0.1", "--picture-times-s", "0.1,0.4,3"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  ASSERT_EQ(rich.exit_code, 0) << rich.err;
  EXPECT_EQ(file_text(folder / "plain/series.csv"), file_text(folder / "rich/series.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "rich/flow.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "rich/frames/tiny.pvd"));
  EXPECT_PRED_FORMAT2(IsSubstring, "6 frames", rich.err);  // 0, 0.1 ... 0.5 s
  EXPECT_PRED_FORMAT2(IsSubstring, "no picture at 3", rich.err);
  EXPECT_FALSE(std::filesystem::exists(folder / "plain/frames"));
}

TEST(Simulate, ProfilePrintsATableAndChangesNothingButTheTiming) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  std::vector<std::string> results;
  Json profile;
  for (const std::string out : {"plain", "measured"}) {
    std::vector<std::string> arguments = {"simulate", "case.json", "--threads", "1", "--out", out};
    if (out == "measured") arguments.push_back("--profile");
    const Outcome outcome = run_program(folder.path(), arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    if (out == "plain") {
      EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "profile", outcome.out);
    } else {
      for (const char* part :
           {"profile\n", "M pairs/s", "after the last change of any metric", "pressure force",
            "conjugate gradients", "neighbour rows renewed", "limited by: sound speed in"}) {
        EXPECT_PRED_FORMAT2(IsSubstring, part, outcome.out);
      }
    }
    Json result = Json::parse(file_text(folder / out / "result.json"));
    profile = result["timing"].value("profile", Json());
    EXPECT_EQ(profile.is_null(), out == "plain");
    result.erase("timing");
    results.push_back(result.dump());
  }
  EXPECT_EQ(results[0], results[1]);
  double share = 0.0;
  for (const Json& stage : profile["stages"]) share += stage["share"].get<double>();
  EXPECT_NEAR(share, 1.0, 1e-9);  // rounding alone
}

TEST(Simulate, FailedRunIsARecordedResultAndExitCodeOne) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  make_unsolvable(spec);
  folder.write("case.json", spec.dump());
  const Outcome outcome = run_program(folder.path(), {"simulate", "case.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "the run failed", outcome.err);
  const Json result = Json::parse(file_text(folder / "out/result.json"));
  EXPECT_EQ(result["status"], "failed");
  EXPECT_NE(result["reason"], "");
}

TEST(Simulate, QuietSaysNothingOnStandardError) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome outcome = run_program(folder.path(), {"simulate", "case.json", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace parapet::test
