// parapet optimize, recommend and table3 on tiny specs.
#include <gtest/gtest.h>

#include <set>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

/// Lines of the log that are no refused designs.
std::vector<Json> log_lines(const std::filesystem::path& file) {
  std::vector<Json> lines;
  const std::string text = file_text(file);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    Json line = Json::parse(text.substr(begin, end - begin));
    if (line["status"] != "refused") lines.push_back(std::move(line));
    begin = end + 1;
  }
  return lines;
}

// The event is simulated without barriers once; every design's load is compared with it.
TEST(Optimize, SimulatesTheEventWithoutBarriersOnce) {
  const TemporaryFolder folder;
  Json spec = tiny_study();
  spec["case"]["gauges"] = {{"depth_window_ratio", 1.0}, {"front_mass_share", 0.05}};
  spec["method"]["max_evaluations"] = 8;
  folder.write("study.json", spec.dump());
  const std::vector<std::string> command{"optimize", "study.json", "--out", "out"};
  ASSERT_EQ(run_program(folder.path(), command).exit_code, 0);
  const auto lines = log_lines(folder / "out/evaluations.jsonl");
  ASSERT_FALSE(lines.empty());
  for (const Json& line : lines) {
    EXPECT_GT(line["metrics"]["barrier_1_hydrodynamic_coefficient"].get<double>(), 0.0);
  }
  const auto written = std::filesystem::last_write_time(folder / "out/approach.json");
  ASSERT_EQ(run_program(folder.path(), command).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "out/approach.json"), written);
  const Outcome same = run_program(folder.path(), {"verify", "out", "--all"});
  EXPECT_EQ(same.exit_code, 0) << same.out;
  const Outcome advice = run_program(folder.path(), {"recommend", "out", "--no-confirm"});
  EXPECT_PRED_FORMAT2(IsSubstring, "## Loads against the hand formulas", advice.out);
}

TEST(Optimize, WritesTheWholeStudyFolder) {
  const TemporaryFolder folder;
  folder.write("study.json", tiny_study().dump());
  const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--jobs", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto out = folder / "runs/tiny-optimize";
  const Json state = Json::parse(file_text(out / "study.json"));
  EXPECT_EQ(state["format"], "parapet-study-state/2");
  EXPECT_EQ(state["spec"]["method"]["seed"], 1) << "defaults are written out";
  const Json summary = Json::parse(file_text(out / "summary.json"));
  EXPECT_EQ(summary["state"], "done");
  EXPECT_EQ(summary["spec_hash"], state["spec_hash"]);
  const auto lines = log_lines(out / "evaluations.jsonl");
  EXPECT_EQ(summary["evaluations"], lines.size());
  EXPECT_LE(lines.size(), 16U) << "max_evaluations";
  double lowest = 1e300;
  int starts = 0;
  for (const Json& line : lines) {
    const std::string id = line["id"].get<std::string>();
    const Json report = Json::parse(file_text(out / "evaluations" / (id + ".json")));
    EXPECT_EQ(report["metrics"], line["metrics"]);
    EXPECT_EQ(report["provenance"]["spec_hash"], state["spec_hash"]);
    EXPECT_TRUE(line["constraints"][0]["satisfied"].get<bool>())
        << "designs that an expression refuses are never simulated";
    if (line["stage"] == "start") ++starts;
    if (line["feasible"].get<bool>()) {
      lowest = std::min(lowest, line["objective_scalar"].get<double>());
    }
  }
  EXPECT_EQ(starts, 4);
  EXPECT_EQ(summary["best"]["objective_scalar"].get<double>(), lowest);
  EXPECT_LE(lowest, summary["starting_best"]["objective_scalar"].get<double>());
  EXPECT_PRED_FORMAT2(IsSubstring, "best feasible design", outcome.out);

  const Outcome advice = run_program(folder.path(), {"recommend", "runs/tiny-optimize"});
  ASSERT_EQ(advice.exit_code, 0) << advice.err;
  const Json recommendation = Json::parse(file_text(out / "recommendation.json"));
  EXPECT_EQ(recommendation["format"], "parapet-recommendation/1");
  EXPECT_FALSE(file_text(out / "recommendation.md").empty());
}

