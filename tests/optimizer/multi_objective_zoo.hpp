/// Problems with known optima and Pareto fronts for tests of search: plain functions.
///
/// Branin, Hartmann: Dixon and Szego (1978), values of Surjanovic and Bingham's library. BNH, SRN,
/// TNK: Deb, Multi-Objective Optimization using Evolutionary Algorithms (2001), section 8.3. ZDT:
/// Zitzler, Deb and Thiele, Evol. Comput. 8 (2000) 173-195. DTLZ2, C1-DTLZ1, C2-DTLZ2: Jain and
/// Deb, IEEE Trans. Evol. Comput. 18 (2014) 602-622.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "parapet/math/pareto.hpp"
#include "zoo_fronts.hpp"

namespace parapet::zoo {

using math::Objectives;

struct ZooProblem {
  std::string name;
  Vector lower, upper;                                  ///< [n_variables]
  std::function<Objectives(const Vector&)> objectives;  ///< minimised
  std::function<Vector(const Vector&)> constraints;     ///< feasible: all <= 0; may be empty
  /// About n designs (never more) of the Pareto set, spread over all of its parts.
  std::function<std::vector<Vector>(std::size_t)> pareto_set;
  Objectives reference;  ///< worse than the whole front

  bool feasible(const Vector& x, double tolerance = 0.0) const {
    const Vector c = constraints(x);
    return c.size() == 0 || c.maxCoeff() <= tolerance;
  }

  /// About n points of the Pareto front.
  std::vector<Objectives> front(std::size_t n) const {
    std::vector<Objectives> points;
    for (const Vector& x : pareto_set(n)) points.push_back(objectives(x));
    return points;
  }

  /// Volume below the reference that n points of the front dominate: of the true one but for a
  /// share that falls as 1 / n (two objectives).
  double front_hypervolume(std::size_t n = 2000) const {
    return math::hypervolume(front(n), reference);
  }
};

inline Vector no_constraints(const Vector&) {
  return {};
}

/// One objective: every minimum of it.
inline std::function<std::vector<Vector>(std::size_t)> minima(const std::vector<Vector>& all) {
  return [all](std::size_t n) {
    return std::vector<Vector>(all.begin(),
                               all.begin() + static_cast<std::ptrdiff_t>(std::min(n, all.size())));
  };
}

/// Three minima of 0.397887.
inline ZooProblem branin() {
  const auto f = [](const Vector& x) {
    const double valley = x[1] - 5.1 / (4.0 * pi * pi) * x[0] * x[0] + 5.0 / pi * x[0] - 6.0;
    return vec({valley * valley + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(x[0]) + 10.0});
  };
  return {"Branin",       vec({-5, 0}),
          vec({10, 15}),  f,
          no_constraints, minima({vec({-pi, 12.275}), vec({pi, 2.275}), vec({3.0 * pi, 2.475})}),
          vec({100})};
}

/// -sum_i alpha_i exp(-sum_j a_ij (x_j - p_ij)^2) in the unit cube, n = 3 or 6 columns.
inline Objectives hartmann(const Eigen::MatrixXd& a, const Eigen::MatrixXd& p, const Vector& x) {
  const Vector alpha = vec({1.0, 1.2, 3.0, 3.2});
  double sum = 0.0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Vector distance = x - p.row(i).transpose();
    sum -= alpha[i] * std::exp(-(a.row(i).transpose().array() * distance.array().square()).sum());
  }
  return vec({sum});
}

/// Minimum -3.86278.
inline ZooProblem hartmann_3() {
  Eigen::MatrixXd a(4, 3), p(4, 3);
  a << 3, 10, 30, 0.1, 10, 35, 3, 10, 30, 0.1, 10, 35;
  p << 3689, 1170, 2673, 4699, 4387, 7470, 1091, 8732, 5547, 381, 5743, 8828;
  p *= 1e-4;
  return {"Hartmann 3",    Vector::Zero(3),
          Vector::Ones(3), [a, p](const Vector& x) { return hartmann(a, p, x); },
          no_constraints,  minima({vec({0.114614, 0.555649, 0.852547})}),
          vec({0})};
}

/// Minimum -3.32237.
inline ZooProblem hartmann_6() {
  Eigen::MatrixXd a(4, 6), p(4, 6);
  a << 10, 3, 17, 3.5, 1.7, 8,   //
      0.05, 10, 17, 0.1, 8, 14,  //
      3, 3.5, 1.7, 10, 17, 8,    //
      17, 8, 0.05, 10, 0.1, 14;
  p << 1312, 1696, 5569, 124, 8283, 5886,  //
      2329, 4135, 8307, 3736, 1004, 9991,  //
      2348, 1451, 3522, 2883, 3047, 6650,  //
      4047, 8828, 8732, 5743, 1091, 381;
  p *= 1e-4;
  return {"Hartmann 6",    Vector::Zero(6),
          Vector::Ones(6), [a, p](const Vector& x) { return hartmann(a, p, x); },
          no_constraints,  minima({vec({0.20169, 0.150011, 0.476874, 0.275332, 0.311652, 0.6573})}),
          vec({0})};
}

