#include "parapet/study/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace parapet::study {

void run_side_by_side(std::size_t count, int jobs,
                      const std::function<void(std::size_t index, int threads)>& task,
                      const std::function<bool()>& stop) {
  if (count == 0) return;
  const auto n_jobs = static_cast<std::size_t>(std::max(1, jobs));
  const std::size_t n_workers = std::min(count, n_jobs);
  const int threads = static_cast<int>(n_jobs / n_workers);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr first_failure;
  std::mutex mutex;
  const auto work = [&] {
    while (!failed && !(stop && stop())) {
      const std::size_t index = next++;
      if (index >= count) return;
      try {
        task(index, threads);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!first_failure) first_failure = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t w = 1; w < n_workers; ++w) workers.emplace_back(work);
    work();
  }
  if (first_failure) std::rethrow_exception(first_failure);
}

}  // namespace parapet::study
