#include "study_fixture.hpp"

#include "tiny_specs.hpp"

namespace parapet::test {

using designs::Json;

std::map<std::string, Json> records_in(const std::filesystem::path& log) {
  std::map<std::string, Json> records;
  const std::string text = file_text(log);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    Json record = Json::parse(text.substr(begin, end - begin));
    for (const char* key : {"wall_time_s", "cpu_time_s", "crc32c"}) record.erase(key);
    if (record.contains("scenarios")) {
      for (Json& scenario : record["scenarios"]) {
        for (const char* key : {"wall_time_s", "cpu_time_s"}) scenario.erase(key);
      }
    }
    const std::string id = record["id"].get<std::string>();
    EXPECT_TRUE(records.emplace(id, std::move(record)).second) << id << " stands twice";
    begin = end + 1;
  }
  return records;
}

std::size_t evaluations_in(const std::filesystem::path& log) {
  std::size_t count = 0;
  for (const auto& [id, record] : records_in(log)) count += record["status"] == "refused" ? 0 : 1;
  return count;
}

void StudyTest::SetUp() {
  folder.write("study.json", tiny_study().dump());
  const Outcome outcome = run_program(folder.path(), command("calm"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_GE(evaluations_in(log_of("calm")), 8U) << "too short a study to disturb";
}

std::vector<std::string> StudyTest::command(const std::string& out, const std::string& jobs) {
  return {"optimize", "study.json", "--out", out, "--jobs", jobs};
}

std::filesystem::path StudyTest::log_of(const std::string& out) const {
  return folder.path() / out / "evaluations.jsonl";
}

Json StudyTest::summary_of(const std::string& out) const {
  Json summary = Json::parse(file_text(folder.path() / out / "summary.json"));
  for (const char* best : {"best", "starting_best"}) {
    if (!summary[best].is_object()) continue;
    for (const char* key : {"wall_time_s", "cpu_time_s"}) summary[best].erase(key);
  }
  summary.erase("elapsed_s");
  summary.erase("simulated_by_this_run");
  return summary;
}

std::map<std::string, std::string> StudyTest::contents(const std::string& out) const {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / out)) {
    if (!entry.is_regular_file() || entry.path().filename() == ".lock") continue;
    files[entry.path().string()] = file_text(entry.path());
  }
  return files;
}

void StudyTest::resume_and_compare(const std::string& out) {
  const Outcome outcome = run_program(folder.path(), command(out));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(summary_of(out), summary_of("calm"));
  const auto records = records_in(log_of(out));
  EXPECT_EQ(records, records_in(log_of("calm")));
  for (const auto& [id, record] : records) {
    if (record["status"] == "refused") continue;
    const Json report =
        Json::parse(file_text(folder.path() / out / "evaluations" / (id + ".json")));
    EXPECT_EQ(report["design"], record["design"]);
  }
}

}  // namespace parapet::test
