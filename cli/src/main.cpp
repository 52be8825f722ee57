// The program `parapet`.
#include "parapet/cli/run_parapet.hpp"
#include "standard_streams.hpp"
#include "thread_policy.hpp"

int main(int argc, char** argv) {
  using namespace parapet::cli;
  open_standard_streams();
  let_waiting_threads_sleep(argv);
  return run_parapet(argc, argv);
}
