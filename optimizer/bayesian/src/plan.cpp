#include <algorithm>
#include <cmath>

#include "candidates.hpp"
#include "search_state.hpp"

namespace parapet::bayesian {
namespace {

/// With several levels: every so many of the initial designs at the finest and at those between.
constexpr std::size_t share_of_finest = 12, share_between = 3;

/// Enough to see a slope in every variable, at most a third of the budget.
std::size_t initial_count(const Problem& problem, const SearchOptions& options) {
  if (options.initial_designs > 0) return static_cast<std::size_t>(options.initial_designs);
  const std::size_t wanted = 2 * problem.space.size() + 2;
  const auto affordable = static_cast<std::size_t>(std::max(1, planned_evaluations(options) / 3));
  return std::max<std::size_t>(1, std::min(wanted, affordable));
}

}  // namespace

/// The user's starts at the finest level, then designs spread over the allowed space. With several
/// levels the coarsest gets them all, half as many more than there would be with one, and the
/// finest a twelfth of these, so that the levels can be compared; those between a third.
void Search::State::make_plan() {
  planned = true;
  for (const Point& start : options.starts) {
    const Point x = problem.space.canonical(start);
    if (allowed(problem, x, options.feasibility_tolerance)) plan.push_back({x, 0, "start"});
  }
  const bool several_levels = problem.levels.size() > 1;
  std::size_t n = initial_count(problem, options);
  if (several_levels) n += n / 2;
  const std::size_t n_starts = plan.size();
  Candidates candidates(problem, options.feasibility_tolerance, options.seed, 0);
  std::vector<Point> spread;
  if (n > n_starts) spread = candidates.spread(n - n_starts);
  if (n_starts == 0 && spread.empty() && told.empty()) stop = StopReason::no_allowed_design;
  // What was told already, from this plan (the search was interrupted) or from elsewhere, counts.
  const auto known = [&](const Point& x) {
    return std::any_of(told.begin(), told.end(), [&](const Told& t) { return near(x, t.x); });
  };
  const auto n_known = static_cast<std::size_t>(std::count_if(spread.begin(), spread.end(), known));
  std::size_t elsewhere = 0;
  for (const Told& t : told) {
    const auto same = [&](const auto& planned_design) { return near(planned_design, t.x); };
    const bool of_plan =
        std::any_of(spread.begin(), spread.end(), same) ||
        std::any_of(plan.begin(), plan.end(), [&](const Planned& p) { return same(p.x); });
    elsewhere += of_plan ? 0 : 1;
  }
  const std::size_t wanted = spread.size() - n_known;
  std::size_t left = wanted > elsewhere ? wanted - elsewhere : 0;
  const int coarsest = static_cast<int>(problem.levels.size()) - 1;
  for (std::size_t k = 0; k < spread.size(); ++k) {
    if (!known(spread[k]) && left == 0) continue;
    left -= known(spread[k]) ? 0 : 1;
    // Levels that are there already are passed over when their turn comes.
    plan.push_back({spread[k], coarsest, "initial"});
    for (int level = coarsest - 1; level >= 0; --level) {
      if (k % (level == 0 ? share_of_finest : share_between) != 0) continue;
      plan.push_back({spread[k], level, "initial"});
    }
  }
}

std::optional<Suggestion> Search::State::next_planned() {
  while (!plan.empty()) {
    Planned next = std::move(plan.front());
    plan.pop_front();
    if (levels_taken(next.x)[static_cast<std::size_t>(next.level)]) continue;
    return issue(std::move(next.x), next.level, std::move(next.stage), 0.0);
  }
  return std::nullopt;
}

/// Without a model of every objective: the design farthest from all others, weighed by the chance
/// that its evaluation succeeds.
std::optional<Suggestion> Search::State::suggest_far_away() {
  Candidates candidates(problem, options.feasibility_tolerance, options.seed,
                        1000003ULL + static_cast<std::uint64_t>(next_id));
  std::vector<Point> xs = candidates.spread(256);
  std::erase_if(xs, [&](const Point& x) { return repeated(x); });
  if (xs.empty()) return nothing_left();
  const Eigen::MatrixXd inputs = problem.space.features(xs);
  Eigen::VectorXd value = models.log_success(inputs);
  std::vector<Point> others;
  for (const Told& t : told) others.push_back(t.x);
  for (const auto& [id, suggestion] : pending) others.push_back(suggestion.x);
  const Eigen::MatrixXd known = problem.space.features(others);
  for (Eigen::Index k = 0; k < value.size() && known.rows() > 0; ++k) {
    const double nearest = (known.rowwise() - inputs.row(k)).rowwise().norm().minCoeff();
    value[k] += std::log(std::max(nearest, 1e-12));
  }
  Eigen::Index best = 0;
  value.maxCoeff(&best);
  return issue(std::move(xs[static_cast<std::size_t>(best)]), 0, "initial", 0.0);
}

}  // namespace parapet::bayesian
