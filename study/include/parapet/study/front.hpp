/// The best trade-offs between a study's objectives, from its log.
#pragma once

#include <string>
#include <vector>

#include "parapet/bayesian/search.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/stored_front.hpp"

namespace parapet::study {

class EventModel;

/// The Pareto set of what was evaluated: designs at the finest spacing that meet every constraint
/// and that no other such design dominates (is at least as good in every objective and better in
/// one); of designs with equal objectives the first. With one objective it is the best design.
struct Front {
  std::vector<records::EvaluationRecord> designs;  ///< by id
  std::vector<double> reference;  ///< [n_objectives] in the objectives' units; empty: no design yet
  double hypervolume = 0.0;       ///< below the reference point, product of the objectives' units
  std::vector<FrontEntry> history;  ///< one entry for each record, in the log's order
};

/// The reference point is the spec's, for each objective that has one; else `reference`
/// [n_objectives] where it is not empty (a search's); else the worst value among the feasible
/// designs plus a tenth of their range.
Front make_front(const designs::StudySpec& study,
                 const std::vector<records::EvaluationRecord>& records,
                 const std::vector<double>& reference = {}, bool with_history = true);

/// The content of pareto.json, format "parapet-pareto/1". `designs` are the front; `estimated`, of
/// a search, is the front with the designs known through coarser spacings, by their estimates at
/// the finest one. With `events`, estimates of statistics over the distribution of events are those
/// of its surrogates, and their errors are stated. `search` and `problem` are null for methods
/// without surrogates: estimates are null then.
designs::Json pareto_json(const designs::StudySpec& study, const Front& front,
                          const SearchProblem* problem, const bayesian::Search* search,
                          const EventModel* events = nullptr);

/// The content of surrogates.json, format "parapet-surrogates/1": enough to predict again without
/// the solver or the search. Numbers keep every bit.
designs::Json surrogates_json(const designs::StudySpec& study, const SearchProblem& problem,
                              const bayesian::Search& search);

/// One sentence for each metric whose surrogate explains little of what was left out of it, and for
/// each limited or weighed metric of which a coarser spacing tells little about the finest one
/// (loads do so: the correlation is that of the co-kriging model, over all designs).
std::vector<std::string> surrogate_warnings(const SearchProblem& problem,
                                            const bayesian::Search& search);

}  // namespace parapet::study
