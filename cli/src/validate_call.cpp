#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "session.hpp"

namespace parapet::cli {
namespace {

// The arguments are those of this call without the word "validate".
int execute_validation(const Session& session) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("parapet-validate");
  std::vector<std::string> words = session.arguments;
  words.front() = program.string();
  words.erase(std::find(words.begin() + 1, words.end(), "validate"));
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  session.log->error(
      "cannot start {} ({}): build it with \"./parapet validate\" or with \"cmake --build FOLDER "
      "--target parapet_validate\"",
      program.string(), std::generic_category().message(errno));
  return exit_failed;
}

}  // namespace

void add_validate_call(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand(
      "validate", "Verify and validate the solver: exact, measured and published answers");
  // Whatever follows is judged by the program that it is meant for.
  auto words = std::make_shared<std::vector<std::string>>();
  verb->prefix_command()->fallthrough(false)->set_help_flag();
  verb->add_option("WORDS", *words);
  verb->callback(
      [words, &session] { session.command = [&session] { return execute_validation(session); }; });
}

}  // namespace parapet::cli
