// The program `parapet-validate`: what `parapet validate` executes. It is a program of its own so
// that the first build of `parapet` does without the validation suite.
#include <vector>

#include "program.hpp"
#include "standard_streams.hpp"
#include "thread_policy.hpp"

int main(int argc, char** argv) {
  using namespace parapet::cli;
  open_standard_streams();
  let_waiting_threads_sleep(argv);
  // Messages and help are those of `parapet validate`.
  char verb[] = "validate";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, verb);
  arguments.push_back(nullptr);
  return run_program(argc + 1, arguments.data(), {add_validate});
}
