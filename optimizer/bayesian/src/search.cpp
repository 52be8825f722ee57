#include "parapet/bayesian/search.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "parapet/math/pareto.hpp"
#include "problem_checks.hpp"
#include "search_state.hpp"

namespace parapet::bayesian {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::string to_string(StopReason reason) {
  switch (reason) {
    case StopReason::none:
      return "none";
    case StopReason::budget:
      return "budget";
    case StopReason::seconds:
      return "seconds";
    case StopReason::stagnation:
      return "stagnation";
    case StopReason::small_gain:
      return "small_gain";
    case StopReason::exhausted:
      return "exhausted";
    case StopReason::no_allowed_design:
      return "no_allowed_design";
  }
  return "unknown";
}

Search::Search(Problem problem, SearchOptions options) {
  if (const std::string error = problem_error(problem, options); !error.empty()) {
    throw std::invalid_argument(error);
  }
  state_ = std::make_unique<State>(std::move(problem), std::move(options));
}

Search::~Search() = default;
Search::Search(Search&&) noexcept = default;
Search& Search::operator=(Search&&) noexcept = default;

std::optional<Suggestion> Search::ask() {
  const Stopwatch stopwatch(state_->own_time);
  return state_->ask();
}

void Search::tell(int id, const Observation& observation) {
  const Stopwatch stopwatch(state_->own_time);
  const auto found = state_->pending.find(id);
  if (found == state_->pending.end()) {
    throw std::invalid_argument("evaluation " + std::to_string(id) + " is not pending");
  }
  const Suggestion suggestion = found->second;
  state_->check_point(suggestion.x, suggestion.level, observation);
  state_->pending.erase(found);
  state_->add_told(id, suggestion.x, suggestion.level, observation);
  state_->told.back().local = suggestion.stage == "local";
}

int Search::tell_external(const Point& x, int level, const Observation& observation) {
  const Stopwatch stopwatch(state_->own_time);
  state_->check_point(x, level, observation);
  return state_->add_told(state_->next_id++, state_->problem.space.canonical(x), level,
                          observation);
}

void Search::revise(const std::vector<std::vector<std::optional<double>>>& values) {
  const Stopwatch stopwatch(state_->own_time);
  state_->revise(values);
}

StopReason Search::stop_reason() const {
  return state_->stop;
}

int Search::evaluations() const {
  return static_cast<int>(state_->told.size());
}

double Search::seconds() const {
  return state_->spent;
}

std::vector<double> Search::reference() const {
  std::vector<double> reference;
  for (Eigen::Index j = 0; j < state_->history_reference.size(); ++j) {
    const bool maximize = state_->problem.objectives[static_cast<std::size_t>(j)].maximize;
    reference.push_back(maximize ? -state_->history_reference[j] : state_->history_reference[j]);
  }
  return reference;
}

const std::vector<HistoryEntry>& Search::history() const {
  return state_->history;
}

const surrogate::GaussianProcess* Search::surrogate(std::size_t metric) const {
  return state_->up_to_date().process(metric);
}

const surrogate::SuccessModel* Search::success_model() const {
  return state_->up_to_date().success();
}

const Problem& Search::problem() const {
  return state_->problem;
}

double Search::own_seconds() const {
  return state_->own_time;
}

}  // namespace parapet::bayesian
