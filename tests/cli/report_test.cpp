// Recordings and report.html from the command line.
#include <gtest/gtest.h>

#include <algorithm>

#include "parapet/records/flow_recording.hpp"
#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;
namespace fs = std::filesystem;

/// The data that a page shows.
Json page_data(const fs::path& file) {
  const std::string html = file_text(file);
  const std::string begin = "<script type=\"application/json\" id=\"page-data\">";
  const std::size_t at = html.find(begin) + begin.size();
  return Json::parse(html.substr(at, html.find("</script>", at) - at));
}

/// A result without what may differ between repeats.
Json repeatable(const fs::path& file) {
  Json result = Json::parse(file_text(file));
  result.erase("timing");
  return result;
}

TEST(Report, ARecordingChangesNoBitOfTheResult) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  const Outcome plain = run_program(folder.path(), {"simulate", "case.json", "--out", "plain"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  const Outcome seen =
      run_program(folder.path(), {"simulate", "case.json", "--out", "seen", "--record", "--frames",
                                  "--frame-interval-s", "0.013", "--record-interval-s", "0.017"});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_EQ(repeatable(folder / "plain/result.json"), repeatable(folder / "seen/result.json"));
  EXPECT_EQ(file_text(folder / "plain/series.csv"), file_text(folder / "seen/series.csv"));
  const auto recording = records::read_recording(file_text(folder / "seen/recording.flow"));
  const double end = repeatable(folder / "seen/result.json")["stop_time_s"].get<double>();
  EXPECT_NEAR(recording.frames.back().time, end, 1e-9);  // to the rounding of a step
  for (std::size_t k = 0; k + 1 < recording.frames.size(); ++k) {
    EXPECT_EQ(recording.frames[k].time, static_cast<double>(k) * 0.017);
  }
  // The frames of ParaView at their own times.
  const std::string collection = file_text(folder / "seen/frames/tiny.pvd");
  EXPECT_PRED_FORMAT2(IsSubstring, "timestep=\"0.013\"", collection);
  EXPECT_PRED_FORMAT2(IsSubstring, "timestep=\"0.5\"", collection);  // the last state
}

TEST(Report, FilesOfAnEarlierRunDoNotStayBesideANewResult) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out", "--record",
                                        "--picture", "--frames"})
                .exit_code,
            0);
  EXPECT_TRUE(page_data(folder / "out/report.html")["runs"]["tiny"].contains("recording"));
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
  for (const char* gone : {"recording.flow", "flow.png", "frames"}) {
    EXPECT_FALSE(fs::exists(folder / "out" / gone)) << gone;
  }
  const Json run = page_data(folder / "out/report.html")["runs"]["tiny"];
  EXPECT_FALSE(run.contains("recording"));
  EXPECT_PRED_FORMAT2(IsSubstring, "--record", run["record_command"].get<std::string>());
}

TEST(Report, AdviceOnFewerDesignsGoesWhenAStudyGoesOn) {
  const TemporaryFolder folder;
  Json spec = tiny_search();
  spec.erase("scenarios");
  spec["recordings"] = "none";
  folder.write("study.json", spec.dump());
  ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "out"}).exit_code, 0);
  ASSERT_EQ(run_program(folder.path(), {"recommend", "out", "--no-confirm"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/recommendation.json"));
  // Nothing new: what was advised holds.
  ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "out"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/recommendation.json"));
  spec["method"]["max_evaluations"] = spec["method"]["max_evaluations"].get<int>() + 2;
  folder.write("study.json", spec.dump());
  const Outcome more = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  ASSERT_EQ(more.exit_code, 0) << more.err;
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "(0 by this run", more.out);
  EXPECT_FALSE(fs::exists(folder / "out/recommendation.json"));
  EXPECT_EQ(
      line_count(folder / "out/designs.csv"),
      1 + Json::parse(file_text(folder / "out/summary.json"))["evaluations"].get<std::size_t>());
  EXPECT_EQ(page_data(folder / "out/report.html")["designs"]["id"].size(),
            Json::parse(file_text(folder / "out/summary.json"))["evaluations"].get<std::size_t>());
}

TEST(Report, HoldsWhatTheFilesHoldAndNoStringEndsTheScript) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  spec["name"] = "</script><script>alert(1)</script><!-- \" & '";
  folder.write("case.json", spec.dump());
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
  const Json data = page_data(folder / "out/report.html");
  EXPECT_EQ(data["name"], spec["name"]);
  const Json result = Json::parse(file_text(folder / "out/result.json"));
  EXPECT_EQ(data["result"]["metrics"], result["metrics"]);
  const std::string html = file_text(folder / "out/report.html");
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_PRED_FORMAT2(IsSubstring, "<title>&lt;/script&gt;", html);
  EXPECT_PRED_FORMAT2(IsSubstring, "default-src 'none'; script-src 'sha256-", html);
}

