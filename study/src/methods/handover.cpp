#include "handover.hpp"

#include <utility>

namespace parapet::study {

Handover::Answers Handover::ask(std::vector<Proposal> batch) {
  std::unique_lock lock(mutex_);
  answers_.assign(batch.size(), std::nullopt);
  if (batch.empty() || stopped_) return std::move(answers_);
  due_ = batch.size();
  batch_ = std::move(batch);
  taken_ = false;
  changed_.notify_all();
  changed_.wait(lock, [this] { return due_ == 0 || stopped_; });
  return std::move(answers_);
}

void Handover::end(std::exception_ptr failure) {
  const std::scoped_lock lock(mutex_);
  ended_ = true;
  failure_ = std::move(failure);
  changed_.notify_all();
}

std::vector<Proposal> Handover::take() {
  std::unique_lock lock(mutex_);
  if (taken_ && due_ > 0) return {};
  changed_.wait(lock, [this] { return ended_ || !batch_.empty(); });
  if (failure_) std::rethrow_exception(failure_);
  if (batch_.empty()) return {};
  taken_ = true;
  return std::exchange(batch_, {});
}

void Handover::answer(std::size_t place, const records::EvaluationRecord& record) {
  const std::scoped_lock lock(mutex_);
  if (stopped_) return;
  answers_.at(place) = record;
  if (--due_ == 0) changed_.notify_all();
}

void Handover::stop() {
  const std::scoped_lock lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

}  // namespace parapet::study
