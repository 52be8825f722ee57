/// Designs of a study one after the other, from whoever has them, answered as each ends.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "parapet/study/design_run.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::study {

/// A design that a stream is to evaluate.
struct StreamedDesign {
  std::size_t number = 0;  ///< the caller's own: tells the answers apart
  designs::Design design;
  double spacing = 0.0;  ///< particle spacing [m]
  std::string scenario;  ///< the only event; empty: every event of the study
};

/// The study with one of its scenarios as its only event.
/// @throws std::invalid_argument without such a scenario
designs::StudySpec with_one_scenario(const designs::StudySpec& study, const std::string& scenario);

/// Evaluates designs while more come in. Each event of a design is one simulation on one thread;
/// `jobs` of them run at once, those of a design before those of the next.
///
/// One thread calls put() and finish(). What cannot be simulated is a failed simulation with its
/// reason.
class DesignStream {
 public:
  /// Told of a design whose events have all ended: from the stream's threads, one at a time. What
  /// it throws ends the stream.
  using Answer = std::function<void(const StreamedDesign& design, const DesignRun& run)>;

  /// The study must outlive the stream.
  DesignStream(const designs::StudySpec& study, int jobs, ServiceHooks hooks, Answer answer,
               Simulator simulator = solver_simulator());

  /// Drops what has not begun and cancels what runs; nobody learns of it.
  ~DesignStream();
  DesignStream(const DesignStream&) = delete;             ///< not copied
  DesignStream& operator=(const DesignStream&) = delete;  ///< likewise

  /// Hands a design in; waits while a simulation waits for a thread, so that a stream of any length
  /// needs no more memory. A cancelled stream takes nothing.
  /// @throws std::invalid_argument for an unknown scenario; what the answer threw
  void put(StreamedDesign design);

  /// Waits until every design is answered or the stream is cancelled.
  /// @return false when it was cancelled
  /// @throws what the answer threw
  bool finish();

 private:
  struct Open;
  using Event = std::pair<std::shared_ptr<Open>, std::size_t>;

  const designs::StudySpec& study_of(const std::string& scenario);
  bool cancelled() const;
  void work();
  records::Simulation simulate(const Open& open, std::size_t event) const;
  void end(const std::shared_ptr<Open>& open, std::size_t event, records::Simulation simulation);

  const designs::StudySpec& study_;
  ServiceHooks hooks_;
  Answer answer_;
  Simulator simulator_;
  std::mutex mutex_;  // guards all below but the atomic
  std::condition_variable changed_;
  std::map<std::string, designs::StudySpec> one_event_;  // by scenario
  std::deque<Event> queue_;
  std::size_t open_ = 0;  // designs that are not answered
  bool ended_ = false;    // no more will come
  std::exception_ptr failure_;
  std::mutex answering_;
  std::atomic<bool> closed_ = false;
  std::vector<std::jthread> workers_;  // last: they end before what they use
};

}  // namespace parapet::study
