// SIGKILL at random moments: nothing is lost, nothing stands twice, and the log ends up as that of
// a run that nobody disturbed. PARAPET_KILLS sets how many (a dozen by default; .ci/nightly: 200),
// PARAPET_KILL_SEED another series of moments.
#include <chrono>
#include <csignal>
#include <iostream>
#include <random>
#include <thread>

#include "hard_studies.hpp"
#include "study_fixture.hpp"

namespace parapet::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

struct Calm {
  std::map<std::string, designs::Json> records;
  double duration = 0.0;  ///< [s]
};

Calm run_calm(const TemporaryFolder& folder, const HardStudy& study) {
  folder.write(study.name + ".json", study.spec.dump());
  const auto start = Clock::now();
  const Outcome outcome = run_program(folder.path(), study.command("calm-" + study.name));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return {records_in(folder / ("calm-" + study.name) / "evaluations.jsonl"),
          Seconds(Clock::now() - start).count()};
}

TEST(KillStorm, EveryKilledStudyEndsAsIfUndisturbed) {
  const int n_kills = trials("PARAPET_KILLS", 12);
  const int seed = trials("PARAPET_KILL_SEED", 1);
  std::mt19937 engine(static_cast<unsigned>(seed));
  const TemporaryFolder folder;
  const std::vector<HardStudy> studies = hard_studies();
  std::vector<Calm> calm;
  for (const HardStudy& study : studies) calm.push_back(run_calm(folder, study));
  int killed = 0, n_studies = 0;
  while (killed < n_kills) {
    const std::size_t which = static_cast<std::size_t>(n_studies++) % studies.size();
    const HardStudy& study = studies[which];
    const std::string out = "out-" + std::to_string(n_studies);
    SCOPED_TRACE(study.name + ", seed " + std::to_string(seed) + ", study " +
                 std::to_string(n_studies));
    // One to three kills, each somewhere in the time that a whole run takes.
    const int in_a_row = 1 + static_cast<int>(engine() % 3);
    for (int k = 0; k < in_a_row && killed < n_kills; ++k) {
      RunningProgram program(folder.path(), study.command(out));
      const double share = std::uniform_real_distribution(0.0, 0.9)(engine);
      std::this_thread::sleep_for(Seconds(share * calm[which].duration));
      program.send(SIGKILL);
      program.wait();
      ++killed;
    }
    const Outcome resumed = run_program(folder.path(), study.command(out));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    ASSERT_EQ(records_in(folder / out / "evaluations.jsonl"), calm[which].records);
    std::filesystem::remove_all(folder / out);
  }
  std::cout << killed << " kills in " << n_studies << " studies, seed " << seed
            << ": every log as undisturbed\n";
}

}  // namespace
}  // namespace parapet::test
