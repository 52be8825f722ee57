#include "known_problems.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "methods.hpp"
#include "parapet/math/pareto.hpp"

namespace parapet::bench::search {
namespace {

using Formula = std::function<std::vector<double>(const Design&)>;

// f gives the objectives, then the limited values, each <= 0.
BenchProblem formula_problem(const std::string& name, const Design& lower, const Design& upper,
                             std::size_t n_objectives, std::size_t n_limits, const Formula& f) {
  BenchProblem problem;
  problem.name = problem.title = name;
  problem.lower = lower;
  problem.upper = upper;
  for (std::size_t j = 0; j < lower.size(); ++j) {
    problem.variables.push_back(fmt::format("x{}", j + 1));
  }
  for (std::size_t j = 0; j < n_objectives; ++j) {
    problem.metrics.push_back({fmt::format("f{}", j + 1), nullptr});
    problem.objectives.push_back({j, false, std::nullopt});
  }
  for (std::size_t k = 0; k < n_limits; ++k) {
    problem.metrics.push_back({fmt::format("g{}", k + 1), nullptr});
    problem.limits.push_back(
        {n_objectives + k, -std::numeric_limits<double>::infinity(), 0.0, 1.0});
  }
  problem.truth = [f](const Design& x) {
    Answer answer{true, {}};
    for (const double value : f(x)) answer.values.emplace_back(value);
    return answer;
  };
  problem.evaluate = [truth = problem.truth](const Design& x, int) { return truth(x); };
  return problem;
}

double square(double x) {
  return x * x;
}

// Cost and deflection of a beam welded to a wall; h, l: the weld, t, b: the beam [in].
std::vector<double> welded(const Design& x) {
  const double h = x[0], l = x[1], t = x[2], b = x[3];
  const double load = 6000.0, length = 14.0;
  const double direct = load / (std::sqrt(2.0) * h * l);
  const double radius_squared = 0.25 * (l * l + square(h + t));
  const double twist = load * (length + 0.5 * l) * std::sqrt(radius_squared) /
                       (2.0 * std::sqrt(0.5) * h * l * (l * l / 12.0 + 0.25 * square(h + t)));
  const double shear =
      std::sqrt(square(direct) + square(twist) + l * direct * twist / std::sqrt(radius_squared));
  const double bending = 504000.0 / (t * t * b);
  const double buckling = 64746.022 * (1.0 - 0.0282346 * t) * t * b * b * b;
  return {1.10471 * h * h * l + 0.04811 * t * b * (length + l),
          2.1952 / (t * t * t * b),
          shear / 13600.0 - 1.0,
          bending / 30000.0 - 1.0,
          h - b,
          1.0 - buckling / 6000.0};
}

}  // namespace

KnownProblem gardner() {
  KnownProblem known;
  known.problem = formula_problem("Gardner", {0, 0}, {6, 6}, 1, 1, [](const Design& x) {
    return std::vector<double>{std::sin(x[0]) + x[1], std::sin(x[0]) * std::sin(x[1]) + 0.95};
  });
  known.problem.evaluations = 60;
  known.least = std::asin(0.95) - 1.0;
  return known;
}

KnownProblem cliff() {
  KnownProblem known;
  known.problem = formula_problem("cliff", {0, 0}, {1, 1}, 1, 0, [](const Design& x) {
    const double along = x[0] + x[1], across = x[0] - x[1] - 0.2;
    const double slope = -along + 4.0 * square(across);
    return std::vector<double>{along <= 1.17 ? slope : slope + 1.0};
  });
  known.problem.evaluations = 60;
  known.least = -1.17;
  return known;
}

KnownProblem rosenbrock(std::size_t n) {
  KnownProblem known;
  known.problem =
      formula_problem(fmt::format("Rosenbrock, {} variables", n), Design(n, -2.0), Design(n, 2.0),
                      1, 0, [](const Design& x) {
                        double sum = 0.0;
                        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
                          sum += 100.0 * square(x[i + 1] - x[i] * x[i]) + square(1.0 - x[i]);
                        }
                        return std::vector<double>{sum};
                      });
  known.problem.evaluations = 100;
  known.least = 0.0;
  return known;
}

KnownProblem vlmop2(std::size_t n) {
  const auto f = [](const Design& x) {
    const double shift = 1.0 / std::sqrt(static_cast<double>(x.size()));
    double near = 0.0, far = 0.0;
    for (const double v : x) {
      near += square(v - shift);
      far += square(v + shift);
    }
    return std::vector<double>{1.0 - std::exp(-near), 1.0 - std::exp(-far)};
  };
  KnownProblem known;
  known.problem = formula_problem(fmt::format("VLMOP2, {} variables", n), Design(n, -2.0),
                                  Design(n, 2.0), 2, 0, f);
  known.problem.evaluations = 60;
  known.yardstick.reference = Eigen::Vector2d(1.0, 1.0);
  for (int k = 0; k <= 2000; ++k) {
    const double t = (k / 1000.0 - 1.0) / std::sqrt(static_cast<double>(n));
    const auto y = f(Design(n, t));
    known.yardstick.front.emplace_back(Eigen::Vector2d(y[0], y[1]));
  }
  known.yardstick.volume = math::hypervolume(known.yardstick.front, known.yardstick.reference);
  return known;
}

KnownProblem welded_beam() {
  KnownProblem known;
  known.problem =
      formula_problem("welded beam", {0.125, 0.1, 0.1, 0.125}, {5, 10, 10, 5}, 2, 4, welded);
  known.problem.evaluations = 60;
  known.yardstick = make_yardstick(known.problem, brute_force_front(known.problem, 60000));
  return known;
}

std::vector<KnownProblem> known_problems() {
  return {gardner(), cliff(), rosenbrock(8), vlmop2(2), vlmop2(4), welded_beam()};
}

}  // namespace parapet::bench::search
