#include "picture_moments.hpp"

#include <algorithm>
#include <utility>

namespace parapet::cli {
namespace {

constexpr std::size_t most_kept = 24;

}  // namespace

PictureMoments::PictureMoments(std::vector<double> times)
    : chosen_(!times.empty()), times_(std::move(times)) {
  std::sort(times_.begin(), times_.end());
}

void PictureMoments::offer(const solver::Frame& frame) {
  if (!chosen_) {
    offer_evenly(frame);
    return;
  }
  constexpr double rounding = 1e-9;
  if (times_.empty() || frame.time < times_.front() - rounding) return;
  snapshots_.push_back(reports::take_snapshot(frame));
  while (!times_.empty() && times_.front() <= frame.time + rounding) times_.erase(times_.begin());
}

void PictureMoments::offer_evenly(const solver::Frame& frame) {
  const bool new_time = snapshots_.empty() || frame.time > snapshots_.back().time;
  if (frame.last) {
    if (new_time) snapshots_.push_back(reports::take_snapshot(frame));
    return;
  }
  if (frames_seen_++ % stride_ != 0) return;
  snapshots_.push_back(reports::take_snapshot(frame));
  if (snapshots_.size() <= most_kept) return;
  // Too many: every other one goes, and from now on only every other frame comes.
  std::size_t kept = 0;
  for (std::size_t k = 0; k < snapshots_.size(); k += 2) {
    if (kept != k) snapshots_[kept] = std::move(snapshots_[k]);
    ++kept;
  }
  snapshots_.resize(kept);
  stride_ *= 2;
}

std::vector<reports::FlowSnapshot> PictureMoments::take(std::size_t count) {
  if (chosen_ || snapshots_.size() <= count || count < 2) return std::move(snapshots_);
  std::vector<reports::FlowSnapshot> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(snapshots_[k * (snapshots_.size() - 1) / (count - 1)]);
  }
  return chosen;
}

}  // namespace parapet::cli