TEST(Report, AStudyRecordsWhatItAsksFor) {
  const TemporaryFolder folder;
  Json spec = tiny_search();
  spec.erase("scenarios");
  for (const auto& [word, at_least] :
       {std::pair("none", 0), std::pair("front", 1), std::pair("all", 3)}) {
    spec["recordings"] = word;
    folder.write("study.json", spec.dump());
    const std::string out = std::string("out-") + word;
    const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--out", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // the same simulation as the one that is logged
    EXPECT_EQ(outcome.err.find("other numbers"), std::string::npos) << outcome.err;
    int recorded = 0;
    if (fs::exists(folder / out / "recordings")) {
      for ([[maybe_unused]] const auto& entry :
           fs::directory_iterator(folder / out / "recordings")) {
        ++recorded;
      }
    }
    EXPECT_EQ(recorded == 0, at_least == 0) << word;
    EXPECT_GE(recorded, at_least) << word;
    int in_page = 0;
    const Json data = page_data(folder / out / "report.html");
    for (const auto& [id, run] : data["runs"].items()) in_page += run.contains("recording") ? 1 : 0;
    EXPECT_EQ(in_page, recorded) << word;
    // Every design of the log is in the page, with its bits.
    EXPECT_EQ(data["designs"]["id"].size(), line_count(folder / out / "evaluations.jsonl"));
  }
  // What is recorded changes no design: the same study, resumed, simulates nothing.
  spec["recordings"] = "all";
  folder.write("study.json", spec.dump());
  const Outcome again = run_program(folder.path(), {"optimize", "study.json", "--out", "out-none"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "(0 by this run", again.out);
  const Outcome one = run_program(folder.path(), {"report", "out-front", "--record", "no-such"});
  EXPECT_EQ(one.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "is no design of this study", one.err);
}

TEST(Report, AFolderWithoutResultsIsRefused) {
  const TemporaryFolder folder;
  folder.write("note.txt", "mine");
  const Outcome outcome = run_program(folder.path(), {"report", "."});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "holds no results of Parapet", outcome.err);
  EXPECT_FALSE(fs::exists(folder / "report.html"));
}

TEST(Report, TheTableOfDesignsHoldsWhatTheLogHolds) {
  const TemporaryFolder folder;
  Json spec = tiny_study();
  spec["recordings"] = "none";
  spec["constraints"][0]["name"] = "stem, \"tall\"";
  folder.write("study.json", spec.dump());
  ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "out"}).exit_code, 0);
  const std::string table = file_text(folder / "out/designs.csv");
  EXPECT_TRUE(table.starts_with("id,stage,status,reason,feasible,front,spacing_m,")) << table;
  for (const char* name :
       {",variable.upstream_height_m,", ",objective.barrier_1_slam_force_n_per_m,",
        ",\"constraint.stem, \"\"tall\"\"\",", ",metric.retention_efficiency,"}) {
    EXPECT_PRED_FORMAT2(IsSubstring, name, table.substr(0, table.find('\n')));
  }
  const std::string log = file_text(folder / "out/evaluations.jsonl");
  const Json first = Json::parse(log.substr(0, log.find('\n')));
  const std::size_t begin = table.find('\n') + 1;
  const std::string row = table.substr(begin, table.find('\n', begin) - begin);
  EXPECT_TRUE(row.starts_with(first["id"].get<std::string>() + "," +
                              first["stage"].get<std::string>() + ",ok,,"))
      << row;
  const std::string retention = first["metrics"]["retention_efficiency"].dump();
  EXPECT_PRED_FORMAT2(IsSubstring, ',' + retention + ',', row);
}

