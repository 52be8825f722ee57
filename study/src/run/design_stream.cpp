#include "parapet/study/design_stream.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <stdexcept>

namespace parapet::study {

/// A design whose events are under way.
struct DesignStream::Open {
  StreamedDesign asked;
  DesignRun run;
  std::size_t left;  // events that have not ended
};

designs::StudySpec with_one_scenario(const designs::StudySpec& study, const std::string& scenario) {
  designs::StudySpec one = study;
  std::erase_if(one.scenarios, [&](const designs::Scenario& s) { return s.name != scenario; });
  if (one.scenarios.empty()) {
    throw std::invalid_argument("the study " + study.name + " has no scenario " + scenario);
  }
  one.scenarios.resize(1);
  one.scenarios.front().weight = 1.0;
  return one;
}

DesignStream::DesignStream(const designs::StudySpec& study, int jobs, ServiceHooks hooks,
                           Answer answer, Simulator simulator)
    : study_(study),
      hooks_(std::move(hooks)),
      answer_(std::move(answer)),
      simulator_(std::move(simulator)) {
  for (int k = 0; k < std::max(1, jobs); ++k) workers_.emplace_back([this] { work(); });
}

DesignStream::~DesignStream() {
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    queue_.clear();
  }
  changed_.notify_all();
}

bool DesignStream::cancelled() const {
  return closed_ || (hooks_.cancelled && hooks_.cancelled());
}

const designs::StudySpec& DesignStream::study_of(const std::string& scenario) {
  if (scenario.empty()) return study_;
  const auto found = one_event_.find(scenario);
  if (found != one_event_.end()) return found->second;
  return one_event_.emplace(scenario, with_one_scenario(study_, scenario)).first->second;
}

namespace {

/// How often a waiting thread looks whether it was cancelled.
constexpr std::chrono::milliseconds look_up{100};

}  // namespace

void DesignStream::put(StreamedDesign design) {
  std::unique_lock lock(mutex_);
  while (!failure_ && !cancelled() && !queue_.empty()) changed_.wait_for(lock, look_up);
  if (failure_) std::rethrow_exception(failure_);
  if (cancelled()) return;
  DesignRun run(study_of(design.scenario), design.design, design.spacing);
  const std::size_t events = run.size();
  const auto open = std::make_shared<Open>(Open{std::move(design), std::move(run), events});
  for (std::size_t event = 0; event < events; ++event) queue_.emplace_back(open, event);
  ++open_;
  lock.unlock();
  changed_.notify_all();
}

bool DesignStream::finish() {
  std::unique_lock lock(mutex_);
  ended_ = true;
  changed_.notify_all();
  while (!failure_ && !cancelled() && open_ > 0) changed_.wait_for(lock, look_up);
  if (failure_) std::rethrow_exception(failure_);
  return open_ == 0;
}

records::Simulation DesignStream::simulate(const Open& open, std::size_t event) const {
  solver::Callbacks callbacks;
  try {
    const SimulationTask task = open.run.task(event, std::to_string(open.asked.number), 1);
    callbacks.on_progress = [&](const solver::Progress& progress) {
      if (hooks_.on_progress) hooks_.on_progress(task, progress);
      return !cancelled();
    };
    return simulator_(task, callbacks);
  } catch (const designs::InputError& error) {
    return impossible_scene(error.what());
  } catch (const std::bad_alloc&) {
    records::Simulation failed;
    failed.reason = "out of memory";
    failed.report = designs::Json::object();
    return failed;
  }
}

void DesignStream::end(const std::shared_ptr<Open>& open, std::size_t event,
                       records::Simulation simulation) {
  {
    const std::scoped_lock lock(mutex_);
    open->run.set(event, std::move(simulation));
    if (--open->left > 0) return;
  }
  const std::scoped_lock one_at_a_time(answering_);
  answer_(open->asked, open->run);
  const std::scoped_lock lock(mutex_);
  --open_;
}

void DesignStream::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closed_ || failure_ || ended_ || !queue_.empty(); });
    if (closed_ || failure_ || (ended_ && queue_.empty())) return;
    const Event next = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    changed_.notify_all();
    try {
      records::Simulation simulation = simulate(*next.first, next.second);
      if (!simulation.cancelled) end(next.first, next.second, std::move(simulation));
    } catch (...) {
      const std::scoped_lock failing(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    changed_.notify_all();
    lock.lock();
  }
}

}  // namespace parapet::study
