/// Long work that Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>
#include <thread>

namespace parapet::python {

/// Does the work on a thread of its own, without the interpreter's lock, and listens meanwhile:
/// when a signal's handler raises (Ctrl-C does), or `meanwhile` does, the work is told to stop, and
/// the exception goes on when it has.
/// @param work of the form R(const std::atomic<bool>& cancelled)
/// @param meanwhile called twenty times a second with the interpreter's lock. May be empty.
template <typename Work>
auto run_interruptibly(const Work& work, const std::function<void()>& meanwhile = {}) {
  namespace py = pybind11;
  using Result = decltype(work(std::declval<const std::atomic<bool>&>()));
  constexpr std::chrono::milliseconds tick{50};
  std::atomic<bool> cancelled = false;
  std::promise<Result> promise;
  std::future<Result> future = promise.get_future();
  std::jthread thread([&] {
    try {
      promise.set_value(work(cancelled));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  });
  while (true) {
    std::future_status status{};
    {
      const py::gil_scoped_release release;
      status = future.wait_for(tick);
    }
    if (status == std::future_status::ready) return future.get();
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (meanwhile) meanwhile();
    } catch (...) {
      cancelled = true;
      const py::gil_scoped_release release;
      future.wait();
      throw;
    }
  }
}

}  // namespace parapet::python
