/// Keeps summary.json, pareto.json and surrogates.json in step with the log.
#pragma once

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "parapet/study/front.hpp"
#include "parapet/study/study_context.hpp"
#include "parapet/study/study_run.hpp"

namespace parapet::study {

/// One thread at a time may call it, with the log at rest.
class OutputWriter {
 public:
  /// Study, folder and hooks must outlive the writer.
  OutputWriter(const designs::StudySpec& study, const records::StudyFolder& folder,
               const Hooks& hooks);

  /// From now on the outputs show what this search knows. Both must outlive the writer's use.
  void attach(const SearchProblem& problem, const bayesian::Search& search);

  /// The search is gone.
  void detach();

  /// A record was added to the log: summary.json, at most four times a second, and without a search
  /// every tenth time the rest.
  void record_added();

  /// The search was told of an answer: every tenth record pareto.json and surrogates.json.
  void search_told();

  /// Everything, at the end. Completes the summary from the log.
  StudySummary end(StudySummary summary);

 private:
  StudySummary complete(StudySummary summary, const Front& front) const;
  void write_outputs(const Front& front, const EventModel* events = nullptr);
  bool due() const;
  Front front(bool with_history) const;

  const designs::StudySpec& study_;
  const records::StudyFolder& folder_;
  const Hooks& hooks_;
  const SearchProblem* problem_ = nullptr;
  const bayesian::Search* search_ = nullptr;
  std::vector<double> reference_;  // the search's, as it was told last
  std::set<std::string> warned_;   // sentences said already, without their numbers
  std::size_t at_begin_;
  std::size_t written_at_ = 0;  // records when the outputs were written last
  std::chrono::steady_clock::time_point summary_at_{};  // when the summary was
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace parapet::study
