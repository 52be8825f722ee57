// The module parapet._native.
#include "parapet/cli/run_parapet.hpp"
#include "parapet/records/provenance.hpp"
#include "parts.hpp"

PYBIND11_MODULE(_native, module) {
  using namespace parapet::python;
  module.doc() = "The C++ side of the package parapet. Use the package: it has the documentation.";
  const parapet::records::ProgramInfo program = parapet::cli::program_info();
  module.attr("version") = program.version;
  module.attr("git_revision") = program.git_revision;
  module.attr("physics") = program.physics;
  module.attr("compiler") = parapet::records::compiler_name();
  add_errors(module);
  add_simulate(module);
  add_study(module);
  add_search(module);
  add_advice(module);
  add_tasks(module);
  add_program(module);
}
