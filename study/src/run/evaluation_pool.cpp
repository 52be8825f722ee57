#include "evaluation_pool.hpp"

#include <algorithm>
#include <thread>

namespace parapet::study {

EvaluationPool::EvaluationPool(const StudyContext& context, DesignSource& source, int jobs,
                               const PoolLimits& limits, std::function<void()> after_answer)
    : context_(context),
      source_(source),
      jobs_(std::max(1, jobs)),
      limits_(limits),
      after_answer_(std::move(after_answer)) {}

PoolEnd EvaluationPool::run() {
  {
    std::vector<std::jthread> workers;
    for (int k = 1; k < jobs_; ++k) workers.emplace_back([this] { work(); });
    work();
  }
  if (failure_) std::rethrow_exception(failure_);
  return cancelled_ || context_.cancelled() ? PoolEnd::cancelled : end_;
}

bool EvaluationPool::stopped() const {
  return ended_ || failure_ || cancelled_ || context_.cancelled();
}

void EvaluationPool::work() {
  std::unique_lock lock(mutex_);
  try {
    while (!stopped()) {
      if (const auto task = take()) {
        simulate(*task, lock);
      } else if (running_ == 0) {
        ended_ = true;
      } else {
        changed_.wait(lock);  // for the end of a simulation that runs
      }
    }
  } catch (...) {
    if (!lock.owns_lock()) lock.lock();
    if (!failure_) failure_ = std::current_exception();
  }
  changed_.notify_all();
}

std::optional<EvaluationPool::Task> EvaluationPool::take() {
  while (queue_.empty() && !stopped()) {
    const std::optional<Proposal> proposal = source_.next();
    if (!proposal) return std::nullopt;
    launch(proposals_++, *proposal);
  }
  if (queue_.empty() || stopped()) return std::nullopt;
  Task task = queue_.front();
  queue_.pop_front();
  if (!queue_.empty()) changed_.notify_one();
  return task;
}

bool EvaluationPool::limit_reached() {
  if (limits_.max_time > 0.0) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    if (elapsed.count() >= limits_.max_time) {
      end_ = PoolEnd::time;
      return true;
    }
  }
  if (limits_.max_cpu_time > 0.0) {
    double spent = 0.0;
    for (const auto& record : context_.folder.log().records()) spent += record.cpu_time;
    if (spent >= limits_.max_cpu_time) {
      end_ = PoolEnd::cpu_time;
      return true;
    }
  }
  return false;
}

std::string EvaluationPool::id_for(std::size_t number, const Proposal& proposal) {
  for (const records::UnfinishedDesign& one : context_.folder.unfinished()) {
    if (one.design != proposal.design || one.spacing != proposal.spacing) continue;
    if (!context_.folder.log().has_id(one.id) && ids_given_.insert(one.id).second) return one.id;
  }
  int k = static_cast<int>(number) + 1;
  while (
      !context_.folder.id_is_free(records::evaluation_id(k), proposal.design, proposal.spacing) ||
      !ids_given_.insert(records::evaluation_id(k)).second) {
    ++k;
  }
  return records::evaluation_id(k);
}

void EvaluationPool::launch(std::size_t number, const Proposal& proposal) {
  for (const auto& flight : flights_) {
    if (flight->design != proposal.design || flight->spacing != proposal.spacing) continue;
    flight->numbers.push_back(number);
    return;
  }
  std::optional<records::EvaluationRecord> known;
  const auto flight = std::make_shared<Flight>();
  {
    const std::scoped_lock log(log_mutex_);
    if (const auto* record = context_.folder.log().find(proposal.design, proposal.spacing)) {
      known = *record;
      if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(*known, true);
    } else if (limit_reached()) {
      ended_ = true;
      return;
    } else {
      flight->job = std::make_unique<DesignJob>(context_, id_for(number, proposal), proposal.stage,
                                                proposal.design, proposal.spacing);
    }
  }
  if (known) {
    answer(number, *known);
    return;
  }
  flight->design = proposal.design;
  flight->spacing = proposal.spacing;
  flight->numbers = {number};
  flights_.push_back(flight);
  for (std::size_t event = 0; event < flight->job->size(); ++event) {
    queue_.emplace_back(flight, event);
  }
}

void EvaluationPool::simulate(const Task& task, std::unique_lock<std::mutex>& lock) {
  const auto& [flight, event] = task;
  ++running_;
  lock.unlock();
  std::optional<records::EvaluationRecord> record;
  try {
    const DesignJob::Outcome outcome = flight->job->simulate(event, 1);
    if (outcome == DesignJob::Outcome::cancelled) cancelled_ = true;
    if (outcome == DesignJob::Outcome::complete) {
      const std::scoped_lock log(log_mutex_);
      record = flight->job->store();
      if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(*record, false);
    }
  } catch (...) {
    lock.lock();
    --running_;
    throw;
  }
  lock.lock();
  --running_;
  if (record) {
    std::erase(flights_, flight);
    for (const std::size_t number : flight->numbers) answer(number, *record);
  }
  changed_.notify_all();
}

void EvaluationPool::answer(std::size_t number, const records::EvaluationRecord& record) {
  source_.answered(number, record);
  if (!after_answer_) return;
  const std::scoped_lock log(log_mutex_);
  after_answer_();
}

}  // namespace parapet::study
