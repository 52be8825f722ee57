#include "program.hpp"
#include "thread_policy.hpp"

int main(int argc, char** argv) {
  parapet::cli::let_waiting_threads_sleep(argv);
  return parapet::cli::run_program(argc, argv);
}
