#include "case.hpp"

#include <algorithm>
#include <cmath>
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

void CaseRun::watch_masses(const solver::Flow& flow) const {
  const std::vector<double>& mass = flow.fluid().mass;
  const auto end = mass.begin() + flow.fluid().n;
  if (flow.fluid().n < 2) return;
  const double n = flow.fluid().n;
  double mean = 0.0, squares = 0.0;
  for (auto m = mass.begin(); m != end; ++m) mean += *m / n;
  for (auto m = mass.begin(); m != end; ++m) squares += (*m / mean - 1.0) * (*m / mean - 1.0) / n;
  const auto [least, largest] = std::minmax_element(mass.begin(), end);
  const std::scoped_lock lock(mutex_);
  masses_.seen = true;
  masses_.deviation = std::max(masses_.deviation, std::sqrt(squares));
  masses_.least = std::min(masses_.least, *least / mean);
  masses_.largest = std::max(masses_.largest, *largest / mean);
}

void CaseRun::add_masses() {
  if (!masses_.seen) return;
  add({.key = "masses_deviation",
       .what = "standard deviation of the particles' masses, worst of all flows and times",
       .value = 100.0 * masses_.deviation,
       .unit = "%",
       .upper = 4.0,
       .reason = "shifting exchanges mass; what it drives apart is levelled out",
       .explanation = "in flows for comparison, such as thin fluids with the settings of debris; "
                      "levelling is slow, so as not to act as friction"});
  add({.key = "masses_least", .what = "lightest particle over the mean", .value = masses_.least});
  add({.key = "masses_largest",
       .what = "heaviest particle over the mean",
       .value = masses_.largest});
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
