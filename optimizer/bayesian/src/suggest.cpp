/// What ask() suggests once there are surrogates.
#include <algorithm>
#include <cmath>
#include <utility>

#include "confirmation.hpp"
#include "level_choice.hpp"
#include "local_step.hpp"
#include "maximize_gain.hpp"
#include "reference_point.hpp"
#include "search_state.hpp"

namespace parapet::bayesian {
namespace {

/// When the surrogates expect less than this share of the hypervolume, every other evaluation tests
/// the surrogates themselves: few data may make them sure of too much.
constexpr double share_that_doubts = 1e-4;

/// Standard deviations of the objective: below, the last digits are what is left to gain.
constexpr double gain_for_local_steps = 3e-3;

/// Up to so many designs the candidates are as many as can be; then fewer, down to a share.
constexpr std::size_t usual_designs = 150;
constexpr double least_effort = 0.3;

}  // namespace

/// Of one objective at one level, once the global search promises little or has not found a better
/// design for long.
std::optional<Suggestion> Search::State::suggest_local() {
  if (!options.local_steps || problem.objectives.size() > 1 || problem.levels.size() > 1) {
    return std::nullopt;
  }
  const int long_idle = 6 + 2 * static_cast<int>(problem.space.size());
  if (last_gain > gain_for_local_steps &&
      idle_evaluations(problem, told, options.feasibility_tolerance) < long_idle) {
    return std::nullopt;
  }
  const bool asked_already = std::any_of(pending.begin(), pending.end(),
                                         [](const auto& p) { return p.second.stage == "local"; });
  if (asked_already || !local_turn(problem, told, options.feasibility_tolerance)) {
    return std::nullopt;
  }
  const auto region = trust_region(problem, told, options.feasibility_tolerance);
  if (!region) return std::nullopt;
  auto x = local_step(problem, told, *region, options.feasibility_tolerance,
                      options.seed * 1000003ULL + static_cast<std::uint64_t>(next_id));
  if (!x) return std::nullopt;
  const auto asked = [&](const auto& p) { return same_design(p.second.x, *x); };
  if (std::any_of(pending.begin(), pending.end(), asked)) return std::nullopt;
  ++local_steps;
  return issue(*std::move(x), 0, "local", 0.0);
}

/// Once may be a surrogate's mistake that the next answer mends; three times running counts.
bool Search::State::gain_is_small(double expected, const Gain& gain) {
  constexpr int times_that_count = 3;
  if (options.least_gain <= 0.0 || !gain.any_feasible()) return false;
  // The surrogate sees through noise to about a tenth of it; below that nothing can be learnt.
  const double unseen = 0.1 * gain.noise_volume();
  const double least = std::max(options.least_gain * gain.mean_hypervolume(), unseen);
  small_gains = expected < least ? small_gains + 1 : 0;
  return small_gains >= times_that_count;
}

/// The design of which the surrogates know least, weighed by the chances of success and
/// feasibility.
std::optional<Suggestion> Search::State::suggest_unknown(const Gain& gain, Candidates& candidates) {
  std::vector<Point> xs = candidates.spread(256);
  std::erase_if(xs, [&](const Point& x) { return repeated(x); });
  if (xs.empty()) return std::nullopt;
  Eigen::Index most = 0;
  gain.log_ignorance(xs).maxCoeff(&most);
  Point& x = xs[static_cast<std::size_t>(most)];
  const int level = choose_level(problem, models, x, level_seconds(), levels_taken(x));
  return issue(std::move(x), level, "explore", 0.0);
}

/// The first of the recommended design and its neighbours that the finest level has not seen.
std::optional<Suggestion> Search::State::suggest_confirmation() {
  const EstimatedFront front =
      bayesian::estimated_front(problem, models, told, options.feasibility_tolerance);
  std::vector<Point> designs = by_nearness_to_recommended(front, told, options.recommend);
  if (designs.size() > static_cast<std::size_t>(confirmations))
    designs.resize(static_cast<std::size_t>(confirmations));
  for (Point& x : designs) {
    if (!levels_taken(x)[0]) return issue(std::move(x), 0, "confirm", 0.0);
  }
  return std::nullopt;
}

/// The first question after an answer: the surrogates have changed.
std::optional<Search::State::Best> Search::State::begin_round(const Eigen::VectorXd& reference) {
  std::vector<Suggestion> waiting;
  for (const auto& [id, suggestion] : pending) waiting.push_back(suggestion);
  const auto stream = static_cast<std::uint64_t>(next_id) + 1;
  const Gain::Input input{.problem = problem,
                          .models = models,
                          .told = told,
                          .pending = waiting,
                          .reference = reference,
                          .level_cost = level_cost(),
                          .n_samples = options.samples,
                          .seed = options.seed * 1000003ULL + stream,
                          .tolerance = options.feasibility_tolerance};
  round = std::make_unique<Round>(Round{.told = told.size(), .gain = Gain(input), .pool = {}});
  for (const Suggestion& one : waiting) round->seen.insert(one.id);

  MaximizeInput search;
  search.gain = [&](const auto& xs) { return round->gain.value(xs).log_gain_per_cost; };
  search.screen = [&](const auto& xs) { return round->gain.screen(xs).log_gain_per_cost; };
  search.repeated = [&](const Point& x) { return repeated(x); };
  search.centers = round->gain.front_designs();
  // A candidate costs the number of designs squared.
  search.effort = std::clamp(static_cast<double>(usual_designs) /
                                 static_cast<double>(std::max<std::size_t>(1, told.size())),
                             least_effort, 1.0);
  Candidates candidates(problem, options.feasibility_tolerance, options.seed, stream);
  auto maximum = maximize_gain(search, problem.space, candidates);
  if (!maximum) return std::nullopt;
  const int level = round->gain.value(std::vector<Point>{maximum->best.x}).level.front();
  round->pool = round->gain.prepare(std::move(maximum->pool));
  return Best{
      .x = std::move(maximum->best.x), .level = level, .log_gain_per_cost = maximum->best.log_gain};
}

/// A further question before the next answer: the same surrogates, and the outcomes of what was
/// asked since in their draws. The good designs of the first question are weighed again, and the
/// best one is improved by a few steps.
std::optional<Search::State::Best> Search::State::continue_round() {
  for (const auto& [id, suggestion] : pending) {
    if (round->seen.insert(id).second) round->gain.add_pending(suggestion.x);
  }
  const Gain::Value pool = round->gain.value(round->pool);
  std::optional<Best> best;
  const auto look = [&](const std::vector<Point>& xs, const Gain::Value& value) {
    for (std::size_t k = 0; k < xs.size(); ++k) {
      const double gain = value.log_gain_per_cost[static_cast<Eigen::Index>(k)];
      if (std::isnan(gain) || repeated(xs[k]) || (best && gain <= best->log_gain_per_cost))
        continue;
      best = Best{.x = xs[k], .level = value.level[k], .log_gain_per_cost = gain};
    }
  };
  look(round->pool.xs, pool);
  if (!best || !std::isfinite(best->log_gain_per_cost)) return std::nullopt;
  constexpr std::size_t steps = 8;
  Candidates candidates(problem, options.feasibility_tolerance, options.seed,
                        static_cast<std::uint64_t>(next_id) + 1);
  const std::vector<Point> near = candidates.around(best->x, 0.03, steps);
  look(near, round->gain.value(near));
  return best;
}

/// What a gain is divided by. The end of the budget is for the finest level.
std::vector<double> Search::State::level_cost() const {
  if (problem.levels.size() == 1) return {1.0};
  std::vector<double> cost = level_seconds();
  constexpr double too_dear = 1e12;
  for (std::size_t level = 1; level < cost.size() && confirming(); ++level) cost[level] *= too_dear;
  return cost;
}

std::optional<Suggestion> Search::State::suggest_gain() {
  const auto reference = reference_point(problem, told, options.feasibility_tolerance);
  if (!reference) return suggest_far_away();
  std::optional<Best> best;
  if (round && round->told == told.size()) best = continue_round();
  if (!best) best = begin_round(*reference);
  if (!best) return nothing_left();
  const Gain& gain = round->gain;
  const double log_gain =
      best->log_gain_per_cost + std::log(gain.level_cost(static_cast<std::size_t>(best->level)));

  if (gain.any_feasible()) last_gain = std::exp(log_gain);
  if (gain_is_small(std::exp(log_gain), gain)) {
    if (pending.empty()) stop = StopReason::small_gain;
    return std::nullopt;
  }
  if (std::exp(log_gain) < share_that_doubts * gain.mean_hypervolume() &&
      (next_id - local_steps) % 2 == 0) {
    Candidates candidates(problem, options.feasibility_tolerance, options.seed,
                          static_cast<std::uint64_t>(next_id) + 1);
    if (auto suggestion = suggest_unknown(gain, candidates)) return suggestion;
  }
  return issue(std::move(best->x), best->level, "search", log_gain);
}

}  // namespace parapet::bayesian
