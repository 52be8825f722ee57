#include "program_runner.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace parapet::test {
namespace {

/// Only between fork and exec: no memory is allocated.
[[noreturn]] void become_program(const char* program, const char* folder, char* const* arguments,
                                 const char* in, const char* out, const char* err) {
  const int descriptors[3] = {::open(in, O_RDONLY), ::open(out, O_WRONLY | O_CREAT | O_TRUNC, 0644),
                              ::open(err, O_WRONLY | O_CREAT | O_TRUNC, 0644)};
  for (int k = 0; k < 3; ++k) {
    if (::dup2(descriptors[k], k) < 0) ::_exit(127);
  }
  if (::chdir(folder) != 0) ::_exit(127);
  ::execv(program, arguments);
  ::_exit(127);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "parapet-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return (path_ / name).string();
}

std::filesystem::path parapet_program() {
  return PARAPET_PROGRAM;
}

RunningProgram::RunningProgram(const std::filesystem::path& working_folder,
                               const std::vector<std::string>& arguments, const std::string& input,
                               const std::filesystem::path& program) {
  const std::string in = streams_.write("in", input);
  const std::string out = (streams_ / "out").string(), err = (streams_ / "err").string();
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("fork failed");
  if (process_ == 0) {
    become_program(program.c_str(), working_folder.c_str(), pointers.data(), in.c_str(),
                   out.c_str(), err.c_str());
  }
}

RunningProgram::~RunningProgram() {
  if (ended()) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, &status_, 0);
}

void RunningProgram::send(int signal) const {
  ::kill(process_, signal);
}

bool RunningProgram::ended() {
  if (!ended_) ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
  return ended_;
}

Outcome RunningProgram::wait() {
  if (!ended_) ended_ = ::waitpid(process_, &status_, 0) == process_;
  Outcome outcome;
  outcome.exit_code = WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  outcome.out = file_text(streams_ / "out");
  outcome.err = file_text(streams_ / "err");
  return outcome;
}

Outcome run_program(const std::filesystem::path& working_folder,
                    const std::vector<std::string>& arguments, const std::string& input,
                    const std::filesystem::path& program) {
  return RunningProgram(working_folder, arguments, input, program).wait();
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::size_t line_count(const std::filesystem::path& file) {
  const std::string text = file_text(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void pause_briefly() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace parapet::test
