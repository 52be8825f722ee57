// The evaluation log: exact, durable, and repaired wherever a crash may have cut it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "program_runner.hpp"

namespace parapet::test {
namespace {

using records::EvaluationLog;
using records::EvaluationRecord;
using ::testing::IsSubstring;

EvaluationRecord sample(int number) {
  EvaluationRecord record;
  record.id = records::evaluation_id(number);
  record.stage = "search";
  record.design = {{"angle_deg", 0.1 * number}, {"height_m", 1.0 / (3.0 + number)}};
  record.ok = true;
  record.metrics = {{"retention_efficiency", 0.7, ""},
                    {"launch_length_m", {}, "no \"overflow\"\n"}};
  record.objectives = {{"retention_efficiency", designs::Goal::maximize, 1.0, 0.7, false}};
  record.objective_scalar = -0.7;
  record.constraints = {{"stem", 0.1, {}, 0.2, true, 0.1}};
  record.feasible = true;
  record.spacing = 0.01;
  record.wall_time = 1.5;
  return record;
}

void write_log(const std::filesystem::path& file, int records) {
  EvaluationLog log(file);
  for (int k = 1; k <= records; ++k) log.append(sample(k));
}

TEST(EvaluationLogFile, KeepsEveryBitOfEveryNumber) {
  const TemporaryFolder folder;
  EvaluationRecord record = sample(1);
  record.design = {{"a", 0.1 + 0.2},
                   {"b", std::numeric_limits<double>::denorm_min()},
                   {"c", std::numeric_limits<double>::max()},
                   {"d", 1.0 / 3.0},
                   {"e", 45.0}};
  {
    EvaluationLog log(folder / "log");
    log.append(record);
  }
  const EvaluationLog log(folder / "log");
  ASSERT_EQ(log.records().size(), 1U);
  EXPECT_EQ(log.records().front().design, record.design);
  EXPECT_EQ(records::to_json(log.records().front()), records::to_json(record));
  ASSERT_NE(log.find(record.design, record.spacing), nullptr);
  EXPECT_EQ(log.find(record.design, 2.0 * record.spacing), nullptr);
  record.design["d"] = std::nextafter(1.0 / 3.0, 1.0);
  EXPECT_EQ(log.find(record.design, record.spacing), nullptr)
      << "the neighbouring double is another design";
}

TEST(EvaluationLogFile, KeepsScenariosOptionsAndCosts) {
  EvaluationRecord record = sample(1);
  const std::string plain = records::to_json(record).dump();
  for (const char* key : {"scenarios", "options", "cpu_time_s", "particle_steps", "stop_reason"}) {
    EXPECT_EQ(plain.find(key), std::string::npos) << key << " is written only when present";
  }
  record.options = {{"deflector", "plate"}};
  record.cpu_time = 1.0 / 3.0;
  record.particle_steps = 1e7;
  record.stop_reason = "settled";
  record.scenarios = {{"soft",
                       0.25,
                       true,
                       "",
                       record.metrics,
                       0.5,
                       0.1,
                       4e6,
                       "end_time",
                       "00ff",
                       {{"mass_spread", 0.3, 0.1, "masses differ"}}},
                      {"stiff", 0.75, false, "it broke", {}, 0.0, 0.0, 0.0, "", "", {}}};
  const auto json = records::to_json(record);
  const EvaluationRecord again = records::record_from_json(designs::Json::parse(json.dump()));
  EXPECT_EQ(records::to_json(again).dump(), json.dump());
  ASSERT_EQ(again.scenarios.size(), 2U);
  EXPECT_EQ(again.scenarios[0].metrics[1].absent_reason, "no \"overflow\"\n");
  EXPECT_EQ(again.scenarios[0].case_hash, "00ff");
  ASSERT_EQ(again.scenarios[0].warnings.size(), 1U);
  EXPECT_EQ(again.scenarios[0].warnings[0].text, "masses differ");
  EXPECT_TRUE(again.scenarios[1].warnings.empty());
  EXPECT_EQ(again.scenarios[1].reason, "it broke");
  EXPECT_EQ(again.options.at("deflector"), "plate");
  EXPECT_EQ(again.stop_reason, "settled");
  EXPECT_EQ(again.scenarios[0].stop_reason, "end_time");
}

// A crash may leave any number of bytes of the last line.
TEST(EvaluationLogFile, IsRepairedAfterACutAtAnyByteOfTheLastLine) {
  const TemporaryFolder folder;
  write_log(folder / "whole", 3);
  const std::string whole = file_text(folder / "whole");
  const std::size_t last_line = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t size = last_line; size < whole.size(); ++size) {
    const std::filesystem::path file = folder.write("cut", whole.substr(0, size));
    std::filesystem::remove(folder / "cut.damaged");
    const bool only_line_end_missing = size + 1 == whole.size();
    const bool nothing_begun = size == last_line;
    {
      EvaluationLog log(file);
      ASSERT_EQ(log.records().size(), only_line_end_missing ? 3U : 2U) << "cut at " << size;
      EXPECT_EQ(log.repairs().empty(), only_line_end_missing || nothing_begun) << size;
      if (!only_line_end_missing) log.append(sample(3));
    }
    ASSERT_EQ(file_text(file), whole) << "cut at " << size;
    if (!only_line_end_missing && !nothing_begun) {
      EXPECT_EQ(file_text(folder / "cut.damaged"),
                whole.substr(last_line, size - last_line) + "\n");
    }
  }
}

TEST(EvaluationLogFile, LastLineOfZerosIsCutOff) {
  const TemporaryFolder folder;
  write_log(folder / "log", 2);
  const std::string before = file_text(folder / "log");
  // What some file systems leave after a power cut: the length without the content.
  folder.write("log", before + std::string(100, '\0'));
  const EvaluationLog log(folder / "log");
  EXPECT_EQ(log.records().size(), 2U);
  EXPECT_EQ(file_text(folder / "log"), before);
}

// Every byte of a line, and of its checksum too.
TEST(EvaluationLogFile, EveryChangedByteOfALineIsSeen) {
  const TemporaryFolder folder;
  write_log(folder / "whole", 3);
  const std::string whole = file_text(folder / "whole");
  const std::size_t begin = whole.find('\n') + 1, end = whole.find('\n', begin);
  for (std::size_t place = begin; place < end; ++place) {
    std::string text = whole;
    text[place] = text[place] == '1' ? '2' : '1';
    folder.write("log", text);
    const records::LogContent content = records::read_evaluation_log(folder / "log");
    ASSERT_EQ(content.damaged.size(), 1U) << "byte " << place - begin;
    EXPECT_EQ(content.damaged[0].number, 2U);
    ASSERT_EQ(content.records.size(), 2U);
    EXPECT_EQ(content.records[1].id, "0003");
    EXPECT_EQ(content.lines_without_checksum, 0U);
  }
}

TEST(EvaluationLogFile, DamagedLinesAreSetAsideAndTheLogGoesOn) {
  const TemporaryFolder folder;
  write_log(folder / "log", 4);
  std::string text = file_text(folder / "log");
  const std::size_t second = text.find('\n') + 1;
  const std::string sound = text.substr(0, second), damaged = "?" + text.substr(second + 1);
  folder.write("log", sound + damaged);
  {
    EvaluationLog log(folder / "log");
    ASSERT_EQ(log.repairs().size(), 1U);
    EXPECT_PRED_FORMAT2(IsSubstring, "line 2", log.repairs()[0]);
    EXPECT_EQ(log.records().size(), 3U);
    log.append(sample(2));
  }
  EXPECT_EQ(file_text(folder / "log.damaged"), damaged.substr(0, damaged.find('\n') + 1));
  const EvaluationLog log(folder / "log");
  EXPECT_TRUE(log.repairs().empty());
  EXPECT_EQ(log.records().size(), 4U);
}

TEST(EvaluationLogFile, LinesWithoutAChecksumAreTakenWithANote) {
  const TemporaryFolder folder;
  folder.write("log", records::to_json(sample(1)).dump() + "\n");
  EvaluationLog log(folder / "log");
  EXPECT_EQ(log.records().size(), 1U);
  EXPECT_PRED_FORMAT2(IsSubstring, "1 of its lines have no checksum", log.checksum_note());
  log.append(sample(2));
  const records::LogContent content = records::read_evaluation_log(folder / "log");
  EXPECT_EQ(content.records.size(), 2U);
  EXPECT_EQ(content.lines_without_checksum, 1U);
}

TEST(EvaluationLogFile, AnInvertedVerdictIsSeenEvenWithoutAChecksum) {
  const TemporaryFolder folder;
  for (const bool feasible : {true, false}) {
    EvaluationRecord record = sample(1);
    record.constraints[0].satisfied = !feasible;
    record.feasible = feasible;
    folder.write("log", records::to_json(record).dump() + "\n");
    EXPECT_EQ(records::read_evaluation_log(folder / "log").damaged.size(), 1U);
  }
}

TEST(EvaluationLogFile, RefusedDesignsStandThereOnceAndAreNoRecords) {
  const TemporaryFolder folder;
  for (int time = 0; time < 2; ++time) {
    EvaluationLog log(folder / "log");
    for (int k = 1; k <= 3; ++k) {
      records::RefusedDesign refused;
      refused.design = {{"angle_deg", 1.0 * k}};
      refused.reason = "violates stem";
      log.append(refused);
    }
    EXPECT_TRUE(log.records().empty());
    ASSERT_EQ(log.refused().size(), 3U);
    EXPECT_EQ(log.refused()[2].id, "refused-0003");
  }
  EXPECT_EQ(line_count(folder / "log"), 3U);
}

TEST(EvaluationLogFile, RepeatedIdIsAnError) {
  const TemporaryFolder folder;
  write_log(folder / "log", 2);
  const std::string text = file_text(folder / "log");
  const std::string first = text.substr(0, text.find('\n') + 1);
  folder.write("log", first + text);
  EXPECT_THROW(EvaluationLog(folder / "log"), designs::InputError);
}

// A file-size limit behaves as a full disk does: the write stops half-way.
TEST(EvaluationLogFile, FullDiskLeavesNoHalfLine) {
  const TemporaryFolder folder;
  EvaluationLog log(folder / "log");
  log.append(sample(1));
  const std::string before = file_text(folder / "log");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  rlimit tight = usual;
  tight.rlim_cur = before.size() + 20;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  EXPECT_THROW(log.append(sample(2)), records::FileError);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &usual), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(file_text(folder / "log"), before);
  EXPECT_EQ(log.records().size(), 1U);
  log.append(sample(2));
  EXPECT_EQ(line_count(folder / "log"), 2U);
}

}  // namespace
}  // namespace parapet::test
