#include "slots.hpp"

#include <utility>

#include "case.hpp"

namespace parapet::validation {

Slots::Slots(int count, std::function<bool()> cancelled,
             std::function<void(double, double)> on_progress)
    : free_(count), cancelled_(std::move(cancelled)), on_progress_(std::move(on_progress)) {}

void Slots::expect(double cost_s) {
  const std::scoped_lock lock(mutex_);
  expected_ += cost_s;
}

void Slots::run(const std::function<void()>& task, double cost_s) {
  {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [&] { return free_ > 0; });
    --free_;
  }
  try {
    if (cancelled()) throw Cancelled{};
    task();
  } catch (...) {
    finished(cost_s);
    throw;
  }
  finished(cost_s);
}

void Slots::finished(double cost_s) {
  const std::scoped_lock lock(mutex_);
  ++free_;
  done_ += cost_s;
  if (on_progress_) on_progress_(done_, expected_);
  freed_.notify_one();
}

}  // namespace parapet::validation
