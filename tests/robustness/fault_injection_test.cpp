// Disks fill up, go bad and take access away: at any write, rename, sync or open. The program says
// so and ends with exit code 1; once the disk works again the same command ends as if nothing had
// been. PARAPET_FAULTS sets how many places of each kind are tried (all of them: 100000).
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "hard_studies.hpp"
#include "study_fixture.hpp"

namespace parapet::test {
namespace {

/// Sets environment variables for the programs that are started, and takes them back.
class Environment {
 public:
  explicit Environment(std::map<std::string, std::string> variables)
      : variables_(std::move(variables)) {
    for (const auto& [name, value] : variables_) {
      ::setenv(name.c_str(), value.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
    }
  }
  ~Environment() {
    for (const auto& [name, value] : variables_) {
      ::unsetenv(name.c_str());  // NOLINT(concurrency-mt-unsafe): one thread
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::map<std::string, std::string> variables_;
};

struct Fault {
  const char *name, *call, *kind;
  bool stays;  ///< as on a full disk, which does not get better by itself
};

std::ostream& operator<<(std::ostream& stream, const Fault& fault) {
  return stream << fault.name;
}

class FaultInjection : public ::testing::TestWithParam<Fault> {
 protected:
  void SetUp() override {
    study_ = hard_studies().front();
    study_.spec["method"]["max_evaluations"] = 6;
    folder_.write(study_.name + ".json", study_.spec.dump());
    ASSERT_EQ(run_program(folder_.path(), study_.command("calm")).exit_code, 0);
    calm_ = records_in(folder_ / "calm/evaluations.jsonl");
  }

  Environment shim(int at, const std::string& out) const {
    return Environment({{"LD_PRELOAD", PARAPET_FAULT_SHIM},
                        {"PARAPET_FAULT_UNDER", folder_.path().string() + "/" + out},
                        {"PARAPET_FAULT_CALL", GetParam().call},
                        {"PARAPET_FAULT_KIND", GetParam().kind},
                        {"PARAPET_FAULT_STAYS", GetParam().stays ? "1" : "0"},
                        {"PARAPET_FAULT_AT", std::to_string(at)},
                        {"PARAPET_FAULT_COUNT", (folder_ / "count").string()}});
  }

  /// How many calls of this kind an undisturbed run makes.
  int count_calls() const {
    {
      const auto counting = shim(0, "counted");
      const Outcome outcome = run_program(folder_.path(), study_.command(out_path("counted")));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    return std::stoi(file_text(folder_ / "count"));
  }

  /// Absolute, so that the shim knows the paths.
  std::string out_path(const std::string& out) const { return (folder_ / out).string(); }

  void try_place(int at) const {
    const std::string out = "out" + std::to_string(at);
    SCOPED_TRACE(std::string(GetParam().name) + " at call " + std::to_string(at));
    {
      const auto faulty = shim(at, out);
      const Outcome outcome = run_program(folder_.path(), study_.command(out_path(out)));
      // Some files are written by the clock, so that a faster run makes fewer calls than the one
      // that counted them: then its own last call is tried.
      const int made = std::stoi(file_text(folder_ / "count"));
      if (outcome.exit_code == 0 && made < at) {
        std::filesystem::remove_all(folder_ / out);
        ASSERT_GT(made, 0);
        try_place(made);
        return;
      }
      if (std::string(GetParam().kind) == "kill") {
        ASSERT_EQ(outcome.exit_code, 128 + SIGKILL);
      } else {
        ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
        ASSERT_NE(outcome.err.find(out_path(out)), std::string::npos)
            << "the message names no file: " << outcome.err;
      }
    }
    const Outcome resumed = run_program(folder_.path(), study_.command(out_path(out)));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    ASSERT_EQ(records_in(folder_ / out / "evaluations.jsonl"), calm_);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / out)) {
      ASSERT_EQ(entry.path().string().find(".tmp"), std::string::npos)
          << "left behind: " << entry.path();
    }
    std::filesystem::remove_all(folder_ / out);
  }

  TemporaryFolder folder_;
  HardStudy study_;
  std::map<std::string, designs::Json> calm_;
};

TEST_P(FaultInjection, IsSaidAndMendedByTheSameCommand) {
  const int n_calls = count_calls();
  ASSERT_GT(n_calls, 5);
  // Spread evenly, the first and the last among them.
  const int n_tried = std::min(n_calls, std::max(2, trials("PARAPET_FAULTS", 5)));
  for (int k = 0; k < n_tried && !HasFatalFailure(); ++k) {
    try_place(1 + k * (n_calls - 1) / (n_tried - 1));
  }
  std::cout << GetParam().name << ": " << n_tried << " of " << n_calls << " calls tried\n";
}

INSTANTIATE_TEST_SUITE_P(Disk, FaultInjection,
                         ::testing::Values(Fault{"full_at_a_write", "write", "ENOSPC", true},
                                           Fault{"short_write", "write", "short", false},
                                           Fault{"bad_write", "write", "EIO", false},
                                           Fault{"bad_sync", "fsync", "EIO", false},
                                           Fault{"no_rename", "rename", "EACCES", false},
                                           Fault{"no_open", "open", "EACCES", true},
                                           Fault{"killed", "any", "kill", false}),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace parapet::test
