// The local pool of threads as a service: order, places, cancelling, failures, an early end.
#include "parapet/study/local_service.hpp"

#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>

#include "formula_study.hpp"

namespace parapet::test {
namespace {

using study::SimulationTask;

SimulationTask labelled(const std::string& label) {
  SimulationTask task;
  task.label = label;
  return task;
}

records::Simulation good(const std::string& reason = {}) {
  records::Simulation simulation;
  simulation.ok = true;
  simulation.reason = reason;
  return simulation;
}

/// Reports progress until it is told to stop.
records::Simulation until_cancelled(const SimulationTask&, const solver::Callbacks& callbacks) {
  while (callbacks.on_progress({.time = 0.5, .stop_time = 1.0, .steps = 3})) {
    std::this_thread::yield();
  }
  records::Simulation simulation;
  simulation.cancelled = true;
  return simulation;
}

TEST(LocalService, OnePlaceWorksThroughTheTasksInOrder) {
  const auto service = study::local_service(
      [](const SimulationTask& task, const auto&) { return good(task.label); })(1, {});
  EXPECT_EQ(service->places(), 1);
  EXPECT_FALSE(service->poll().has_value()) << "nothing was handed in";
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(service->submit(labelled(std::to_string(k))), k);
  }
  for (std::size_t k = 0; k < 5; ++k) {
    const auto ended = service->wait();
    EXPECT_EQ(ended.ticket, k);
    EXPECT_EQ(ended.simulation.reason, std::to_string(k));
  }
  EXPECT_FALSE(service->poll().has_value()) << "each is fetched once";
}

TEST(LocalService, SoManyPlacesWorkAtOnce) {
  std::atomic<int> running = 0;
  const auto together = [&](const SimulationTask&, const auto&) {
    ++running;
    while (running < 3) std::this_thread::yield();  // ends only if three run at once
    return good();
  };
  const auto service = study::local_service(together)(3, {});
  std::set<std::size_t> tickets;
  for (int k = 0; k < 3; ++k) service->submit(labelled("x"));
  for (int k = 0; k < 3; ++k) tickets.insert(service->wait().ticket);
  EXPECT_EQ(tickets, (std::set<std::size_t>{0, 1, 2}));
}

TEST(LocalService, PollFetchesWithoutWaiting) {
  std::atomic<bool> go = false;
  const auto gated = [&](const SimulationTask&, const auto&) {
    while (!go) std::this_thread::yield();
    return good();
  };
  const auto service = study::local_service(gated)(1, {});
  service->submit(labelled("x"));
  EXPECT_FALSE(service->poll().has_value()) << "it is still running";
  go = true;
  std::optional<study::EndedSimulation> ended;
  while (!ended) ended = service->poll();
  EXPECT_TRUE(ended->simulation.ok);
}

TEST(LocalService, CancellingEndsWhatRunsAndWhatWaits) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> told = 0;
  study::ServiceHooks hooks;
  hooks.cancelled = [&] { return cancelled.load(); };
  hooks.on_progress = [&](const SimulationTask& task, const solver::Progress& progress) {
    EXPECT_EQ(task.label, "first");
    EXPECT_EQ(progress.steps, 3);
    ++told;
  };
  const auto service = study::local_service(until_cancelled)(1, hooks);
  service->submit(labelled("first"));
  service->submit(labelled("second"));
  while (told == 0) std::this_thread::yield();
  cancelled = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto ended = service->wait();
    EXPECT_EQ(ended.ticket, k);
    EXPECT_TRUE(ended.simulation.cancelled);
  }
}

TEST(LocalService, AnExceptionIsAFailureOfItsTaskAlone) {
  const auto service = study::local_service([](const SimulationTask& task, const auto&) {
    if (task.label == "bad") throw std::runtime_error("out of order");
    return good();
  })(2, {});
  service->submit(labelled("bad"));
  service->submit(labelled("good"));
  for (int k = 0; k < 2; ++k) {
    const auto ended = service->wait();
    if (ended.ticket == 1) {
      EXPECT_EQ(ended.failure, nullptr);
      EXPECT_TRUE(ended.simulation.ok);
      continue;
    }
    ASSERT_NE(ended.failure, nullptr);
    EXPECT_THROW(std::rethrow_exception(ended.failure), std::runtime_error);
  }
}

TEST(LocalService, ClosedEarlyItEndsWhatRuns) {
  std::atomic<int> told = 0;
  study::ServiceHooks hooks;
  hooks.on_progress = [&](const SimulationTask&, const solver::Progress&) { ++told; };
  {
    const auto service = study::local_service(until_cancelled)(1, hooks);
    service->submit(labelled("runs"));
    service->submit(labelled("waits"));
    while (told == 0) std::this_thread::yield();
  }  // does not return before the simulation has ended, and that only because it is told to
  EXPECT_GE(told, 1);
}

}  // namespace
}  // namespace parapet::test
