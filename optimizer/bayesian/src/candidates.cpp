#include "candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parapet/optimizer/sobol.hpp"

namespace parapet::bayesian {
namespace {

/// Largest amount by which a cheap constraint is exceeded; NaN counts as infinite.
double worst_excess(const Problem& problem, const Point& x) {
  if (!problem.cheap_constraints) return 0.0;
  double worst = 0.0;
  for (const double c : problem.cheap_constraints(x)) {
    if (std::isnan(c)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, c);
  }
  return worst;
}

/// Points of the unit cube, low discrepancy where the dimension allows it.
class UnitPoints {
 public:
  UnitPoints(std::size_t dimension, Random& random) : random_(random) {
    if (dimension <= optimizer::SobolSequence::max_dimension) {
      sobol_.emplace_back(static_cast<int>(dimension));
    }
    for (std::size_t i = 0; i < dimension; ++i) shift_.push_back(random.uniform());
  }

  std::vector<double> next() {
    std::vector<double> u;
    if (!sobol_.empty()) u = sobol_.front().next();
    u.resize(shift_.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = sobol_.empty() ? random_.uniform() : std::fmod(u[i] + shift_[i], 1.0);
    }
    return u;
  }

 private:
  Random& random_;
  std::vector<optimizer::SobolSequence> sobol_;  // none or one
  std::vector<double> shift_;
};

}  // namespace

bool allowed(const Problem& problem, const Point& x, double tolerance) {
  return worst_excess(problem, x) <= tolerance;
}

Candidates::Candidates(const Problem& problem, double tolerance, std::uint64_t seed,
                       std::uint64_t stream)
    : problem_(problem), tolerance_(tolerance), random_(seed, stream) {}

double Candidates::excess(const Point& x) const {
  return worst_excess(problem_, x);
}

std::vector<Point> Candidates::spread(std::size_t n) {
  constexpr std::size_t tries_each = 20, least_tries = 20000;
  UnitPoints units(problem_.space.size(), random_);
  std::vector<Point> found;
  for (std::size_t k = 0; k < tries_each * n || (found.empty() && k < least_tries); ++k) {
    if (found.size() == n) return found;
    Point x = problem_.space.from_unit(units.next());
    if (excess(x) <= tolerance_) found.push_back(std::move(x));
  }
  if (found.empty()) found = search_for_one();
  // The allowed region is small: fill it by steps from the designs that are in it.
  for (std::size_t k = 0; !found.empty() && found.size() < n; ++k) {
    const double reach = k % 2 == 0 ? 0.3 : 0.05;
    found.push_back(around(found[random_.below(found.size())], reach, 1).front());
  }
  return found;
}

std::vector<Point> Candidates::search_for_one() {
  UnitPoints units(problem_.space.size(), random_);
  std::vector<double> best = units.next();
  double least = excess(problem_.space.from_unit(best));
  const auto take_if_better = [&](const std::vector<double>& u) {
    const double value = excess(problem_.space.from_unit(u));
    if (value < least) {
      least = value;
      best = u;
    }
  };
  for (int k = 0; k < 2000; ++k) take_if_better(units.next());
  double reach = 0.3;
  for (int k = 0; k < 4000 && least > tolerance_; ++k) {
    const double before = least;
    take_if_better(step(best, reach));
    reach = least < before ? std::min(0.3, 1.5 * reach) : std::max(1e-6, 0.98 * reach);
  }
  if (least > tolerance_) return {};
  return {problem_.space.from_unit(best)};
}

std::vector<double> Candidates::step(const std::vector<double>& from, double reach) {
  const std::size_t n = from.size();
  std::vector<double> u = from;
  // In many dimensions a step in all of them is never a small one: move a few at a time.
  const double share = std::max(2.0 / static_cast<double>(n), 0.3);
  const std::size_t always = random_.below(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool moves = random_.uniform() < share || i == always;
    // Sum of three uniform numbers: a bell within +-1.5, s.d. 0.5.
    const double bell = random_.uniform() + random_.uniform() + random_.uniform() - 1.5;
    const double elsewhere = random_.uniform();
    if (!moves) continue;
    const Variable& v = problem_.space.variables()[i];
    if (v.kind == VariableKind::continuous) {
      u[i] = std::clamp(u[i] + 2.0 * reach * bell, 0.0, 1.0);
    } else if (v.kind == VariableKind::integer) {
      const double values = std::floor(v.upper) - std::ceil(v.lower) + 1.0;
      u[i] = std::clamp(u[i] + std::max(2.0 * reach, 2.0 / values) * bell, 0.0, 1.0);
    } else if (elsewhere < 0.5) {
      u[i] = 2.0 * elsewhere;
    }
  }
  return u;
}

std::vector<Point> Candidates::around(const Point& center, double reach, std::size_t n) {
  const std::vector<double> from = problem_.space.to_unit(center);
  std::vector<Point> found;
  while (found.size() < n) {
    const std::vector<double> to = step(from, reach);
    Point x = problem_.space.from_unit(to);
    // Back along the step until it is allowed: half of what is left each time.
    double most = 1.0, least = 0.0;
    Point best = center;
    if (excess(x) <= tolerance_) {
      best = x;
    } else {
      for (int k = 0; k < 12; ++k) {
        const double part = 0.5 * (least + most);
        std::vector<double> u(from.size());
        for (std::size_t i = 0; i < u.size(); ++i) u[i] = from[i] + part * (to[i] - from[i]);
        x = problem_.space.from_unit(u);
        const bool good = excess(x) <= tolerance_;
        (good ? least : most) = part;
        if (good) best = x;
      }
    }
    found.push_back(std::move(best));
  }
  return found;
}

}  // namespace parapet::bayesian
