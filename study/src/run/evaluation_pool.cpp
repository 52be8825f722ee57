#include "evaluation_pool.hpp"

#include <algorithm>
#include <optional>

#include "parapet/study/side_by_side.hpp"
#include "parapet/study/thread_count.hpp"

namespace parapet::study {

EvaluationPool::EvaluationPool(const StudyContext& context, DesignSource& source,
                               const PoolLimits& limits, std::function<void()> after_answer)
    : context_(context), source_(source), limits_(limits), after_answer_(std::move(after_answer)) {}

PoolEnd EvaluationPool::run() {
  for (bool more = true; more;) {
    try {
      more = step();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
  }
  if (failure_) std::rethrow_exception(failure_);
  return cancelled_ || context_.cancelled() ? PoolEnd::cancelled : end_;
}

bool EvaluationPool::stopped() const {
  return ended_ || failure_ || cancelled_ || context_.cancelled();
}

bool EvaluationPool::place_free() const {
  return under_way_.size() < static_cast<std::size_t>(context_.service.places());
}

/// False when nothing is under way and nothing more will be.
bool EvaluationPool::step() {
  // What has ended goes to disk before a source is asked that may take its time; what waits in the
  // queue, or comes at once, takes its place first.
  if (std::vector<Event> ended = fetch_ended(); !ended.empty()) {
    begin_at_once();
    store(std::move(ended));
    return true;
  }
  if (place_free() && begin_next()) {
    store({});
    return true;
  }
  if (under_way_.empty()) return false;
  const Event ended = settle(context_.service.wait());
  begin_at_once();
  store({ended});
  return true;
}

/// What needs no thought. A limit of processor time counts what is in the log, so that comes first.
void EvaluationPool::begin_at_once() {
  const bool asks = source_.is_quick() && limits_.max_cpu_time <= 0.0;
  try {
    while (place_free() && (!queue_.empty() || asks) && begin_next()) {
    }
  } catch (...) {  // what has ended is to be stored all the same
    if (!failure_) failure_ = std::current_exception();
  }
}

/// False when there is nothing to begin at the moment, or ever.
bool EvaluationPool::begin_next() {
  while (queue_.empty() && !stopped()) {
    const std::vector<Proposal> proposals = source_.next();
    if (proposals.empty()) return false;
    launch(proposals);
  }
  if (queue_.empty() || stopped()) return false;
  const Event next = queue_.front();
  queue_.pop_front();
  const auto& [flight, event] = next;
  if (auto task = flight->job->begin(event, flight->threads)) {
    under_way_.emplace(context_.service.submit(*std::move(task)), next);
  } else {
    ended_at_once_.push_back(next);
  }
  return true;
}

bool EvaluationPool::limit_reached() {
  if (limits_.max_designs > 0 &&
      context_.folder.log().records().size() + flights_.size() >= limits_.max_designs) {
    end_ = PoolEnd::designs;
    return true;
  }
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

void EvaluationPool::launch(const std::vector<Proposal>& proposals) {
  std::vector<std::shared_ptr<Flight>> begun;
  std::size_t simulations = 0;
  for (const Proposal& proposal : proposals) {
    if (auto flight = flight_for(proposals_++, proposal)) {
      simulations += flight->job->size();
      begun.push_back(std::move(flight));
    }
    if (ended_) break;
  }
  for (const auto& flight : begun) {
    if (source_.proposes_in_rounds()) {
      flight->threads = threads_each(simulations, context_.service.places());
    }
    for (std::size_t event = 0; event < flight->job->size(); ++event) {
      queue_.emplace_back(flight, event);
    }
  }
}

/// A new flight; empty where the log or a flight under way answers, or a limit is reached.
std::shared_ptr<EvaluationPool::Flight> EvaluationPool::flight_for(std::size_t number,
                                                                   const Proposal& proposal) {
  for (const auto& flight : flights_) {
    if (flight->design != proposal.design || flight->spacing != proposal.spacing) continue;
    flight->numbers.push_back(number);
    return nullptr;
  }
  if (const auto* known = context_.folder.log().find(proposal.design, proposal.spacing)) {
    const records::EvaluationRecord record = *known;
    if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(record, true);
    answer(number, record);
    return nullptr;
  }
  if (limit_reached()) {
    ended_ = true;
    return nullptr;
  }
  auto flight = std::make_shared<Flight>();
  flight->job = std::make_unique<DesignJob>(context_, id_for(number, proposal), proposal.stage,
                                            proposal.design, proposal.spacing);
  flight->design = proposal.design;
  flight->spacing = proposal.spacing;
  flight->numbers = {number};
  flights_.push_back(flight);
  return flight;
}

/// Simulations that have ended by now; not those after one that went wrong.
std::vector<EvaluationPool::Event> EvaluationPool::fetch_ended() {
  constexpr std::size_t most = 64;  // so that the source is asked between
  std::vector<Event> ended;
  while (!under_way_.empty() && ended.size() < most) {
    auto one = context_.service.poll();
    if (!one) break;
    try {
      ended.push_back(settle(*std::move(one)));
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      break;
    }
  }
  return ended;
}

EvaluationPool::Event EvaluationPool::settle(EndedSimulation ended) {
  const auto found = under_way_.find(ended.ticket);
  const Event event = found->second;
  under_way_.erase(found);
  if (ended.failure) std::rethrow_exception(ended.failure);
  if (ended.simulation.cancelled) cancelled_ = true;
  event.first->job->end(event.second, std::move(ended.simulation));
  return event;
}

/// Runs all, the files of several side by side: a disk takes many as fast as one.
/// @return [n] what went wrong
std::vector<std::exception_ptr> EvaluationPool::write(
    const std::vector<std::function<void()>>& writes) {
  constexpr int most_writers = 16;
  std::vector<std::exception_ptr> failures(writes.size());
  run_side_by_side(writes.size(), most_writers, [&](std::size_t k, int /*threads*/) {
    try {
      writes[k]();
    } catch (...) {
      failures[k] = std::current_exception();
    }
  });
  return failures;
}

/// These, and what ended without a simulation.
void EvaluationPool::store(std::vector<Event> ended) {
  ended.insert(ended.end(), ended_at_once_.begin(), ended_at_once_.end());
  ended_at_once_.clear();
  std::vector<std::function<void()>> writes;
  for (const auto& [flight, event] : ended) {
    writes.emplace_back([job = flight->job.get(), k = event] { job->write_event(k); });
  }
  const std::vector<std::exception_ptr> failures = write(writes);
  for (std::size_t k = 0; k < ended.size(); ++k) {
    if (!failures[k]) continue;
    ended[k].first->job->lose(ended[k].second);
    if (!failure_) failure_ = failures[k];
  }
  std::vector<std::shared_ptr<Flight>> complete_ones;
  for (const auto& [flight, event] : ended) {
    const bool known =
        std::find(complete_ones.begin(), complete_ones.end(), flight) != complete_ones.end();
    if (!known && flight->job->complete()) complete_ones.push_back(flight);
  }
  complete(complete_ones);
}

/// Stores and answers designs whose events have all ended; of a repeatable study those that are at
/// the head of the order, while the others wait on disk.
void EvaluationPool::complete(const std::vector<std::shared_ptr<Flight>>& complete_ones) {
  std::vector<std::shared_ptr<Flight>> ready;
  if (context_.study.method.repeatable) {
    for (const auto& flight : flights_) {
      if (!flight->job->complete()) break;
      ready.push_back(flight);
    }
  } else {
    for (const auto& flight : complete_ones) {
      if (flight->job->complete()) ready.push_back(flight);
    }
  }
  std::vector<std::function<void()>> writes;
  for (const auto& flight : ready) {
    writes.emplace_back([job = flight->job.get()] { job->write_report(); });
  }
  for (const auto& flight : complete_ones) {
    const bool waits =
        flight->job->complete() && std::find(ready.begin(), ready.end(), flight) == ready.end();
    if (waits) writes.emplace_back([job = flight->job.get()] { job->wait_on_disk(); });
  }
  const std::vector<std::exception_ptr> failures = write(writes);
  std::vector<std::shared_ptr<Flight>> written;
  for (std::size_t k = 0; k < ready.size(); ++k) {
    std::erase(flights_, ready[k]);
    if (!failures[k]) written.push_back(ready[k]);
  }
  log(written);
  for (const auto& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// Records of designs whose reports are written, by one sync; then their answers.
void EvaluationPool::log(const std::vector<std::shared_ptr<Flight>>& flights) {
  std::vector<records::EvaluationRecord> records;
  for (const auto& flight : flights) records.push_back(flight->job->record());
  context_.folder.store(records);
  for (std::size_t k = 0; k < flights.size(); ++k) {
    flights[k]->job->logged();
    if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(records[k], false);
    for (const std::size_t number : flights[k]->numbers) answer(number, records[k]);
  }
}

void EvaluationPool::answer(std::size_t number, const records::EvaluationRecord& record) {
  source_.answered(number, record);
  if (after_answer_) after_answer_();
}

}  // namespace parapet::study
