// The program `parapet`.
#include "program.hpp"
#include "standard_streams.hpp"
#include "thread_policy.hpp"

int main(int argc, char** argv) {
  using namespace parapet::cli;
  open_standard_streams();
  let_waiting_threads_sleep(argv);
  return run_program(
      argc, argv,
      {add_simulate, add_table3, add_optimize, add_evaluate, add_recommend, add_report, add_serve,
       add_validate_call, add_check, add_approach, add_verify});
}
