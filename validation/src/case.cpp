#include "case.hpp"

#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "slots.hpp"

namespace parapet::validation {

CaseRun::CaseRun(Scorecard& card, std::filesystem::path folder, Slots& slots)
    : card_(card), folder_(std::move(folder)), slots_(slots) {}

void CaseRun::side_by_side(std::size_t count, const std::function<void(std::size_t)>& task,
                           const std::vector<double>& cost_s) {
  const auto cost = [&](std::size_t k) { return k < cost_s.size() ? cost_s[k] : 1.0; };
  for (std::size_t k = 0; k < count; ++k) slots_.expect(cost(k));
  std::mutex mutex;
  std::exception_ptr failure;
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < count; ++k) {
      threads.emplace_back([&, k] {
        try {
          slots_.run([&] { task(k); }, cost(k));
        } catch (...) {
          const std::scoped_lock lock(mutex);
          if (!failure) failure = std::current_exception();
        }
      });
    }
  }
  if (failure) std::rethrow_exception(failure);
}

void CaseRun::alone(const std::function<void()>& task, double cost_s) {
  slots_.expect(cost_s);
  slots_.run(task, cost_s);
}

void CaseRun::check_cancelled() const {
  if (slots_.cancelled()) throw Cancelled{};
}

void CaseRun::add(Measure measure) {
  if (card_.find(measure.key)) {
    throw std::logic_error("case " + card_.name + " has two measures \"" + measure.key + "\"");
  }
  card_.measures.push_back(std::move(measure));
}

std::filesystem::path CaseRun::figure(std::string_view file_name) {
  const std::string name = card_.name + "_" + std::string(file_name);
  card_.figures.push_back(name);
  return folder_ / name;
}

}  // namespace parapet::validation
