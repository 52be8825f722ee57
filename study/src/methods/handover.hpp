/// Questions from a thread that waits for its answers to a loop that asks for designs.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <vector>

#include "design_source.hpp"

namespace parapet::study {

/// An asker's thread puts one batch of questions at a time and sleeps until all are answered. At
/// any time at most one of the two threads works; the other waits for it.
class Handover {
 public:
  /// Answers in the order of the questions; empty where the loop stopped before.
  using Answers = std::vector<std::optional<records::EvaluationRecord>>;

  /// The asker: hands a batch over and waits for the answers.
  Answers ask(std::vector<Proposal> batch);

  /// The asker: nothing more will be asked.
  /// @param failure why, if that was an exception
  void end(std::exception_ptr failure = nullptr);

  /// Whether no question is answered any more.
  bool stopped() const { return stopped_; }

  /// The loop: waits for the next batch. Empty while answers are due, and when the asker has ended.
  /// @throws the asker's exception
  std::vector<Proposal> take();

  /// The loop: the answer to question `place` of the batch that was taken last.
  void answer(std::size_t place, const records::EvaluationRecord& record);

  /// The loop: nothing more will be answered. A waiting asker gets the answers that there are.
  void stop();

 private:
  std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::vector<Proposal> batch_;  // not taken yet
  Answers answers_;
  std::size_t due_ = 0;  // questions taken or to be taken that have no answer
  bool taken_ = false;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace parapet::study
