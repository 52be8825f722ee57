/// Progress of long work on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "parapet/solver/simulation.hpp"
#include "session.hpp"

namespace parapet::cli {

/// A line of text (UTF-8) that fits a terminal of so many columns; what is cut off ends with "…".
std::string cut_to_width(const std::string& text, std::size_t columns);

/// One line of progress, what matters most first: a narrow terminal cuts the rest off. Any part may
/// be empty.
/// @param count "4 of 12 designs"
/// @param best "best retention_efficiency 0.83 (0007)"
/// @param left "at most 6 s left"
/// @param running "0005 at 0.79 of 3.00 s, 0006 at 0.43 of 3.00 s"
std::string progress_line(const std::string& count, const std::string& best,
                          const std::string& left, const std::string& running);

/// Shows how far a number of simulations is: on a terminal as one line that is written again, else
/// as a plain line now and then. Safe to call from several threads.
class RunMonitor {
 public:
  /// @param total simulations to come
  /// @param noun what they are, for example "designs"; empty for a single simulation
  RunMonitor(const Session& session, int total, std::string noun);
  ~RunMonitor();
  RunMonitor(const RunMonitor&) = delete;
  RunMonitor& operator=(const RunMonitor&) = delete;

  /// A simulation goes on.
  void running(const std::string& id, const solver::Progress& progress);

  /// A simulation has ended; `skipped` when its answer was there already.
  void ended(const std::string& id, bool skipped);

  /// One of the simulations behind what is counted has ended.
  void simulation_ended(const std::string& id);

  /// The share of the whole work that is done, where it is not a number of simulations.
  void share(double done);

  /// The best so far, in words, for example "best retention_efficiency 0.83 (0007)".
  void best(std::string text);

 private:
  using Clock = std::chrono::steady_clock;
  void show();
  std::string line() const;
  double share_done() const;
  std::string remaining_time() const;

  const Session& session_;
  bool terminal_;
  int total_;
  std::string noun_;
  mutable std::mutex mutex_;
  std::map<std::string, solver::Progress> running_;
  int ended_ = 0;
  int skipped_ = 0;
  std::string best_;
  std::optional<double> share_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  bool line_open_ = false;
};

}  // namespace parapet::cli
