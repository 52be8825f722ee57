/// Problems with known optima, shared by the tests of the optimizer.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "parapet/optimizer/optimize.hpp"

namespace parapet::optimizer::zoo {

using Vector = std::vector<double>;

/// A problem and what is known about it.
struct Known {
  std::string name;
  Problem problem;
  double optimum = 0.0;            ///< least objective among the feasible points
  std::vector<Vector> minimizers;  ///< all of them
};

inline Problem boxed(const Vector& lower, const Vector& upper) {
  Problem problem;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    problem.names.emplace_back("x").append(std::to_string(i));
  }
  problem.lower = lower;
  problem.upper = upper;
  return problem;
}

template <typename Function>
Problem unconstrained(const Vector& lower, const Vector& upper, Function f) {
  Problem problem = boxed(lower, upper);
  problem.evaluate = [f](const Vector& x) {
    return Evaluation{.ok = true, .reason = {}, .objective = f(x), .constraints = {}};
  };
  return problem;
}

/// g(x): the vector of constraints, satisfied when <= 0.
template <typename Function, typename Constraints>
Problem constrained(const Vector& lower, const Vector& upper, int n_constraints, Function f,
                    Constraints g) {
  Problem problem = boxed(lower, upper);
  problem.n_constraints = n_constraints;
  problem.evaluate = [f, g](const Vector& x) {
    return Evaluation{.ok = true, .reason = {}, .objective = f(x), .constraints = g(x)};
  };
  return problem;
}

/// sum_i (i + 1) (x_i - 0.3)^2 on [-1, 2]^n.
inline Known sphere(int n) {
  const auto size = static_cast<std::size_t>(n);
  auto f = [](const Vector& x) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += static_cast<double>(i + 1) * (x[i] - 0.3) * (x[i] - 0.3);
    }
    return sum;
  };
  return {
      "sphere", unconstrained(Vector(size, -1.0), Vector(size, 2.0), f), 0.0, {Vector(size, 0.3)}};
}

/// Rosenbrock's valley on [-2, 2]^2.
inline Known rosenbrock() {
  auto f = [](const Vector& x) {
    return 100.0 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1.0 - x[0], 2);
  };
  return {"Rosenbrock", unconstrained({-2.0, -2.0}, {2.0, 2.0}, f), 0.0, {{1.0, 1.0}}};
}

/// Branin's function with three equal minima (Dixon and Szegoe 1978).
inline Known branin() {
  auto f = [](const Vector& x) {
    constexpr double pi = std::numbers::pi;
    const double a = x[1] - 5.1 / (4.0 * pi * pi) * x[0] * x[0] + 5.0 / pi * x[0] - 6.0;
    return a * a + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(x[0]) + 10.0;
  };
  constexpr double pi = std::numbers::pi;
  return {"Branin",
          unconstrained({-5.0, 0.0}, {10.0, 15.0}, f),
          0.39788735772973816,
          {{-pi, 12.275}, {pi, 2.275}, {9.42477796, 2.475}}};
}

/// Hartmann's function in three variables, four local minima.
inline Known hartmann3() {
  auto f = [](const Vector& x) {
    constexpr double alpha[4] = {1.0, 1.2, 3.0, 3.2};
    constexpr double a[4][3] = {{3, 10, 30}, {0.1, 10, 35}, {3, 10, 30}, {0.1, 10, 35}};
    constexpr double p[4][3] = {{0.3689, 0.1170, 0.2673},
                                {0.4699, 0.4387, 0.7470},
                                {0.1091, 0.8732, 0.5547},
                                {0.03815, 0.5743, 0.8828}};
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
      double inner = 0.0;
      for (int i = 0; i < 3; ++i) {
        inner += a[k][i] * std::pow(x[static_cast<std::size_t>(i)] - p[k][i], 2);
      }
      sum -= alpha[k] * std::exp(-inner);
    }
    return sum;
  };
  return {"Hartmann-3",
          unconstrained({0, 0, 0}, {1, 1, 1}, f),
          -3.86278214782076,
          {{0.114614, 0.555649, 0.852547}}};
}

/// G06 (Michalewicz and Schoenauer 1996): a sliver between two circles, scaled to order one.
inline Known g06() {
  auto f = [](const Vector& x) {
    return (std::pow(x[0] - 10.0, 3) + std::pow(x[1] - 20.0, 3)) / 1000.0;
  };
  auto g = [](const Vector& x) {
    return Vector{(100.0 - std::pow(x[0] - 5.0, 2) - std::pow(x[1] - 5.0, 2)) / 100.0,
                  (std::pow(x[0] - 6.0, 2) + std::pow(x[1] - 5.0, 2) - 82.81) / 100.0};
  };
  return {"G06",
          constrained({13.0, 0.0}, {100.0, 100.0}, 2, f, g),
          -6.96181387558015,
          {{14.095, 0.842960789215}}};
}

