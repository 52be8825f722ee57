/// Bayesian search by ask and tell.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parapet/bayesian/problem.hpp"
#include "parapet/surrogate/success_model.hpp"

namespace parapet::bayesian {

/// Picks a design of a front: objectives [n_designs][n_objectives], minimised -> its index.
using Recommend = std::function<std::size_t(const std::vector<std::vector<double>>& objectives)>;

/// How long to search, and how.
struct SearchOptions {
  int max_evaluations = 60;  ///< at any level, those told from the start included
  /// The budget that the initial designs (at most a third) and the confirmations (with several
  /// levels: three) are laid out for; 0: max_evaluations. A search that is continued with a larger
  /// budget gives the first one here and asks for the same designs.
  int planned_evaluations = 0;
  double max_seconds = 0.0;        ///< sum of what evaluations cost; 0: no limit
  double max_finest = 0.0;         ///< the same limit in mean evaluations at level 0; 0: no limit
  int initial_designs = 0;         ///< 0: chosen from the number of variables
  std::vector<Point> starts = {};  ///< asked first, at the finest level
  std::uint64_t seed = 1;
  int samples = 64;  ///< posterior draws of the front
  double feasibility_tolerance = 1e-9;
  double duplicate_distance =
      1e-3;                        ///< in the unit cube, largest coordinate: nearer is a repetition
  int stagnation_evaluations = 0;  ///< stop when so many bring no gain above the noise; 0: never
  /// Stop when the expected gain is below this share of the hypervolume, or below a tenth of the
  /// noise of an observation, three times running; 0: never.
  double least_gain = 0.0;
  /// With one objective, once the expected gain is small: steps from the best design by NLopt on
  /// surrogates of its neighbourhood take turns with the search, and more while they succeed.
  bool local_steps = true;
  /// With several levels: what will be recommended of the front, and is therefore confirmed at the
  /// finest level. Empty: the least of the largest normalised objective.
  Recommend recommend = {};
};

/// Something to evaluate.
struct Suggestion {
  int id = 0;    ///< 0, 1, 2, ...: what tell() is given
  Point x = {};  ///< canonical
  int level = 0;
  std::string stage = {};  ///< "start", "initial", "search", "local", "explore" or "confirm"
  double log_gain = 0.0;   ///< log of the expected gain (stage search)
};

/// Why a search asks for nothing more.
enum class StopReason {
  none,              ///< it is not over
  budget,            ///< max_evaluations
  seconds,           ///< max_seconds or max_finest
  stagnation,        ///< stagnation_evaluations without a gain
  small_gain,        ///< the expected gain fell below least_gain
  exhausted,         ///< no design is left that differs from those known
  no_allowed_design  ///< the cheap constraints refuse all
};

/// The name as it is spelt here: "small_gain".
std::string to_string(StopReason reason);

/// A design with what is known of it.
struct Assessed {
  int id = 0;
  Point x = {};
  int level = 0;
  bool ok = false;
  std::vector<std::optional<double>> values =
      {};                 ///< [n_metrics] observed (exact and composed ones filled in)
  bool feasible = false;  ///< as observed: ok, allowed, every limit met
  std::vector<double> estimate =
      {};  ///< [n_metrics] median of the surrogate at level 0; NaN: no model
  std::vector<double> lower = {},
                      upper = {};  ///< [n_metrics] its 95 % interval, of the noise-free value
  double probability_feasible = 0.0;
};

/// Hypervolume of the observed feasible designs of level 0 after each evaluation.
struct HistoryEntry {
  int evaluations = 0;
  double seconds = 0.0;  ///< spent until then
  double hypervolume = 0.0;
};

/// One search. Deterministic: the same problem, options and sequence of ask() and tell() calls give
/// the same suggestions, to the bit. One thread at a time may call it.
///
/// A design that was suggested and not yet told is pending: it is taken into account (its outcome
/// is averaged over), so any number of evaluations may run side by side. A failed evaluation
/// teaches the success model and nothing else.
class Search {
 public:
  /// Asks nothing yet.
  /// @throws std::invalid_argument saying what is wrong with the problem or the options.
  Search(Problem problem, SearchOptions options);
  ~Search();
  Search(Search&&) noexcept;             ///< may be moved, not copied
  Search& operator=(Search&&) noexcept;  ///< likewise

  /// The next evaluation, or nothing: the search is over (stop_reason says why), or (stop_reason
  /// none) nothing sensible can be suggested before a pending evaluation is told.
  std::optional<Suggestion> ask();

  /// The answer to a question of ask().
  /// @throws std::invalid_argument for an id that is not pending or values of a wrong number.
  void tell(int id, const Observation& observation);

  /// An evaluation made elsewhere (a log): counts like one that was asked. Returns its id.
  int tell_external(const Point& x, int level, const Observation& observation);

  /// What was told is known better now: values [n_told] of [n_metrics] in the order of telling, as
  /// in Observation; those of evaluations that failed mean nothing. The surrogates follow at the
  /// next question.
  /// @throws std::invalid_argument for a wrong number of either.
  void revise(const std::vector<std::vector<std::optional<double>>>& values);

  StopReason stop_reason() const;  ///< none while it goes on
  int evaluations() const;         ///< told so far
  double seconds() const;          ///< sum of their costs

  /// Everything told, in order, with the surrogates' view of it.
  std::vector<Assessed> assessed() const;

  /// Indices into assessed() of the Pareto set: feasible designs of level 0 that none dominates.
  std::vector<std::size_t> pareto() const;

  /// Indices into assessed() of the front as the surrogates see it: designs told at any level that
  /// meet the limits with at least even odds, by their estimates at level 0; none dominates
  /// another. Of a design told at several levels the finest.
  std::vector<std::size_t> estimated_front() const;

  /// The reference point in the objectives' units [n_objectives]; empty before it can be chosen.
  std::vector<double> reference() const;

  /// How the hypervolume grew, one entry for each evaluation told.
  const std::vector<HistoryEntry>& history() const;

  /// Surrogate of a metric; null for an exact or composed metric and before there are data.
  const surrogate::GaussianProcess* surrogate(std::size_t metric) const;
  const surrogate::SuccessModel* success_model() const;  ///< null before there are data

  const Problem& problem() const;  ///< as given
  double own_seconds() const;      ///< time spent in here

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace parapet::bayesian
