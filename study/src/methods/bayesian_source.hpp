/// The Bayesian search as a source of designs.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "design_source.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/event_model.hpp"
#include "parapet/study/study_context.hpp"

namespace parapet::study {

/// How the search learns of answers.
enum class AnswerOrder {
  /// As they come. What the log holds at the beginning is told first, then incomplete designs are
  /// completed, then the search is asked.
  as_they_come,
  /// In the order of the questions: question k is put when exactly the answers to the questions
  /// 0 .. k - lag are known, in whole blocks of answers_at_once(lag). The same questions follow,
  /// however fast each simulation is, and an
  /// interrupted study is resumed by putting them again. Records of other origin are told before
  /// the first question whose answer stands after them in the log, which must have the order of the
  /// questions.
  by_question
};

/// Puts the search's questions and tells it the answers.
class BayesianSource : public DesignSource {
 public:
  /// All must outlive the source.
  /// @param lag questions that may be open at once, but for blocks, >= 1; see AnswerOrder
  BayesianSource(const StudyContext& context, const SearchProblem& problem,
                 bayesian::Search& search, AnswerOrder order, std::size_t lag);

  std::vector<Proposal> next() override;
  void answered(std::size_t number, const records::EvaluationRecord& record) override;

  /// Tells what is known and was not told yet, in order.
  void finish();

 private:
  void keep(const records::EvaluationRecord& record);
  void revise();
  void tell_record(const records::EvaluationRecord& record);
  void tell_log();
  void tell_log_before(const Proposal& proposal);
  bool told_enough();
  bool tell_next();
  bool within_budget() const;
  std::optional<Proposal> ask();
  std::optional<Proposal> propose();
  std::optional<Proposal> propose_as_they_come();

  const StudyContext& context_;
  const SearchProblem& problem_;
  bayesian::Search& search_;
  AnswerOrder order_;
  std::size_t lag_;
  std::vector<bool> log_told_;                         // records that the log held at the beginning
  std::vector<records::UnfinishedDesign> unfinished_;  // still to be proposed, last first
  // incomplete designs under way that the search has not asked for: number by design and spacing
  std::map<std::pair<designs::Design, double>, std::size_t> resumed_;
  std::vector<std::optional<int>> questions_;  // the search's id by number; empty: not its question
  std::map<std::size_t, records::EvaluationRecord> answers_;  // not told yet, by number
  std::vector<records::EvaluationRecord> known_;  // what the search was told, in order; only of a
                                                  // study with a distribution of events
  std::size_t revised_ = 0;                       // of these when statistics were last revised
  std::size_t open_ = 0;                          // proposals without an answer
  std::size_t told_ = 0;                          // answers told in order
  std::size_t needed_ = 0;  // answers that must be told before the next question
};

/// Questions that may be open at once when `jobs` workers share the simulations of designs with so
/// many events each: enough to keep every worker busy, and with several jobs one more, so that they
/// wait less for the slowest.
std::size_t open_questions(int jobs, std::size_t events);

/// Answers that are told together where many questions are open: the surrogates then change once
/// for as many questions. Of so many open ones a block is a sixteenth, so the search hardly knows
/// less. 1 up to 31 open questions.
std::size_t answers_at_once(std::size_t lag);

}  // namespace parapet::study
