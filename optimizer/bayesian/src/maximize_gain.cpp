#include "maximize_gain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace parapet::bayesian {
namespace {

std::vector<Candidate> weighed(const LogGain& gain, std::vector<Point> xs) {
  std::vector<Candidate> result;
  if (xs.empty()) return result;
  const Eigen::VectorXd values = gain(xs);
  for (std::size_t k = 0; k < xs.size(); ++k) {
    const double value = values[static_cast<Eigen::Index>(k)];
    if (!std::isnan(value)) result.push_back({std::move(xs[k]), value});
  }
  return result;
}

void best_first(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.log_gain > b.log_gain; });
}

/// Largest difference of a coordinate in the unit cube.
double distance(const Space& space, const Point& a, const Point& b) {
  const auto u = space.to_unit(a), v = space.to_unit(b);
  double largest = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  return largest;
}

/// The best ones that are not neighbours of each other, so that not all climb the same hill.
std::vector<Candidate> different(const Space& space, const std::vector<Candidate>& sorted,
                                 std::size_t n) {
  constexpr double apart = 0.05;
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : sorted) {
    if (chosen.size() == n) break;
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      return distance(space, candidate.x, other.x) < apart;
    });
    if (!near) chosen.push_back(candidate);
  }
  return chosen;
}

}  // namespace

std::optional<Maximum> maximize_gain(const MaximizeInput& input, const Space& space,
                                     Candidates& candidates) {
  const std::size_t n = space.size();
  const auto share = [&](std::size_t count) {
    return static_cast<std::size_t>(std::lround(input.effort * static_cast<double>(count)));
  };
  std::vector<Point> xs = candidates.spread(share(std::min<std::size_t>(100 * n, 400)));
  const std::size_t around_each =
      input.centers.empty() ? 0 : std::max<std::size_t>(4, share(240) / input.centers.size());
  for (const Point& center : input.centers) {
    for (const double reach : {0.2, 0.05}) {
      for (Point& x : candidates.around(center, reach, around_each / 2)) xs.push_back(std::move(x));
    }
  }
  std::erase_if(xs, input.repeated);
  std::vector<Candidate> screened = weighed(input.screen, std::move(xs));
  best_first(screened);

  constexpr std::size_t n_pool = 32;
  const std::size_t n_climbers = std::max<std::size_t>(2, share(5));
  const std::size_t steps_each = std::max<std::size_t>(8, share(16));
  std::vector<Point> starts;
  for (const Candidate& c : different(space, screened, 3 * n_climbers)) starts.push_back(c.x);
  std::vector<Candidate> sorted = weighed(input.gain, std::move(starts));
  best_first(sorted);
  if (sorted.empty()) return std::nullopt;
  if (sorted.size() > n_climbers) sorted.resize(n_climbers);
  for (const double reach : {0.1, 0.05, 0.02, 0.008, 0.003}) {
    for (Candidate& climber : sorted) {
      std::vector<Point> steps = candidates.around(climber.x, reach, steps_each);
      std::erase_if(steps, input.repeated);
      for (Candidate& step : weighed(input.gain, std::move(steps))) {
        if (step.log_gain > climber.log_gain) climber = std::move(step);
      }
    }
    // The last steps are for the two best hills only.
    best_first(sorted);
    if (reach <= 0.02 && sorted.size() > 2) sorted.resize(2);
  }
  best_first(sorted);
  Maximum maximum{.best = sorted.front(), .pool = {}};
  for (std::size_t k = 1; k < sorted.size(); ++k) maximum.pool.push_back(sorted[k].x);
  for (const Candidate& c : different(space, screened, n_pool)) maximum.pool.push_back(c.x);
  return maximum;
}

}  // namespace parapet::bayesian
