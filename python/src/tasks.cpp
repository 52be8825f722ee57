#include <pybind11/stl.h>

#include <string>

#include "interruptible.hpp"
#include "parapet/cli/run_parapet.hpp"
#include "parapet/records/simulation_json.hpp"
#include "parapet/study/probe.hpp"
#include "parapet/study/simulation_task.hpp"
#include "parapet/study/simulator.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::Json;

/// Simulates tasks that came as text; keeps how flows begin from one to the next.
class TaskSimulator {
 public:
  /// @param task format "parapet-simulation-task/1"
  /// @param threads that the simulation may use
  /// @return format "parapet-simulation-outcome/1"
  std::string simulate(const std::string& text, int threads) const {
    study::SimulationTask task = study::task_from_json(Json::parse(text));
    task.threads = threads;
    const records::Simulation simulation =
        run_interruptibly([&](const std::atomic<bool>& cancelled) {
          solver::Callbacks callbacks;
          callbacks.on_progress = [&](const solver::Progress&) { return !cancelled; };
          return simulator_(task, callbacks);
        });
    return records::to_json(simulation).dump();
  }

 private:
  study::Simulator simulator_ = study::solver_simulator();
};

/// The outcome of a task that could not be simulated, for a reason outside the solver.
std::string failed_outcome(const std::string& reason) {
  records::Simulation simulation;
  simulation.reason = reason;
  simulation.report = Json::object();
  return records::to_json(simulation).dump();
}

py::dict identity() {
  const study::Identity own = run_interruptibly(
      [](const std::atomic<bool>&) { return study::identity(cli::program_info()); });
  py::dict out;
  out["version"] = own.version;
  out["git_revision"] = own.git_revision;
  out["physics"] = own.physics;
  out["compiler"] = own.compiler;
  out["probe"] = own.probe;
  return out;
}

}  // namespace

void add_tasks(py::module_& module) {
  py::class_<TaskSimulator>(module, "TaskSimulator")
      .def(py::init<>())
      .def("simulate", &TaskSimulator::simulate);
  module.def("failed_outcome", &failed_outcome);
  module.def("identity", &identity);
}

}  // namespace parapet::python
