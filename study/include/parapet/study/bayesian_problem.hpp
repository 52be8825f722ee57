/// A study as the Bayesian search sees it.
#pragma once

#include <string>
#include <vector>

#include "parapet/bayesian/problem.hpp"
#include "parapet/bayesian/search.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/bayesian_space.hpp"
#include "parapet/study/quantity.hpp"

namespace parapet::study {

/// One of the search's metrics and what it is in the study.
struct SearchMetric {
  Quantity quantity;       ///< of a metric, or of an expression that is composed of others here
  std::string expression;  ///< of a formula of the design; `quantity` means nothing then
};

/// The search's problem with what is needed to answer it.
struct SearchProblem {
  bayesian::Problem problem;
  std::vector<SearchMetric> metrics;  ///< [n_metrics], in the problem's order
  std::vector<double> spacings;       ///< [n_levels] particle spacing, finest first [m]
};

/// Space, metrics, limits, levels and cheap constraints. Quantities that two goals share are one
/// metric; a constraint with two limits and a one-sided statistic (worst, quantile) gives two. The
/// formulas of the design among the constraints are cheap constraints; those among the objectives
/// are exact metrics, and a design at which one is not finite is refused. An expression of metrics
/// is composed: each of its metrics is one of the search's, in each event its own, and the
/// expression, with its statistic over the events, is evaluated on what their surrogates say. Where
/// the events are drawn from distributions its statistic is told instead, and so are those of
/// metrics: see revise_statistics.
/// `study` must outlive the problem.
///
/// Levels: cost from the spec, else expected_seconds; times the number of events. Known noise: of
/// a mean over events with weights w the spec's times sqrt(sum w^2), of a worst value or a quantile
/// the spec's; of a probability it is left to be estimated.
SearchProblem make_search_problem(const designs::StudySpec& study);

/// The spec's method in the search's terms: start_count is the number of initial designs.
bayesian::SearchOptions make_search_options(const designs::StudySpec& study);

/// What the search is told of a record. `seconds` is the spec's cost of the level, else the nominal
/// one of the particle steps: measured times would make the search depend on the clock.
bayesian::Observation observation(const designs::StudySpec& study, const SearchProblem& problem,
                                  const records::EvaluationRecord& record);

/// The level of a particle spacing; empty when the study has none of it.
std::optional<int> level_of(const SearchProblem& problem, double spacing);

}  // namespace parapet::study
