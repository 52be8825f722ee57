#include "parapet/study/local_service.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace parapet::study {
namespace {

class LocalService : public SimulationService {
 public:
  LocalService(Simulator simulator, int places, ServiceHooks hooks)
      : simulator_(std::move(simulator)), hooks_(std::move(hooks)), places_(std::max(1, places)) {
    for (int k = 0; k < places_; ++k) workers_.emplace_back([this] { work(); });
  }

  ~LocalService() override {
    {
      const std::scoped_lock lock(mutex_);
      closed_ = true;
    }
    handed_in_.notify_all();
  }

  LocalService(const LocalService&) = delete;
  LocalService& operator=(const LocalService&) = delete;

  int places() const override { return places_; }

  std::size_t submit(SimulationTask task) override {
    std::size_t ticket = 0;
    {
      const std::scoped_lock lock(mutex_);
      ticket = submitted_++;
      waiting_.emplace_back(ticket, std::move(task));
    }
    handed_in_.notify_one();
    return ticket;
  }

  std::optional<EndedSimulation> poll() override {
    std::unique_lock lock(mutex_);
    if (ended_.empty()) return std::nullopt;
    return fetch();
  }

  EndedSimulation wait() override {
    std::unique_lock lock(mutex_);
    has_ended_.wait(lock, [this] { return !ended_.empty(); });
    return fetch();
  }

 private:
  EndedSimulation fetch() {  // with mutex_ held
    EndedSimulation first = std::move(ended_.front());
    ended_.pop_front();
    return first;
  }

  bool cancelled() const { return closed_ || (hooks_.cancelled && hooks_.cancelled()); }

  EndedSimulation simulate(std::size_t ticket, const SimulationTask& task) const {
    EndedSimulation ended{.ticket = ticket, .simulation = {}};
    if (cancelled()) {
      ended.simulation.cancelled = true;
      return ended;
    }
    solver::Callbacks callbacks;
    callbacks.on_progress = [&](const solver::Progress& progress) {
      if (hooks_.on_progress) hooks_.on_progress(task, progress);
      return !cancelled();
    };
    try {
      ended.simulation = simulator_(task, callbacks);
    } catch (...) {
      ended.failure = std::current_exception();
    }
    return ended;
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      handed_in_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
      if (closed_) return;
      const auto [ticket, task] = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      EndedSimulation ended = simulate(ticket, task);
      lock.lock();
      ended_.push_back(std::move(ended));
      has_ended_.notify_one();
    }
  }

  Simulator simulator_;
  ServiceHooks hooks_;
  int places_;
  std::mutex mutex_;  // guards all below
  std::condition_variable handed_in_, has_ended_;
  std::deque<std::pair<std::size_t, SimulationTask>> waiting_;
  std::deque<EndedSimulation> ended_;
  std::size_t submitted_ = 0;
  std::atomic<bool> closed_ = false;   // read without the lock while a simulation runs
  std::vector<std::jthread> workers_;  // last: they end before what they use
};

}  // namespace

ServiceFactory local_service(Simulator simulator) {
  return [simulator = std::move(simulator)](int places, ServiceHooks hooks) {
    return std::make_unique<LocalService>(simulator, places, std::move(hooks));
  };
}

}  // namespace parapet::study
