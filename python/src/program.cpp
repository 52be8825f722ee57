#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "parapet/cli/run_parapet.hpp"
#include "parapet/records/simulation_json.hpp"
#include "parapet/study/simulation_service.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::Json;
using study::EndedSimulation;

/// A service that Python implements: an object with
///   submit(ticket: int, key: str, task: str) -> None
///   poll(timeout_s: float) -> None, or (ticket: int, outcome: str), or (ticket: int, None, why:
///   str) cancel() -> None   nothing that was handed in is wanted any more close() -> None
/// with tasks and outcomes as their JSON. When poll() raises, the whole service has failed.
class PythonService : public study::SimulationService {
 public:
  PythonService(py::object service, int places, study::ServiceHooks hooks)
      : service_(std::move(service)), places_(places), hooks_(std::move(hooks)) {}

  ~PythonService() override {
    const py::gil_scoped_acquire acquire;
    try {
      service_.attr("close")();
    } catch (const py::error_already_set&) {  // nothing is lost
    }
    service_ = py::object();
  }

  int places() const override { return places_; }

  std::size_t submit(study::SimulationTask task) override {
    const std::size_t ticket = submitted_++;
    open_.emplace(ticket, task.label);
    call([&] { service_.attr("submit")(ticket, task.key, study::to_json(task).dump()); });
    return ticket;
  }

  std::optional<EndedSimulation> poll() override { return fetch(0.0); }

  EndedSimulation wait() override {
    constexpr double look_up_s = 0.2;
    while (true) {
      if (hooks_.cancelled && hooks_.cancelled()) return drop_one();
      if (auto ended = fetch(look_up_s)) return *std::move(ended);
    }
  }

 private:
  /// Errors of Python without anything that needs the interpreter's lock.
  template <typename Action>
  void call(const Action& action) {
    const py::gil_scoped_acquire acquire;
    try {
      action();
    } catch (const py::error_already_set& error) {
      throw std::runtime_error(std::string(py::str(error.value())));
    }
  }

  std::optional<EndedSimulation> fetch(double timeout_s) {
    if (failure_) return fail_one();
    try {
      return ask(timeout_s);
    } catch (...) {
      failure_ = std::current_exception();
      return fail_one();
    }
  }

  /// When the service itself has failed, so has all that was handed in.
  EndedSimulation fail_one() {
    EndedSimulation failed{.ticket = open_.begin()->first, .simulation = {}, .failure = failure_};
    open_.erase(open_.begin());
    return failed;
  }

  std::optional<EndedSimulation> ask(double timeout_s) {
    std::optional<EndedSimulation> ended;
    std::string outcome;
    call([&] {
      const py::object answer = service_.attr("poll")(timeout_s);
      if (answer.is_none()) return;
      const py::tuple parts = answer;
      ended.emplace();
      ended->ticket = parts[0].cast<std::size_t>();
      if (!parts[1].is_none()) {
        outcome = parts[1].cast<std::string>();
        return;
      }
      ended->failure = std::make_exception_ptr(std::runtime_error(parts[2].cast<std::string>()));
    });
    if (!ended) return std::nullopt;
    open_.erase(ended->ticket);
    if (!ended->failure) {
      ended->simulation = records::simulation_from_json(Json::parse(outcome));
    }
    return ended;
  }

  /// One of the simulations that nobody wants any more.
  EndedSimulation drop_one() {
    if (!std::exchange(dropping_, true)) {
      call([&] { service_.attr("cancel")(); });
    }
    EndedSimulation dropped{.ticket = open_.begin()->first, .simulation = {}};
    dropped.simulation.cancelled = true;
    open_.erase(open_.begin());
    return dropped;
  }

  py::object service_;
  int places_;
  study::ServiceHooks hooks_;
  std::map<std::size_t, std::string> open_;  // labels by ticket
  std::size_t submitted_ = 0;
  bool dropping_ = false;
  std::exception_ptr failure_;  // of the service
};

/// @param make_service called with the number of places. None: the program simulates itself.
int run_program(std::vector<std::string> arguments, const py::object& make_service) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  study::ServiceFactory factory = study::local_service();
  if (!make_service.is_none()) {
    factory = [make = make_service.ptr()](int places, study::ServiceHooks hooks) {
      const py::gil_scoped_acquire acquire;
      try {
        py::object service = py::reinterpret_borrow<py::object>(make)(places);
        return std::make_unique<PythonService>(std::move(service), places, std::move(hooks));
      } catch (const py::error_already_set& error) {
        throw std::runtime_error(std::string(py::str(error.value())));
      }
    };
  }
  const py::gil_scoped_release release;
  return cli::run_parapet(static_cast<int>(arguments.size()), argv.data(), std::move(factory));
}

}  // namespace

void add_program(py::module_& module) {
  module.def("run_program", &run_program);
}

}  // namespace parapet::python