/// G08: the optimum is inside the feasible region, many local optima around.
inline Known g08() {
  auto f = [](const Vector& x) {
    constexpr double pi = std::numbers::pi;
    return -std::pow(std::sin(2.0 * pi * x[0]), 3) * std::sin(2.0 * pi * x[1]) /
           (std::pow(x[0], 3) * (x[0] + x[1]));
  };
  auto g = [](const Vector& x) {
    return Vector{(x[0] * x[0] - x[1] + 1.0) / 10.0, (1.0 - x[0] + std::pow(x[1] - 4.0, 2)) / 10.0};
  };
  return {"G08",
          constrained({0.1, 0.1}, {10.0, 10.0}, 2, f, g),
          -0.0958250414180359,
          {{1.22797135, 4.24537337}}};
}

/// -x - y within the unit disc: optimum -sqrt(2), on a curved boundary.
inline Known linear_on_disc() {
  auto f = [](const Vector& x) { return -x[0] - x[1]; };
  auto g = [](const Vector& x) { return Vector{x[0] * x[0] + x[1] * x[1] - 1.0}; };
  const double r = std::numbers::sqrt2 / 2.0;
  return {"linear on a disc",
          constrained({-1.5, -1.5}, {1.5, 1.5}, 1, f, g),
          -std::numbers::sqrt2,
          {{r, r}}};
}

/// Mishra's bird within a disc of radius 5 around (-5, -5).
inline Known mishra_bird() {
  auto f = [](const Vector& x) {
    return std::sin(x[1]) * std::exp(std::pow(1.0 - std::cos(x[0]), 2)) +
           std::cos(x[0]) * std::exp(std::pow(1.0 - std::sin(x[1]), 2)) + std::pow(x[0] - x[1], 2);
  };
  auto g = [](const Vector& x) {
    return Vector{(std::pow(x[0] + 5.0, 2) + std::pow(x[1] + 5.0, 2) - 25.0) / 25.0};
  };
  return {"Mishra's bird",
          constrained({-10.0, -6.5}, {0.0, 0.0}, 1, f, g),
          -106.76453674926,
          {{-3.1302468, -1.5821422}}};
}

/// The sphere in 2-D with x0 >= 0.8 as constraint: optimum 0.25 on a plane boundary.
inline Known sphere_with_wall() {
  auto f = [](const Vector& x) { return std::pow(x[0] - 0.3, 2) + 2.0 * std::pow(x[1] - 0.3, 2); };
  auto g = [](const Vector& x) { return Vector{0.8 - x[0]}; };
  return {"sphere with a wall", constrained({-1.0, -1.0}, {2.0, 2.0}, 1, f, g), 0.25, {{0.8, 0.3}}};
}

/// The sphere in 2-D where x0 + x1 <= 0.2 is checked without evaluating: it takes away most of the
/// box and the free optimum. Optimum at (x0, x1) = (0.3 - 4/15, 0.3 - 2/15), value 4/75 * 2.
inline Known cheap_half() {
  Known known = sphere(2);
  known.name = "cheap half";
  known.problem.n_cheap_constraints = 1;
  known.problem.cheap_constraints = [](const Vector& x) { return Vector{x[0] + x[1] - 0.2}; };
  known.minimizers = {{0.3 - 4.0 / 15.0, 0.3 - 2.0 / 15.0}};
  known.optimum = std::pow(4.0 / 15.0, 2) + 2.0 * std::pow(2.0 / 15.0, 2);
  return known;
}

/// A hash of the coordinates in [0, 1): the same at the same point, without pattern elsewhere.
inline double hashed(const Vector& x) {
  std::uint64_t h = 0x9E3779B97F4A7C15ULL;
  for (const double value : x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    h ^= bits;
    h *= 0xBF58476D1CE4E5B9ULL;
    h ^= h >> 29;
    h *= 0x94D049BB133111EBULL;
    h ^= h >> 32;
  }
  return static_cast<double>(h >> 11) * 0x1p-53;
}

/// The sphere where 30 % of the points fail, without any pattern.
inline Known failing_sphere(int n) {
  Known known = sphere(n);
  known.name = "failing sphere";
  known.problem.evaluate = [inner = known.problem.evaluate](const Vector& x) {
    if (hashed(x) < 0.3) return Evaluation{.ok = false, .reason = "diverged", .constraints = {}};
    return inner(x);
  };
  return known;
}

/// The sphere with a deterministic noise of +-0.005 that differs at every point.
inline Known noisy_sphere(int n) {
  Known known = sphere(n);
  known.name = "noisy sphere";
  known.problem.evaluate = [inner = known.problem.evaluate](const Vector& x) {
    Evaluation evaluation = inner(x);
    evaluation.objective += 0.01 * (hashed(x) - 0.5);
    return evaluation;
  };
  return known;
}

/// x0 >= 1.2 and x0 <= 0.8: nothing is feasible; the least violation is 0.2 at x0 = 1.
inline Known infeasible() {
  auto f = [](const Vector& x) { return x[0] + x[1]; };
  auto g = [](const Vector& x) { return Vector{1.2 - x[0], x[0] - 0.8}; };
  return {"infeasible", constrained({-1.0, -1.0}, {2.0, 2.0}, 2, f, g), 0.0, {}};
}

}  // namespace parapet::optimizer::zoo
