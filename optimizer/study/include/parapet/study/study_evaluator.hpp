/// The optimizer's evaluator: answers from the log where it can, else simulates and logs.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "parapet/optimizer/problem.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/study_folder.hpp"

namespace parapet::study {

/// Because the log answers for designs that it holds, running an optimisation again in the same
/// folder replays it: the same questions get the same answers to the bit.
///
/// Ids follow the order of the questions, so that they do not depend on which of several
/// simulations side by side ends first.
class StudyEvaluator {
 public:
  /// All must outlive the evaluator.
  /// @param jobs a batch runs this many simulations side by side; a single one, so many threads
  StudyEvaluator(const designs::StudySpec& study, StudyFolder& folder,
                 const reports::ProgramInfo& program, int jobs, const Hooks& hooks);

  /// Answers for the points xs [n_points][n]. After a cancellation or a failure of the file system
  /// the answers are failed ones and stopped() is true; nothing is thrown, because optimisers in
  /// other languages stand between.
  std::vector<optimizer::Evaluation> evaluate(const std::vector<std::vector<double>>& xs,
                                              const std::string& stage);

  /// Whether no further question will be answered.
  bool stopped() const;

  /// Throws what stopped the evaluator, if that was a failure.
  void throw_if_failed() const;

  int answered_from_log() const { return answered_from_log_; }

 private:
  struct Question {
    std::string id;
    designs::Design design;
  };
  Question pose(const std::vector<double>& x);
  void simulate(const Question& question, const std::string& stage, int threads);
  optimizer::Evaluation answer(const designs::Design& design) const;

  const designs::StudySpec& study_;
  StudyFolder& folder_;
  const reports::ProgramInfo& program_;
  int jobs_;
  const Hooks& hooks_;
  std::mutex mutex_;  // guards folder_ while workers run
  std::set<int> ids_given_;
  int questions_ = 0;
  int answered_from_log_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::exception_ptr failure_;
};

}  // namespace parapet::study
