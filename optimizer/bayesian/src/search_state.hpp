/// The state of a search, and the steps of ask().
#pragma once

#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "candidates.hpp"
#include "gain.hpp"
#include "models.hpp"
#include "parapet/bayesian/search.hpp"
#include "told.hpp"

namespace parapet::bayesian {

/// The budget that the initial designs and the confirmations are laid out for.
inline int planned_evaluations(const SearchOptions& options) {
  return options.planned_evaluations > 0 ? options.planned_evaluations : options.max_evaluations;
}

/// Evaluations at the finest level that several levels keep for the end: the recommended design and
/// its neighbours on the front.
inline constexpr int confirmations = 3;

/// A design that is to be evaluated before the surrogates are asked.
struct Planned {
  Point x;
  int level = 0;
  std::string stage;
};

struct Search::State {
  State(Problem the_problem, SearchOptions the_options);

  /// What the questions between two answers share.
  struct Round {
    std::size_t told = 0;
    Gain gain;
    Gain::Prepared pool;
    std::set<int> seen = {};  // pending evaluations that are in the gain's draws
  };
  struct Best {
    Point x;
    int level = 0;
    double log_gain_per_cost = 0.0;
  };

  Problem problem;
  SearchOptions options;
  std::vector<Told> told;
  std::map<int, Suggestion> pending;  // by id
  std::deque<Planned> plan;
  bool planned = false;
  int next_id = 0;
  Models models;
  /// Up to date with all that was told, for those who look; looking must not change what is asked
  /// next.
  std::optional<Models> view;
  std::size_t viewed = 0;    // told then
  std::size_t modelled = 0;  // told when `models` was last updated
  bool revised = false;      // what was told has other values since
  std::unique_ptr<Round> round;
  StopReason stop = StopReason::none;
  double last_gain = std::numeric_limits<double>::infinity();  // expected of the last global one
  int local_steps = 0;                                         // asked so far
  int small_gains = 0;    // expected gains below the least, running
  double spent = 0.0;     // [s]
  double own_time = 0.0;  // [s]
  std::vector<HistoryEntry> history;
  Eigen::VectorXd history_reference;  // the history's hypervolumes are measured from here

  void check_point(const Point& x, int level, const Observation& observation) const;
  std::optional<double> composed(std::size_t metric, const Told& t) const;
  int add_told(int id, const Point& x, int level, const Observation& observation);
  void fill_in(Told& t) const;
  void revise(const std::vector<std::vector<std::optional<double>>>& values);
  void update_history();
  void update_models();
  const Models& up_to_date();

  std::optional<Suggestion> ask();
  bool out_of_budget();
  double expected_cost() const;
  bool stagnates() const;
  bool gain_is_small(double expected, const Gain& gain);
  int remaining() const;
  double cost_limit() const;
  std::vector<double> level_seconds() const;  // [n_levels], measured means where there are any

  void make_plan();
  std::optional<Suggestion> next_planned();
  bool can_model() const;
  std::optional<Suggestion> suggest_far_away();
  std::optional<Suggestion> suggest_gain();
  std::optional<Best> begin_round(const Eigen::VectorXd& reference);
  std::optional<Best> continue_round();
  std::vector<double> level_cost() const;
  std::optional<Suggestion> suggest_unknown(const Gain& gain, Candidates& candidates);
  std::optional<Suggestion> suggest_local();
  std::optional<Suggestion> suggest_confirmation();
  std::optional<Suggestion> nothing_left();
  Suggestion issue(Point x, int level, std::string stage, double log_gain);

  bool near(const Point& a, const Point& b) const;
  bool repeated(const Point& x) const;                   // told at any level, or pending
  std::vector<bool> levels_taken(const Point& x) const;  // [n_levels]
  bool confirming() const;
};

}  // namespace parapet::bayesian
