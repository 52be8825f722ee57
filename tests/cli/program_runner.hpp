/// Starts the real program and collects what it says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace parapet::test {

struct Outcome {
  int exit_code = -1;  ///< 128 + the signal's number when a signal ended it
  std::string out, err;
};

/// A folder that goes away with its object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Writes a file into the folder; its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

/// The program `parapet` of this build.
std::filesystem::path parapet_program();

/// A program that runs in the background, in `working_folder`. Killed if it still runs at the end.
class RunningProgram {
 public:
  RunningProgram(const std::filesystem::path& working_folder,
                 const std::vector<std::string>& arguments, const std::string& input = "",
                 const std::filesystem::path& program = parapet_program());
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  void send(int signal) const;
  bool ended();
  Outcome wait();

 private:
  TemporaryFolder streams_;
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// Runs the program to its end.
Outcome run_program(const std::filesystem::path& working_folder,
                    const std::vector<std::string>& arguments, const std::string& input = "",
                    const std::filesystem::path& program = parapet_program());

/// Waits until a condition holds, at most a minute; whether it does.
template <typename Condition>
bool wait_until(const Condition& condition);

std::string file_text(const std::filesystem::path& file);
std::size_t line_count(const std::filesystem::path& file);

/// Sleeps a few milliseconds.
void pause_briefly();

template <typename Condition>
bool wait_until(const Condition& condition) {
  constexpr int tries = 60 * 500;
  for (int k = 0; k < tries; ++k) {
    if (condition()) return true;
    pause_briefly();
  }
  return false;
}

}  // namespace parapet::test