TEST(Optimize, SeveralJobsLogTheSameDesignsUnderTheSameIds) {
  const TemporaryFolder folder;
  folder.write("study.json", tiny_study().dump());
  std::vector<std::map<std::string, Json>> designs;
  for (const char* jobs : {"1", "3"}) {
    const std::string out = std::string("jobs-") + jobs;
    const Outcome outcome =
        run_program(folder.path(), {"optimize", "study.json", "--jobs", jobs, "--out", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    designs.emplace_back();
    for (Json& line : log_lines(folder / out / "evaluations.jsonl")) {
      for (const char* key : {"wall_time_s", "cpu_time_s", "crc32c"}) line.erase(key);
      designs.back()[line["id"].get<std::string>()] = line;
    }
  }
  EXPECT_EQ(designs[0], designs[1]);
}

TEST(Optimize, SearchOverScenariosEndsWithATableOfTheFront) {
  const TemporaryFolder folder;
  folder.write("study.json", tiny_search().dump());
  const Outcome outcome =
      run_program(folder.path(), {"optimize", "study.json", "--jobs", "2", "--out", "out"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json pareto = Json::parse(file_text(folder / "out/pareto.json"));
  EXPECT_EQ(pareto["format"], "parapet-pareto/1");
  ASSERT_GE(pareto["designs"].size(), 1U);
  EXPECT_EQ(Json::parse(file_text(folder / "out/surrogates.json"))["format"],
            "parapet-surrogates/1");
  for (const Json& design : pareto["designs"]) {
    EXPECT_PRED_FORMAT2(IsSubstring, design["id"].get<std::string>(), outcome.out);
    EXPECT_TRUE(design["objectives"][0]["lower_95"].is_number());
    EXPECT_EQ(design["objectives"][1]["value"], design["objectives"][1]["estimate"])
        << "a formula is known";
  }
  EXPECT_PRED_FORMAT2(IsSubstring, "barrier_1_slam_force_n_per_m", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "hypervolume", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "(search, 20 mm)", outcome.err);
  for (const Json& line : log_lines(folder / "out/evaluations.jsonl")) {
    if (line["status"] != "ok") continue;
    double worst = 0.0;
    for (const Json& scenario : line["scenarios"]) {
      worst = std::max(worst, scenario["metrics"]["barrier_1_slam_force_n_per_m"].get<double>());
    }
    EXPECT_EQ(line["objectives"][0]["value"].get<double>(), worst);
  }
}

TEST(Optimize, ChoiceBetweenDeflectorAndNoneIsSearched) {
  const TemporaryFolder folder;
  Json study = tiny_study();
  study["constraints"].erase(0);
  study["variables"] = Json::parse(R"({
    "deflector": {"options": {"none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
    "deflector_angle_deg": {"lower": 0, "upper": 60, "active_when": {"deflector": "plate"}},
    "upstream_height_m": {"lower": 0.04, "upper": 0.1}})");
  study["method"] = Json::parse(R"({"algorithm": "BAYESIAN", "max_evaluations": 8})");
  folder.write("study.json", study.dump());
  const Outcome outcome =
      run_program(folder.path(), {"optimize", "study.json", "--jobs", "2", "--out", "out"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::set<std::string> options;
  for (const Json& line : log_lines(folder / "out/evaluations.jsonl")) {
    options.insert(line["options"]["deflector"].get<std::string>());
    EXPECT_EQ(line["design"].contains("deflector_angle_deg"),
              line["options"]["deflector"] == "plate");
  }
  EXPECT_EQ(options, (std::set<std::string>{"none", "plate"}));
  EXPECT_EQ(run_program(folder.path(), {"recommend", "out"}).exit_code, 0);
}

TEST(Optimize, EveryDesignFailingIsExitCodeOneWithALog) {
  const TemporaryFolder folder;
  Json study = tiny_study();
  make_unsolvable(study["case"]);
  folder.write("study.json", study.dump());
  const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "the study failed", outcome.err);
  for (const Json& line : log_lines(folder / "out/evaluations.jsonl")) {
    EXPECT_EQ(line["status"], "failed");
    EXPECT_NE(line["reason"], "");
  }
  EXPECT_EQ(Json::parse(file_text(folder / "out/summary.json"))["state"], "failed");
}

TEST(Table3, RunsChosenRowsOfTheShippedSweepCoarsely) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(
      folder.path(), {"table3", "--only", "H10-D45", "--spacing-mm", "25", "--jobs", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "H10-D45", outcome.out);
  const auto out = folder / "runs/table3-25mm";
  const Json table = Json::parse(file_text(out / "table3.json"));
  EXPECT_EQ(table["spacing_m"], 0.025);
  ASSERT_EQ(table["rows"].size(), 1U);
  EXPECT_EQ(table["rows"][0]["id"], "H10-D45");
  EXPECT_EQ(table["rows"][0]["status"], "ok");
  EXPECT_TRUE(table["rows"][0].contains("paper"));
  EXPECT_EQ(Json::parse(file_text(out / "rows/H10-D45.json"))["format"], "parapet-result/1");
}

TEST(Table3, KeepsFinishedRows) {
  const TemporaryFolder folder;
  folder.write("sweep.json", tiny_sweep().dump());
  const Outcome first = run_program(
      folder.path(), {"table3", "sweep.json", "--only", "flat", "--out", "out", "--jobs", "2"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string flat = file_text(folder / "out/rows/flat.json");
  const Outcome second =
      run_program(folder.path(), {"table3", "sweep.json", "--out", "out", "--jobs", "2"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "flat: finished before, not run again", second.err);
  EXPECT_EQ(file_text(folder / "out/rows/flat.json"), flat) << "wall time included";
  const Json table = Json::parse(file_text(folder / "out/tiny.json"));
  ASSERT_EQ(table["rows"].size(), 3U);
  EXPECT_EQ(table["rows"][0]["id"], "bare") << "the sweep's order, not that of finishing";
}

TEST(Table3, RefusesRowsOfAnotherSpec) {
  const TemporaryFolder folder;
  folder.write("sweep.json", tiny_sweep().dump());
  ASSERT_EQ(run_program(folder.path(), {"table3", "sweep.json", "--out", "out"}).exit_code, 0);
  const std::string before = file_text(folder / "out/rows/flat.json");
  const Outcome outcome =
      run_program(folder.path(), {"table3", "sweep.json", "--out", "out", "--spacing-mm", "25"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "computed from another spec", outcome.err);
  EXPECT_EQ(file_text(folder / "out/rows/flat.json"), before);
}

TEST(Table3, FailedRowIsExitCodeOne) {
  const TemporaryFolder folder;
  Json sweep = tiny_sweep();
  make_unsolvable(sweep["rows"][1]["changes"]);
  folder.write("sweep.json", sweep.dump());
  const Outcome outcome = run_program(folder.path(), {"table3", "sweep.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "row lifted failed", outcome.err);
  EXPECT_EQ(Json::parse(file_text(folder / "out/tiny.json"))["rows"].size(), 3U);
}

}  // namespace
}  // namespace parapet::test