inline ZooProblem bnh() {
  return {"BNH",
          vec({0, 0}),
          vec({5, 3}),
          [](const Vector& x) {
            return vec({4.0 * x.squaredNorm(), square(x[0] - 5.0) + square(x[1] - 5.0)});
          },
          [](const Vector& x) {
            return vec({square(x[0] - 5.0) + square(x[1]) - 25.0,
                        7.7 - square(x[0] - 8.0) - square(x[1] + 3.0)});
          },
          bnh_set,
          vec({140, 60})};
}

inline ZooProblem srn() {
  return {"SRN",
          vec({-20, -20}),
          vec({20, 20}),
          [](const Vector& x) {
            return vec(
                {2.0 + square(x[0] - 2.0) + square(x[1] - 1.0), 9.0 * x[0] - square(x[1] - 1.0)});
          },
          [](const Vector& x) {
            return vec({x.squaredNorm() - 225.0, x[0] - 3.0 * x[1] + 10.0});
          },
          srn_set,
          vec({250, 50})};
}

inline ZooProblem tnk() {
  return {"TNK",
          vec({0, 0}),
          vec({pi, pi}),
          [](const Vector& x) { return x; },
          [](const Vector& x) {
            return vec({1.0 + 0.1 * std::cos(16.0 * std::atan2(x[0], x[1])) - x.squaredNorm(),
                        square(x[0] - 0.5) + square(x[1] - 0.5) - 0.5});
          },
          tnk_set,
          vec({1.2, 1.2})};
}

/// C1-DTLZ1: many local fronts; the constraint leaves a narrow way to the true one, the simplex
/// sum f = 1/2. n_variables = n_objectives + n_distance - 1.
inline ZooProblem c1_dtlz1(Eigen::Index n_objectives, Eigen::Index n_distance = 2) {
  const Eigen::Index n = n_objectives + n_distance - 1;
  return {"C1-DTLZ1, " + std::to_string(n_objectives) + " objectives",
          Vector::Zero(n),
          Vector::Ones(n),
          [n_objectives](const Vector& x) { return dtlz1(x, n_objectives); },
          [n_objectives](const Vector& x) {
            const Vector f = dtlz1(x, n_objectives);
            const Eigen::Index last = n_objectives - 1;
            return vec({f[last] / 0.6 + f.head(last).sum() / 0.5 - 1.0});
          },
          [n_objectives, n](std::size_t count) { return dtlz1_set(count, n_objectives, n); },
          Objectives::Constant(n_objectives, 0.6)};
}

/// C2-DTLZ2: of the unit sphere, only what is near to its corners or its middle.
inline ZooProblem c2_dtlz2(Eigen::Index n_objectives, Eigen::Index n_distance = 2) {
  const Eigen::Index n = n_objectives + n_distance - 1;
  return {"C2-DTLZ2, " + std::to_string(n_objectives) + " objectives",
          Vector::Zero(n),
          Vector::Ones(n),
          [n_objectives](const Vector& x) { return dtlz2(x, n_objectives); },
          [n_objectives](const Vector& x) { return vec({c2_distance(dtlz2(x, n_objectives))}); },
          [n_objectives, n](std::size_t count) { return c2_dtlz2_set(count, n_objectives, n); },
          Objectives::Constant(n_objectives, 1.1)};
}

/// ZDT1 (convex), ZDT2 (concave), ZDT3 (five parts).
inline ZooProblem zdt(int number, Eigen::Index n_variables = 6) {
  return {"ZDT" + std::to_string(number),
          Vector::Zero(n_variables),
          Vector::Ones(n_variables),
          [number](const Vector& x) {
            const double g =
                1.0 + 9.0 * x.tail(x.size() - 1).sum() / static_cast<double>(x.size() - 1);
            return vec({x[0], g * zdt_shape(number, x[0], g)});
          },
          no_constraints,
          [number, n_variables](std::size_t n) { return zdt_set(n, number, n_variables); },
          vec({1.1, 1.1})};
}

inline std::vector<ZooProblem> single_objective_zoo() {
  return {branin(), hartmann_3(), hartmann_6()};
}

inline std::vector<ZooProblem> multi_objective_zoo() {
  return {bnh(),       srn(),       tnk(),  c1_dtlz1(2), c1_dtlz1(3),
          c2_dtlz2(2), c2_dtlz2(3), zdt(1), zdt(2),      zdt(3)};
}

}  // namespace parapet::zoo
