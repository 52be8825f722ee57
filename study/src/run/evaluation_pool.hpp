/// The loop of every study: designs are simulated as they are proposed, none waiting for another.
#pragma once

#include <chrono>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "design_source.hpp"
#include "parapet/study/study_context.hpp"

namespace parapet::study {

/// Limits beyond which nothing new is simulated; what is running ends first. 0: none.
struct PoolLimits {
  double max_cpu_time = 0.0;    ///< of all designs in the log [s]
  double max_time = 0.0;        ///< of this run [s]
  std::size_t max_designs = 0;  ///< in the log
};

enum class PoolEnd { source_ended, cpu_time, time, designs, cancelled };

/// Evaluates what a source proposes. While the service has a place free, a simulation (a design
/// under one event) is taken from a queue and handed in; when the queue is empty, the source is
/// asked. A design that the log holds is answered from there.
///
/// With method/repeatable, a design that has ended waits on disk (evaluations/ID-base.json, or one
/// file for each scenario) until all that were proposed before it stand in the log, so that the
/// log's order does not depend on which simulation ends first.
///
/// Ids follow the order of the proposals, so that they do not depend on which of several
/// simulations side by side ends first; a design that an earlier run left incomplete keeps its id.
///
/// Everything but the simulations happens on the thread that calls run().
class EvaluationPool {
 public:
  /// @param context and source must outlive the pool
  /// @param after_answer called after each answer. May be empty.
  EvaluationPool(const StudyContext& context, DesignSource& source, const PoolLimits& limits,
                 std::function<void()> after_answer);

  /// Until the source has nothing more, a limit is reached or the study is cancelled. What runs
  /// then, or when something fails, ends first and is stored.
  /// @throws the first failure: records::FileError, the source's or the service's exceptions.
  PoolEnd run();

 private:
  /// A design on its way.
  struct Flight {
    std::unique_ptr<DesignJob> job;
    designs::Design design;
    double spacing = 0.0;
    int threads = 1;                   // of each simulation
    std::vector<std::size_t> numbers;  // of the proposals that wait for it
  };
  using Event = std::pair<std::shared_ptr<Flight>, std::size_t>;

  bool step();
  bool stopped() const;
  bool place_free() const;
  bool begin_next();
  void begin_at_once();
  bool limit_reached();
  void launch(const std::vector<Proposal>& proposals);
  std::shared_ptr<Flight> flight_for(std::size_t number, const Proposal& proposal);
  std::string id_for(std::size_t number, const Proposal& proposal);
  std::vector<Event> fetch_ended();
  Event settle(EndedSimulation ended);
  static std::vector<std::exception_ptr> write(const std::vector<std::function<void()>>& writes);
  void store(std::vector<Event> ended);
  void complete(const std::vector<std::shared_ptr<Flight>>& complete_ones);
  void log(const std::vector<std::shared_ptr<Flight>>& flights);
  void answer(std::size_t number, const records::EvaluationRecord& record);

  const StudyContext& context_;
  DesignSource& source_;
  PoolLimits limits_;
  std::function<void()> after_answer_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();

  std::deque<Event> queue_;                 // not handed in yet
  std::map<std::size_t, Event> under_way_;  // by ticket
  std::vector<Event> ended_at_once_;        // known from before, or impossible; to be stored
  std::vector<std::shared_ptr<Flight>> flights_;
  std::set<std::string> ids_given_;
  std::size_t proposals_ = 0;
  bool ended_ = false;
  bool cancelled_ = false;
  PoolEnd end_ = PoolEnd::source_ended;
  std::exception_ptr failure_;
};

}  // namespace parapet::study
