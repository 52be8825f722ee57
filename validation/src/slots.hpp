// A limited number of flows at a time.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace parapet::validation {

class Slots {
 public:
  Slots(int count, std::function<bool()> cancelled,
        std::function<void(double done, double total)> on_progress);

  // Announces a task to come, for the progress.
  void expect(double cost_s);
  // Waits for a free slot and runs the task in it. Throws Cancelled instead once the suite is
  // cancelled.
  void run(const std::function<void()>& task, double cost_s);
  bool cancelled() const { return cancelled_ && cancelled_(); }

 private:
  void finished(double cost_s);

  std::mutex mutex_;
  std::condition_variable freed_;
  int free_;
  double done_ = 0.0, expected_ = 0.0;
  std::function<bool()> cancelled_;
  std::function<void(double, double)> on_progress_;
};

}  // namespace parapet::validation
