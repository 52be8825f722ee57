/// The optimizer's evaluator: a call that returns when the study has evaluated the points.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "handover.hpp"
#include "parapet/optimizer/problem.hpp"
#include "parapet/study/study_context.hpp"

namespace parapet::study {

/// From a design's record to what the optimizer wants to know.
using Scalarizer = std::function<optimizer::Evaluation(const records::EvaluationRecord& record)>;

/// The weighted sum of the objectives, and the violations of the limits on metrics.
Scalarizer weighted_sum(const designs::StudySpec& study);

/// Lives on the optimizer's thread. All designs are simulated at the finest spacing.
class BlockingEvaluator {
 public:
  /// Both must outlive the evaluator.
  BlockingEvaluator(const StudyContext& context, Handover& handover)
      : context_(context), handover_(handover) {}

  /// Answers for the points xs [n_points][n]. When the study has been stopped the answers are
  /// failed ones and stopped() is true; nothing is thrown, because optimisers in other languages
  /// stand between.
  std::vector<optimizer::Evaluation> evaluate(const std::vector<std::vector<double>>& xs,
                                              const std::string& stage,
                                              const Scalarizer& scalarizer);

  /// The optimizer's cheap constraints refused a point. Called on the optimizer's thread.
  void refused(const std::vector<double>& x);

  /// Writes the points refused so far into the log. Called on the study's thread.
  /// @throws records::FileError
  void log_refused();

  /// Whether no further question will be answered.
  bool stopped() const { return handover_.stopped() || context_.cancelled(); }

  /// Number of different designs that were asked for, whether simulated or found in the log.
  std::size_t asked() const { return asked_.size(); }

  /// Their records, in the order of the first question.
  std::vector<records::EvaluationRecord> records() const;

 private:
  optimizer::Evaluation answer(const designs::Design& design, const Scalarizer& scalarizer) const;

  const StudyContext& context_;
  Handover& handover_;
  std::mutex mutex_;                      // guards refused_
  std::vector<designs::Design> refused_;  // not in the log yet
  std::vector<designs::Design> asked_;
  std::map<designs::Design, std::optional<records::EvaluationRecord>> known_;  // of those asked
};

}  // namespace parapet::study
