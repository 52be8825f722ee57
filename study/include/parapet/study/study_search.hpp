/// A study's Bayesian search by ask and tell, for callers with a loop of their own.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parapet/bayesian/search.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/front.hpp"

namespace parapet::study {

/// A design that the search wants evaluated.
struct AskedDesign {
  int id = 0;         ///< what tell() is given
  std::string stage;  ///< "start", "initial", "search", "explore" or "confirm"
  designs::Design design;
  double spacing = 0.0;  ///< particle spacing [m]
};

/// The search of `parapet optimize` without its folder and its loop. With one design asked and told
/// at a time, and every event simulated by the study's rules, it asks for the same designs as the
/// program with one job. One thread at a time may call it.
class StudySearch {
 public:
  /// @throws designs::InputError for a method other than BAYESIAN and for what the search cannot do
  explicit StudySearch(designs::StudySpec study);

  /// The next design; none when the search is over (stop_reason) or needs an answer first.
  std::optional<AskedDesign> ask();

  /// The answer to ask(): the record gets an id of its own.
  /// @throws std::invalid_argument for an id that is not pending
  void tell(int id, records::EvaluationRecord record);

  /// A design that was evaluated elsewhere.
  /// @throws std::invalid_argument for a particle spacing that the study does not have, and for a
  ///         design that it does not allow
  void tell_other(records::EvaluationRecord record);

  /// Why nothing more is asked; empty: it goes on.
  std::string stop_reason() const;

  /// What was told, in order.
  const std::vector<records::EvaluationRecord>& records() const { return records_; }

  /// The best trade-offs of what was told.
  Front front() const;

  /// The same with the surrogates' estimates, format "parapet-pareto/1".
  designs::Json front_json() const;

  /// The study.
  const designs::StudySpec& study() const { return *study_; }

 private:
  void keep(int id, records::EvaluationRecord record);

  std::unique_ptr<const designs::StudySpec> study_;  // the problem refers to it
  SearchProblem problem_;
  bayesian::Search search_;
  std::map<int, AskedDesign> asked_;  // not told yet
  std::vector<records::EvaluationRecord> records_;
  std::size_t revised_ = 0;  // of these when statistics over a distribution were last revised
};

}  // namespace parapet::study
