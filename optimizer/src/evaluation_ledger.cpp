#include "evaluation_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include "feasibility.hpp"

namespace parapet::optimizer {
namespace {

std::string cache_key(const std::vector<double>& x) {
  std::string key(x.size() * sizeof(double), '\0');
  std::memcpy(key.data(), x.data(), key.size());
  return key;
}

/// Where an expression overflows or is undefined, a large number says the same; NaN is a violation.
double finite_cheap(double c) {
  if (std::isfinite(c)) return c;
  return c < 0.0 ? -1e3 : 1e3;
}

/// An evaluation that is not what it promises becomes a failed one.
Evaluation checked(Evaluation evaluation, int n_constraints) {
  if (!evaluation.ok) {
    evaluation.constraints.clear();
    return evaluation;
  }
  if (evaluation.constraints.size() != static_cast<std::size_t>(n_constraints)) {
    throw std::logic_error(
        "the evaluator answered " + std::to_string(evaluation.constraints.size()) +
        " constraint values where the problem has " + std::to_string(n_constraints));
  }
  std::string reason;
  if (!std::isfinite(evaluation.objective)) reason = "the objective is not a finite number";
  for (std::size_t k = 0; k < evaluation.constraints.size() && reason.empty(); ++k) {
    if (!std::isfinite(evaluation.constraints[k])) {
      reason = "constraint " + std::to_string(k) + " is not a finite number";
    }
  }
  if (!reason.empty()) evaluation = Evaluation{.ok = false, .reason = reason, .constraints = {}};
  return evaluation;
}

}  // namespace

EvaluationLedger::EvaluationLedger(const Problem& problem, const Options& options,
                                   const UnitBox& box)
    : problem_(problem), options_(options), box_(box) {}

void EvaluationLedger::check_limits() const {
  if (options_.cancelled && options_.cancelled()) {
    throw StopSearch{Termination::cancelled, "cancelled"};
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  if (options_.max_time_s > 0.0 && elapsed.count() >= options_.max_time_s) {
    throw StopSearch{Termination::time_limit, "the time limit was reached"};
  }
}

void EvaluationLedger::guard_against_stalling() {
  constexpr int allowed = 20000;  // ten subproblems of a global algorithm that repeats itself
  if (++queries_since_evaluation_ <= allowed + 20 * evaluations()) return;
  throw StopSearch{Termination::converged,
                   "the last " + std::to_string(queries_since_evaluation_ - 1) +
                       " points proposed were all evaluated before or refused by the cheap "
                       "constraints: nothing new to try"};
}

std::vector<double> EvaluationLedger::cheap_values(const std::vector<double>& x) const {
  if (problem_.n_cheap_constraints == 0) return {};
  std::vector<double> values = problem_.cheap_constraints(x);
  if (values.size() != static_cast<std::size_t>(problem_.n_cheap_constraints)) {
    throw std::logic_error("cheap_constraints answered " + std::to_string(values.size()) +
                           " values where the problem has " +
                           std::to_string(problem_.n_cheap_constraints));
  }
  return values;
}

Evaluation EvaluationLedger::evaluate(const std::vector<double>& x) const {
  if (problem_.evaluate) return problem_.evaluate(x);
  const std::vector<Evaluation> answers = problem_.evaluate_batch({x});
  if (answers.size() != 1) throw std::logic_error("evaluate_batch answered a wrong count");
  return answers.front();
}

void EvaluationLedger::evaluate_starts(const std::vector<std::vector<double>>& xs) {
  std::vector<std::vector<double>> batch;
  std::unordered_map<std::string, std::size_t> seen;
  for (const auto& x : xs) {
    if (seen.emplace(cache_key(x), batch.size()).second) {
      batch.push_back(x);
    } else {
      ++cache_hits_;
    }
  }
  if (problem_.evaluate_batch) {
    check_limits();
    std::vector<Evaluation> answers = problem_.evaluate_batch(batch);
    if (answers.size() != batch.size()) {
      throw std::logic_error("evaluate_batch answered " + std::to_string(answers.size()) +
                             " points of " + std::to_string(batch.size()));
    }
    for (std::size_t i = 0; i < batch.size(); ++i) record(batch[i], std::move(answers[i]), true);
    return;
  }
  for (const auto& x : batch) {
    check_limits();
    record(x, evaluate(x), true);
  }
}

const Point& EvaluationLedger::record(const std::vector<double>& x, Evaluation evaluation,
                                      bool starting) {
  Point point{.x = x,
              .evaluation = checked(std::move(evaluation), problem_.n_constraints),
              .feasible = false,
              .starting = starting};
  const Evaluation& answer = point.evaluation;
  if (answer.ok) {
    const double tolerance = options_.feasibility_tolerance;
    point.feasible =
        violation(answer.constraints) <= tolerance && violation(cheap_values(x)) <= tolerance;
    if (n_success_ == 0) {
      best_objective_ = worst_objective_ = answer.objective;
      worst_constraints_ = answer.constraints;
    }
    best_objective_ = std::min(best_objective_, answer.objective);
    worst_objective_ = std::max(worst_objective_, answer.objective);
    for (std::size_t k = 0; k < worst_constraints_.size(); ++k) {
      worst_constraints_[k] = std::max(worst_constraints_[k], answer.constraints[k]);
    }
    ++n_success_;
  }
  cache_.emplace(cache_key(x), history_.size());
  units_.push_back(box_.to_unit(x));
  history_.push_back(std::move(point));
  queries_since_evaluation_ = 0;
  return history_.back();
}

void EvaluationLedger::refuse(const std::vector<double>& x) {
  ++rejected_;
  if (options_.on_refused) options_.on_refused(x);
}

Reply EvaluationLedger::ask(const std::vector<double>& u) {
  const std::vector<double> x = box_.from_unit(u);
  check_limits();
  guard_against_stalling();
  if (const auto found = cache_.find(cache_key(x)); found != cache_.end()) {
    ++cache_hits_;
    return reply_at(history_[found->second]);
  }
  std::vector<double> cheap = cheap_values(x);
  if (violation(cheap) > options_.feasibility_tolerance) {
    refuse(x);
    Reply reply = reply_at(nearest_success(u));
    std::transform(cheap.begin(), cheap.end(), reply.constraints.begin(), finite_cheap);
    return reply;
  }
  if (remaining() <= 0) {
    throw StopSearch{
        Termination::budget,
        "the budget of " + std::to_string(options_.max_evaluations) + " evaluations is used up"};
  }
  return reply_at(record(x, evaluate(x), false));
}

Reply EvaluationLedger::reply_at(const Point& point) const {
  Reply reply;
  reply.constraints = cheap_values(point.x);
  for (double& c : reply.constraints) c = finite_cheap(c);
  const Evaluation& answer = point.evaluation;
  const auto& expensive = answer.ok ? answer.constraints : worst_constraints_;
  reply.constraints.insert(reply.constraints.end(), expensive.begin(), expensive.end());
  if (answer.ok) {
    reply.objective = answer.objective;
  } else {
    const double spread = worst_objective_ - best_objective_;
    const double floor = 1e-3 * std::max(1.0, std::abs(worst_objective_));
    reply.objective = worst_objective_ + std::max(0.1 * spread, floor);
  }
  return reply;
}

const Point& EvaluationLedger::nearest_success(const std::vector<double>& u) const {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < units_.size(); ++p) {
    if (!history_[p].evaluation.ok) continue;
    double distance = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      distance += (units_[p][i] - u[i]) * (units_[p][i] - u[i]);
    }
    if (distance < least) {
      least = distance;
      nearest = p;
    }
  }
  return history_[nearest];
}

}  // namespace parapet::optimizer
