#include <utility>

#include "parapet/cli/run_parapet.hpp"
#include "program.hpp"

namespace parapet::cli {

int run_parapet(int argc, char** argv, study::ServiceFactory service) {
  return run_program(
      argc, argv,
      {add_simulate, add_table3, add_optimize, add_evaluate, add_recommend, add_report, add_serve,
       add_validate_call, add_check, add_approach, add_verify},
      std::move(service));
}

}  // namespace parapet::cli
