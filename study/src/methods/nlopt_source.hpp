/// An optimiser that calls back and waits, as a source of designs.
#pragma once

#include <exception>
#include <functional>
#include <thread>

#include "blocking_evaluator.hpp"
#include "design_source.hpp"
#include "handover.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::study {

/// Runs an optimisation in a thread of its own; what it asks for is proposed, a batch at a time.
///
/// Because the log answers for designs that it holds, running an optimisation again in the same
/// folder replays it: the same questions get the same answers to the bit.
class NloptSource : public DesignSource {
 public:
  using Optimisation = std::function<optimizer::OptimizeResult(BlockingEvaluator& evaluator)>;

  /// Begins the optimisation. The context must outlive the source.
  NloptSource(const StudyContext& context, Optimisation optimisation);
  ~NloptSource() override;  ///< as finish()
  NloptSource(const NloptSource&) = delete;
  NloptSource& operator=(const NloptSource&) = delete;

  /// @throws what the optimisation threw
  std::vector<Proposal> next() override;
  bool proposes_in_rounds() const override { return true; }
  void answered(std::size_t number, const records::EvaluationRecord& record) override;

  /// Answers nothing more, so that the optimisation ends where it has not, and waits for that.
  /// @throws what the optimisation threw
  optimizer::OptimizeResult finish();

 private:
  void optimise();
  void stop();

  Optimisation optimisation_;
  Handover handover_;
  BlockingEvaluator evaluator_;
  std::size_t proposed_ = 0;          // before the batch that is out
  std::size_t batch_ = 0;             // size of that batch
  optimizer::OptimizeResult result_;  // written by the thread; read when it has ended
  std::exception_ptr failure_;        // likewise
  std::jthread thread_;
};

/// One optimisation of the weighted sum of a study's objectives, as its method says.
optimizer::OptimizeResult optimize_weighted_sum(const designs::StudySpec& study,
                                                BlockingEvaluator& evaluator);

}  // namespace parapet::study
