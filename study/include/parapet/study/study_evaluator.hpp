/// The optimizer's evaluator: answers from the log where it can, else simulates and logs.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "parapet/optimizer/problem.hpp"
#include "parapet/study/study_context.hpp"

namespace parapet::study {

/// From a design's record, which is in the log, to what the optimizer wants to know.
using Scalarizer = std::function<optimizer::Evaluation(const records::EvaluationRecord& record)>;

/// The weighted sum of the objectives, and the violations of the limits on metrics.
Scalarizer weighted_sum(const designs::StudySpec& study);

/// Because the log answers for designs that it holds, running an optimisation again in the same
/// folder replays it: the same questions get the same answers to the bit.
///
/// Ids follow the order of the questions, so that they do not depend on which of several
/// simulations side by side ends first. All designs are simulated at the finest spacing.
class StudyEvaluator {
 public:
  /// The context must outlive the evaluator.
  /// @param jobs as many simulations side by side; fewer than that take several threads each
  StudyEvaluator(const StudyContext& context, int jobs);

  /// Answers for the points xs [n_points][n]. After a cancellation or a failure of the file system
  /// the answers are failed ones and stopped() is true; nothing is thrown, because optimisers in
  /// other languages stand between.
  std::vector<optimizer::Evaluation> evaluate(const std::vector<std::vector<double>>& xs,
                                              const std::string& stage,
                                              const Scalarizer& scalarizer);

  /// Whether no further question will be answered.
  bool stopped() const;

  /// Whether a design was refused because method.max_cpu_time_s is used up; stopped() is true then.
  bool out_of_cpu_time() const { return out_of_cpu_time_; }

  /// Throws what stopped the evaluator, if that was a failure.
  void throw_if_failed() const;

  /// Different designs that were asked for, whether simulated or found in the log, in the order of
  /// the first question.
  const std::vector<designs::Design>& asked() const { return asked_; }

 private:
  std::unique_ptr<DesignJob> pose(const designs::Design& design, const std::string& stage);
  void simulate(const std::vector<std::unique_ptr<DesignJob>>& jobs);
  bool cpu_time_left();
  optimizer::Evaluation answer(const designs::Design& design, const Scalarizer& scalarizer) const;

  const StudyContext& context_;
  int jobs_;
  std::mutex mutex_;  // guards the folder while workers run
  std::set<int> ids_given_;
  int questions_ = 0;
  std::vector<designs::Design> asked_;
  std::set<designs::Design> asked_set_;
  std::atomic<bool> cancelled_ = false;
  bool out_of_cpu_time_ = false;
  std::exception_ptr failure_;
};

}  // namespace parapet::study
