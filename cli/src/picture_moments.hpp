/// Which moments of a run go into its picture.
#pragma once

#include <cstddef>
#include <vector>

#include "parapet/reports/flow_picture.hpp"

namespace parapet::cli {

/// Takes snapshots at chosen times, or, when none are chosen, at times spread evenly over a run
/// whose length is not known beforehand.
class PictureMoments {
 public:
  /// @param times [s], in any order; empty for evenly spread ones
  explicit PictureMoments(std::vector<double> times);

  /// Offers a frame; frames come in order of time.
  void offer(const solver::Frame& frame);

  /// What was taken: at most `count` of the evenly spread ones, first and last among them.
  std::vector<reports::FlowSnapshot> take(std::size_t count);

  /// Chosen times that the run did not reach [s].
  const std::vector<double>& not_reached() const { return times_; }

 private:
  void offer_evenly(const solver::Frame& frame);

  bool chosen_;
  std::vector<double> times_;  // still to come, ascending
  std::vector<reports::FlowSnapshot> snapshots_;
  std::size_t frames_seen_ = 0;
  std::size_t stride_ = 1;  // every so many frames are kept
};

}  // namespace parapet::cli
