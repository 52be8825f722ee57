/// Workers that simulate designs as they are proposed, none waiting for another.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "parapet/study/study_context.hpp"

namespace parapet::study {

/// A design to be evaluated.
struct Proposal {
  std::string stage;
  designs::Design design;
  double spacing = 0.0;  ///< [m]
};

/// Where designs come from. Called by one thread at a time.
class DesignSource {
 public:
  virtual ~DesignSource() = default;

  /// The next design; nothing while an answer must come first, or for good.
  virtual std::optional<Proposal> next() = 0;

  /// The record of the proposal of this number, counted from 0 in the order of next().
  virtual void answered(std::size_t number, const records::EvaluationRecord& record) = 0;
};

/// Limits beyond which nothing new is simulated; what is running ends first. 0: none.
struct PoolLimits {
  double max_cpu_time = 0.0;  ///< of all designs in the log [s]
  double max_time = 0.0;      ///< of this run [s]
};

enum class PoolEnd { source_ended, cpu_time, time, cancelled };

/// Simulates what a source proposes. `jobs` workers take simulations (a design under one event)
/// from a queue; when it is empty, the source is asked, by one worker at a time. A design that the
/// log holds is answered from there. Each simulation takes one thread.
///
/// Ids follow the order of the proposals, so that they do not depend on which of several
/// simulations side by side ends first; a design that an earlier run left incomplete keeps its id.
class EvaluationPool {
 public:
  /// @param context and source must outlive the pool
  /// @param after_answer called after each answer, with the log at rest. May be empty.
  EvaluationPool(const StudyContext& context, DesignSource& source, int jobs,
                 const PoolLimits& limits, std::function<void()> after_answer);

  /// @throws what a worker threw: records::FileError, or the source's exceptions.
  PoolEnd run();

 private:
  struct Flight {
    std::unique_ptr<DesignJob> job;
    designs::Design design;
    double spacing = 0.0;
    std::vector<std::size_t> numbers;  // of the proposals that wait for it
  };
  using Task = std::pair<std::shared_ptr<Flight>, std::size_t>;

  void work();
  bool stopped() const;
  std::optional<Task> take();
  bool limit_reached();  // with log_mutex_ held
  void launch(std::size_t number, const Proposal& proposal);
  std::string id_for(std::size_t number, const Proposal& proposal);
  void simulate(const Task& task, std::unique_lock<std::mutex>& lock);
  void answer(std::size_t number, const records::EvaluationRecord& record);

  const StudyContext& context_;
  DesignSource& source_;
  int jobs_;
  PoolLimits limits_;
  std::function<void()> after_answer_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();

  std::mutex mutex_;      // guards the source and all below; taken before log_mutex_
  std::mutex log_mutex_;  // guards the folder and the hook on_evaluated
  std::condition_variable changed_;
  std::deque<Task> queue_;
  std::vector<std::shared_ptr<Flight>> flights_;
  std::set<std::string> ids_given_;
  std::size_t proposals_ = 0;
  int running_ = 0;
  bool ended_ = false;
  PoolEnd end_ = PoolEnd::source_ended;
  std::atomic<bool> cancelled_ = false;
  std::exception_ptr failure_;
};

}  // namespace parapet::study
