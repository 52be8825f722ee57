#include "local_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "candidates.hpp"
#include "neighbourhood.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::bayesian {
namespace {

constexpr double first_width = 0.2, most_width = 0.4, least_width = 1e-6;
constexpr double share_of_noise = 0.25;  // a step that promises less is not worth an evaluation

/// NLopt's COBYLA on the surrogates, from the best design.
std::optional<std::vector<double>> least_mean(const Problem& problem, const Neighbourhood& near,
                                              double tolerance, std::uint64_t seed) {
  optimizer::Problem scalar;
  scalar.lower.assign(near.n_free(), 0.0);
  scalar.upper.assign(near.n_free(), 1.0);
  for (std::size_t k = 0; k < near.n_free(); ++k) scalar.names.push_back("v" + std::to_string(k));
  scalar.n_constraints = static_cast<int>(near.n_constraints());
  scalar.evaluate = [&](const std::vector<double>& v) { return near.predict(v); };
  if (problem.cheap_constraints) {
    scalar.cheap_constraints = [&](const std::vector<double>& v) {
      return problem.cheap_constraints(near.design(v));
    };
    scalar.n_cheap_constraints =
        static_cast<int>(problem.cheap_constraints(near.design(near.middle())).size());
  }
  optimizer::Options options;
  options.algorithm = "COBYLA";
  options.max_evaluations = 60 * static_cast<int>(near.n_free()) + 40;
  options.relative_tolerance = 1e-5;
  options.initial_step = 0.25;
  options.seed = seed;
  options.feasibility_tolerance = tolerance;
  options.starts = {near.middle()};
  for (double& v : options.starts.front()) v = std::clamp(v, 0.0, 1.0);
  const optimizer::OptimizeResult result = optimizer::optimize(scalar, options);
  if (result.best) return result.best->x;
  // The best design lies outside the surrogate's limits by its margin: the least violation then.
  if (result.best_infeasible) return result.best_infeasible->x;
  return std::nullopt;
}

}  // namespace

std::optional<TrustRegion> trust_region(const Problem& problem, const std::vector<Told>& told,
                                        double tolerance) {
  std::optional<TrustRegion> region;
  double best = 0.0;
  int failures = 0;
  const int most_failures = std::max(2, static_cast<int>(problem.space.size()) / 2);
  for (std::size_t k = 0; k < told.size(); ++k) {
    const Told& t = told[k];
    if (t.level != 0) continue;
    const bool feasible =
        t.ok && meets_limits(problem, t.values, tolerance) && allowed(problem, t.x, tolerance);
    const auto y = feasible ? minimized(problem, t.values) : std::nullopt;
    const bool improves = y && (!region || (*y)[0] < best);
    if (!region) {
      if (improves) region = TrustRegion{k, first_width};
      if (improves) best = (*y)[0];
      continue;
    }
    const double step =
        distance(problem.space.to_unit(t.x), problem.space.to_unit(told[region->best].x));
    if (improves) {
      best = (*y)[0];
      region->best = k;
      failures = 0;
      if (step > region->half_width * (1.0 + 1e-9)) {
        region->half_width = first_width;  // another hill
      } else if (step > 0.5 * region->half_width) {
        region->half_width = std::min(most_width, 2.0 * region->half_width);
      }
    } else if (step <= region->half_width * (1.0 + 1e-9) && ++failures >= most_failures) {
      failures = 0;
      region->half_width = std::max(least_width, 0.5 * region->half_width);
    }
  }
  return region;
}

namespace {

/// Calls f(evaluation, improvement) for all that was told, in order: by how much each made the best
/// feasible design better, 0 for those that did not.
template <typename F>
void for_each_improvement(const Problem& problem, const std::vector<Told>& told, double tolerance,
                          const F& f) {
  std::optional<double> best;
  for (const Told& t : told) {
    const bool feasible = t.ok && meets_limits(problem, t.values, tolerance);
    const auto y = feasible ? minimized(problem, t.values) : std::nullopt;
    f(t, y && best ? std::max(0.0, *best - (*y)[0]) : 0.0);
    if (y && (!best || (*y)[0] < *best)) best = (*y)[0];
  }
}

}  // namespace

int idle_evaluations(const Problem& problem, const std::vector<Told>& told, double tolerance) {
  int idle = 0;
  for_each_improvement(problem, told, tolerance, [&](const Told& t, double improvement) {
    if (!t.local) idle = improvement > 0.0 ? 0 : idle + 1;
  });
  return idle;
}

bool local_turn(const Problem& problem, const std::vector<Told>& told, double tolerance) {
  constexpr int most_running = 3;
  double gain_local = 0.0, gain_global = 0.0;
  int running = 0;  // evaluations of the last one's kind
  bool last_local = false;
  for_each_improvement(problem, told, tolerance, [&](const Told& t, double improvement) {
    double& gain = t.local ? gain_local : gain_global;
    gain = 0.5 * (gain + improvement);
    running = t.local == last_local ? running + 1 : 1;
    last_local = t.local;
  });
  if (gain_local == gain_global) return !last_local;
  const bool better_local = gain_local > gain_global;
  return running >= most_running && last_local == better_local ? !better_local : better_local;
}

std::optional<Point> local_step(const Problem& problem, const std::vector<Told>& told,
                                const TrustRegion& region, double tolerance, std::uint64_t seed) {
  const Neighbourhood near(problem, told, region, seed);
  if (!near.enough() || !near.modelled()) return std::nullopt;
  const auto known = [&](const Point& x) {
    const std::vector<double> u = problem.space.to_unit(x);
    return std::any_of(told.begin(), told.end(), [&](const Told& t) {
      return t.level == 0 && same_kind(problem.space, t.x, x) &&
             distance(problem.space.to_unit(t.x), u) < 1e-3 * region.half_width;
    });
  };
  if (auto v = least_mean(problem, near, tolerance, seed)) {
    const double promised = near.best_objective() - near.predict(*v).objective;
    Point x = near.design(*v);
    if (promised > share_of_noise * near.noise() && !known(x)) return x;
  }
  if (near.noise() > 0.1) return std::nullopt;  // no digits to be had
  // The surrogate's least design is known: learn where it knows least.
  Random random(seed, 17);
  std::optional<Point> most_unknown;
  double most = 0.0;
  for (std::size_t k = 0; k < 32 * near.n_free(); ++k) {
    std::vector<double> v;
    for (std::size_t i = 0; i < near.n_free(); ++i) v.push_back(random.uniform());
    const Point x = near.design(v);
    const double unknown = near.deviation(v);
    if (unknown <= most || known(x) || !allowed(problem, x, tolerance)) continue;
    most = unknown;
    most_unknown = x;
  }
  return most_unknown;
}

}  // namespace parapet::bayesian
