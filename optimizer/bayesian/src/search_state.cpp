#include "search_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "composed.hpp"
#include "parapet/math/pareto.hpp"
#include "reference_point.hpp"

namespace parapet::bayesian {
namespace {

constexpr double not_computed = -1.0;

}  // namespace

Search::State::State(Problem the_problem, SearchOptions the_options)
    : problem(std::move(the_problem)),
      options(std::move(the_options)),
      models(problem, options.seed) {}

void Search::State::check_point(const Point& x, int level, const Observation& observation) const {
  if (x.size() != problem.space.size()) throw std::invalid_argument("a point of a wrong length");
  if (level < 0 || level >= static_cast<int>(problem.levels.size())) {
    throw std::invalid_argument("no such level: " + std::to_string(level));
  }
  if (observation.ok && observation.values.size() != problem.metrics.size()) {
    throw std::invalid_argument("an observation of " + std::to_string(observation.values.size()) +
                                " values; wanted " + std::to_string(problem.metrics.size()));
  }
}

/// The composed metric of what was observed.
std::optional<double> Search::State::composed(std::size_t metric, const Told& t) const {
  std::vector<double> inputs;
  for (const std::size_t input : problem.metrics[metric].composition.inputs) {
    if (!t.ok || !t.values[input]) return std::nullopt;
    inputs.push_back(*t.values[input]);
  }
  const double value = problem.metrics[metric].composition.value(t.x, inputs);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Exact and composed metrics; what is not finite is no value.
void Search::State::fill_in(Told& t) const {
  t.values.resize(problem.metrics.size());
  for (std::size_t metric = 0; metric < t.values.size(); ++metric) {
    const auto& exact = problem.metrics[metric].exact;
    if (exact) t.values[metric] = exact(t.x);
    if (t.values[metric] && !std::isfinite(*t.values[metric])) t.values[metric].reset();
  }
  for (std::size_t metric = 0; metric < t.values.size(); ++metric) {
    if (problem.metrics[metric].is_composed()) t.values[metric] = composed(metric, t);
  }
}

void Search::State::revise(const std::vector<std::vector<std::optional<double>>>& values) {
  const bool fits = values.size() == told.size() &&
                    std::all_of(values.begin(), values.end(), [&](const auto& one) {
                      return one.size() == problem.metrics.size();
                    });
  if (!fits) throw std::invalid_argument("a revision needs the values of all that was told");
  for (std::size_t k = 0; k < told.size(); ++k) {
    if (!told[k].ok) continue;
    told[k].values = values[k];
    fill_in(told[k]);
  }
  revised = true;
  view.reset();
  round.reset();
  history_reference.resize(0);  // all of the history is another
  if (!told.empty()) update_history();
}

int Search::State::add_told(int id, const Point& x, int level, const Observation& observation) {
  Told t{.id = id,
         .x = x,
         .level = level,
         .ok = observation.ok,
         .values = observation.values,
         .seconds = observation.seconds};
  fill_in(t);
  spent += observation.seconds;
  told.push_back(std::move(t));
  update_history();
  return id;
}

void Search::State::update_history() {
  const auto reference = reference_point(problem, told, options.feasibility_tolerance);
  if (!reference) {
    history.push_back({static_cast<int>(told.size()), spent, 0.0});
    return;
  }
  const bool moved = history_reference.size() == 0 || *reference != history_reference;
  history_reference = *reference;
  std::size_t first = moved ? 0 : history.size();
  std::vector<math::Objectives> front;
  double seconds = 0.0, volume = not_computed;
  for (std::size_t k = 0; k < told.size(); ++k) {
    seconds += told[k].seconds;
    const bool counts = told[k].ok && told[k].level == 0 &&
                        meets_limits(problem, told[k].values, options.feasibility_tolerance);
    const auto y = counts ? minimized(problem, told[k].values) : std::nullopt;
    if (y && math::enter_front(front, *y)) volume = not_computed;
    if (k < first) continue;
    if (volume < 0.0) volume = math::hypervolume(front, history_reference);
    const HistoryEntry entry{static_cast<int>(k) + 1, seconds, volume};
    if (k < history.size()) {
      history[k] = entry;
    } else {
      history.push_back(entry);
    }
  }
}

void Search::State::update_models() {
  models.update(told, revised);
  modelled = told.size();
  revised = false;
}

const Models& Search::State::up_to_date() {
  if (modelled == told.size() && !revised) return models;
  if (!view || viewed != told.size()) {
    view.emplace(models);
    view->update(told, revised);
    viewed = told.size();
  }
  return *view;
}

int Search::State::remaining() const {
  return options.max_evaluations - static_cast<int>(told.size() + pending.size());
}

std::vector<double> Search::State::level_seconds() const {
  std::vector<double> sum(problem.levels.size(), 0.0), count(problem.levels.size(), 0.0);
  for (const Told& t : told) {
    sum[static_cast<std::size_t>(t.level)] += t.seconds;
    count[static_cast<std::size_t>(t.level)] += 1.0;
  }
  std::vector<double> seconds;
  for (std::size_t l = 0; l < sum.size(); ++l) {
    const bool measured = count[l] > 0.0 && sum[l] > 0.0;
    seconds.push_back(measured ? sum[l] / count[l] : problem.levels[l].seconds);
  }
  return seconds;
}

/// Of what was told and is pending.
double Search::State::expected_cost() const {
  const std::vector<double> seconds = level_seconds();
  double expected = spent;
  for (const auto& [id, s] : pending) expected += seconds[static_cast<std::size_t>(s.level)];
  return expected;
}

bool Search::State::out_of_budget() {
  if (remaining() <= 0) stop = StopReason::budget;
  if (const double limit = cost_limit(); std::isfinite(limit)) {
    constexpr double rounding = 1e-9;  // of a sum of equal costs
    if (expected_cost() >= limit * (1.0 - rounding)) stop = StopReason::seconds;
  }
  return stop != StopReason::none;
}

/// What evaluations may cost together; infinite without a limit.
double Search::State::cost_limit() const {
  double limit = std::numeric_limits<double>::infinity();
  if (options.max_seconds > 0.0) limit = options.max_seconds;
  if (options.max_finest > 0.0) {
    limit = std::min(limit, options.max_finest * level_seconds().front());
  }
  return limit;
}

bool Search::State::stagnates() const {
  constexpr double share_that_counts = 1e-3;
  const auto k = static_cast<std::size_t>(std::max(0, options.stagnation_evaluations));
  if (k == 0 || history.size() <= k) return false;
  const double now = history.back().hypervolume;
  return now > 0.0 && now - history[history.size() - 1 - k].hypervolume <= share_that_counts * now;
}

Suggestion Search::State::issue(Point x, int level, std::string stage, double log_gain) {
  Suggestion suggestion{.id = next_id++,
                        .x = std::move(x),
                        .level = level,
                        .stage = std::move(stage),
                        .log_gain = log_gain};
  pending.emplace(suggestion.id, suggestion);
  return suggestion;
}

bool Search::State::near(const Point& a, const Point& b) const {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return false;
    const Variable& v = problem.space.variables()[i];
    const bool whole = v.kind != VariableKind::continuous;
    const double within = whole ? 0.0 : options.duplicate_distance * (v.upper - v.lower);
    if (std::abs(a[i] - b[i]) > within) return false;
  }
  return true;
}

bool Search::State::repeated(const Point& x) const {
  const auto here = [&](const auto& other) { return near(x, other.x); };
  return std::any_of(told.begin(), told.end(), [&](const Told& t) { return here(t); }) ||
         std::any_of(pending.begin(), pending.end(), [&](const auto& p) { return here(p.second); });
}

std::vector<bool> Search::State::levels_taken(const Point& x) const {
  std::vector<bool> taken(problem.levels.size(), false);
  for (const Told& t : told) {
    if (near(x, t.x)) taken[static_cast<std::size_t>(t.level)] = true;
  }
  for (const auto& [id, s] : pending) {
    if (near(x, s.x)) taken[static_cast<std::size_t>(s.level)] = true;
  }
  return taken;
}

/// The end of the budget is kept for the finest level: what coarse levels promise of the
/// recommended design and its neighbours is confirmed.
bool Search::State::confirming() const {
  if (problem.levels.size() == 1) return false;
  const int first_budget = planned_evaluations(options);
  const int used = static_cast<int>(told.size() + pending.size());
  if (remaining() <= confirmations) return true;
  if (first_budget - confirmations <= used && used < first_budget) return true;
  return cost_limit() - expected_cost() < (confirmations + 0.5) * level_seconds().front();
}

bool Search::State::can_model() const {
  return std::all_of(problem.objectives.begin(), problem.objectives.end(),
                     [&](const auto& o) { return can_predict(problem, models, o.metric); });
}

std::optional<Suggestion> Search::State::nothing_left() {
  if (pending.empty()) stop = StopReason::exhausted;
  return std::nullopt;
}

std::optional<Suggestion> Search::State::ask() {
  if (stop != StopReason::none || out_of_budget()) return std::nullopt;
  if (!planned) make_plan();
  if (auto suggestion = next_planned()) return suggestion;
  if (stop != StopReason::none) return std::nullopt;
  if (stagnates()) {
    stop = StopReason::stagnation;
    return std::nullopt;
  }
  update_models();
  if (!can_model()) return suggest_far_away();
  if (confirming()) {
    // What is left does not pay for an evaluation at the finest level, and there is no use in
    // others.
    if (cost_limit() - expected_cost() < level_seconds().front()) {
      if (pending.empty()) stop = StopReason::seconds;
      return std::nullopt;
    }
    if (auto suggestion = suggest_confirmation()) return suggestion;
  }
  if (auto suggestion = suggest_local()) return suggestion;
  return suggest_gain();
}

}  // namespace parapet::bayesian
