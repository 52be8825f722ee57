// The program on a damaged log.
#include "study_fixture.hpp"

namespace parapet::test {
namespace {

using ::testing::IsSubstring;

class LogDamage : public StudyTest {};

TEST_F(LogDamage, HalfWrittenLastLineIsRepairedSaidAndEvaluatedAgain) {
  const std::string whole = file_text(log_of("calm"));
  const std::size_t last_line = whole.rfind('\n', whole.size() - 2) + 1;
  // Nothing of the line, its first byte, its middle, all but its last two bytes, all but its end.
  for (const std::size_t size : {last_line, last_line + 1, (last_line + whole.size()) / 2,
                                 whole.size() - 2, whole.size() - 1}) {
    const std::string out = "cut" + std::to_string(size);
    std::filesystem::copy(folder / "calm", folder / out, std::filesystem::copy_options::recursive);
    std::filesystem::resize_file(log_of(out), size);
    const Outcome outcome = run_program(folder.path(), command(out));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const bool damaged = size != last_line && size + 1 != whole.size();
    EXPECT_EQ(outcome.err.find("only half written") != std::string::npos, damaged) << outcome.err;
    resume_and_compare(out);
  }
}

TEST_F(LogDamage, DamageInTheMiddleIsOneErrorWithTheLineNumberAndChangesNothing) {
  std::string text = file_text(log_of("calm"));
  text[text.find('\n') + 1] = '?';
  folder.write("calm/evaluations.jsonl", text);
  const auto before = contents("calm");
  const Outcome outcome = run_program(folder.path(), command("calm"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "line 2", outcome.err);
  EXPECT_EQ(contents("calm"), before);
}

}  // namespace
}  // namespace parapet::test