// A page that a later program writes anew must not claim that it simulated.
TEST(Report, SaysWhichProgramSimulated) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
  Json result = Json::parse(file_text(folder / "out/result.json"));
  result["provenance"]["program_version"] = "0.0.9";
  result["provenance"]["git_revision"] = "0123456789ab";
  folder.write("out/result.json", result.dump());
  ASSERT_EQ(run_program(folder.path(), {"report", "out"}).exit_code, 0);
  const Json data = page_data(folder / "out/report.html");
  EXPECT_EQ(data["simulated_by"]["version"], "0.0.9");
  EXPECT_EQ(data["simulated_by"]["git_revision"], "0123456789ab");
  EXPECT_EQ(data["simulated_by"]["physics"], result["provenance"]["physics"]);
  EXPECT_NE(data["program"]["version"], "0.0.9");
}

TEST(Report, SeveralStudiesComeIntoOneFront) {
  const TemporaryFolder folder;
  Json spec = tiny_study();
  spec["recordings"] = "none";
  spec["method"] = {{"algorithm", "SOBOL"}, {"max_evaluations", 4}, {"seed", 1}};
  folder.write("a.json", spec.dump());
  spec["case"]["reservoir"]["height_m"] = 0.12;
  folder.write("b.json", spec.dump());
  spec["objectives"] = Json::parse(R"([{"metric": "retention_efficiency", "goal": "maximize"}])");
  folder.write("c.json", spec.dump());
  for (const std::string name : {"a", "b", "c"}) {
    const Outcome done = run_program(folder.path(), {"optimize", name + ".json", "--out", name});
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  const Outcome both = run_program(folder.path(), {"report", "a", "b", "--out", "both.html"});
  ASSERT_EQ(both.exit_code, 0) << both.err;
  const Json page = page_data(folder / "both.html");
  EXPECT_EQ(page["kind"], "studies");
  ASSERT_EQ(page["studies"].size(), 2U);
  EXPECT_EQ(page["studies"][0]["label"], "tiny (a)") << "two studies of one name";
  EXPECT_EQ(page["notes"].size(), 1U) << "the releases differ";
  const Json& designs = page["designs"];
  const std::size_t n = designs["id"].size();
  EXPECT_EQ(designs["variables"]["study"].size(), n);
  // The least force of all feasible designs is the joint front.
  const Json& force = designs["objectives"]["barrier_1_slam_force_n_per_m"];
  double least = 1e300;
  for (std::size_t row = 0; row < n; ++row) {
    if (designs["feasible"][row] && force[row].is_number()) {
      least = std::min(least, force[row].get<double>());
    }
  }
  int on_front = 0;
  for (std::size_t row = 0; row < n; ++row) {
    if (!designs["front"][row]) continue;
    ++on_front;
    EXPECT_EQ(force[row].get<double>(), least);
  }
  EXPECT_EQ(on_front, least < 1e300 ? 1 : 0);
  EXPECT_EQ(page["studies"][0]["on_joint_front"].get<int>() +
                page["studies"][1]["on_joint_front"].get<int>(),
            on_front);
  const Outcome other = run_program(folder.path(), {"report", "a", "c"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "shares no objective with a", other.err);
  // Two studies that found the same share their front.
  fs::copy(folder / "a", folder / "same", fs::copy_options::recursive);
  ASSERT_EQ(run_program(folder.path(), {"report", "a", "same", "--out", "same.html"}).exit_code, 0);
  const Json same = page_data(folder / "same.html")["studies"];
  EXPECT_EQ(same[0]["on_joint_front"], same[1]["on_joint_front"]);
  EXPECT_FALSE(fs::exists(folder / "studies.html"));
}

}  // namespace
}  // namespace parapet::test
