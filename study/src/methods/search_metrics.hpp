/// The metrics of the search's problem, collected from the goals of a study.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/metric_catalog.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/quantity.hpp"

namespace parapet::study {

/// Adds metrics to a SearchProblem, each once. Both arguments must outlive it.
class SearchMetrics {
 public:
  /// `result` has its space already.
  SearchMetrics(const designs::StudySpec& study, SearchProblem& result);

  /// The index of a quantity's metric; see make_search_problem for what an expression becomes.
  std::size_t of(Quantity quantity);

  /// The index of the exact metric of an objective that is a formula of the design.
  std::size_t of_design(const designs::Objective& objective);

 private:
  /// An expression of metrics: the surrogates model each of these, in each event.
  std::size_t of_metrics(Quantity quantity);

  bool may_not_exist(const std::string& key) const;

  const designs::StudySpec& study_;
  SearchProblem& result_;
  std::vector<solver::MetricInfo> catalog_;
};

}  // namespace parapet::study
