/// Pareto sets of the zoo's problems, and how each comes about.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

namespace parapet::zoo {

using Vector = Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

inline Vector vec(std::initializer_list<double> values) {
  return Eigen::Map<const Vector>(values.begin(), static_cast<Eigen::Index>(values.size()));
}
inline double square(double x) {
  return x * x;
}

/// k-th of n values spread evenly from a to b, the ends among them.
inline double spread(double a, double b, std::size_t k, std::size_t n) {
  return n < 2 ? a : a + (b - a) * static_cast<double>(k) / static_cast<double>(n - 1);
}

/// Where f changes its sign between a (negative) and b: bisected until nothing lies between, and
/// then the side where it is negative.
template <class Function>
double last_negative(const Function& f, double a, double b) {
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (a + b);
    (f(middle) < 0.0 ? a : b) = middle;
  }
  return a;
}

/// n of a longer list, evenly.
inline std::vector<Vector> thinned(const std::vector<Vector>& all, std::size_t n) {
  if (all.size() <= n) return all;
  std::vector<Vector> kept;
  for (std::size_t k = 0; k < n; ++k) {
    const double place = spread(0.0, static_cast<double>(all.size() - 1), k, n);
    kept.push_back(all[static_cast<std::size_t>(std::lround(place))]);
  }
  return kept;
}

/// BNH, analytic: from the best of f1, (0, 0), straight to the best of f2 without bounds, (5, 5),
/// and where the bound x2 <= 3 stops that, along it to (5, 3). No constraint is met on the way.
inline std::vector<Vector> bnh_set(std::size_t n) {
  std::vector<Vector> set;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = spread(0.0, 5.0, k, n);
    set.push_back(vec({t, std::min(t, 3.0)}));
  }
  return set;
}

/// SRN. f1 + f2 = 2 + (x1 - 2)^2 + 9 x1 depends on x1 alone and is least at x1 = -2.5: on that line
/// every point is optimal, between the limit of g2, x2 = 2.5, and of g1, x2 = sqrt(225 - 2.5^2).
/// From the lower end the front goes on along g2 = 0 to the best of f1, which is the foot of the
/// perpendicular from (2, 1): (1.1, 3.7). From the upper end it goes on along the circle g1 = 0 to
/// the best of f2, where 9 x2 + 2 (x2 - 1) x1 = 0 (derivative along the circle, by bisection).
inline std::vector<Vector> srn_set(std::size_t n) {
  const auto on_circle = [](double angle) {
    return vec({15.0 * std::cos(angle), 15.0 * std::sin(angle)});
  };
  const double angle_at_line = std::acos(-2.5 / 15.0);
  const double best_angle = last_negative(
      [&](double angle) {
        const Vector x = on_circle(angle);
        return -9.0 * x[1] - 2.0 * (x[1] - 1.0) * x[0];
      },
      angle_at_line, 0.75 * pi);
  const double top = std::sqrt(225.0 - 2.5 * 2.5);
  std::vector<Vector> set;
  for (std::size_t k = 0; k < n; ++k) {
    // Shares of the three parts as they are in f1: 14, 182 and some 16 units.
    const double s = spread(0.0, 1.0, k, n);
    if (s < 0.1) {
      const double x2 = 3.7 - (3.7 - 2.5) * s / 0.1;
      set.push_back(vec({3.0 * x2 - 10.0, x2}));
    } else if (s < 0.9) {
      set.push_back(vec({-2.5, 2.5 + (top - 2.5) * (s - 0.1) / 0.8}));
    } else {
      set.push_back(on_circle(angle_at_line + (best_angle - angle_at_line) * (s - 0.9) / 0.1));
    }
  }
  return set;
}

/// TNK. f = x, so a Pareto point lies on the wave r^2 = 1 + cos(16 phi) / 10 (elsewhere it could
/// still move down or left), inside of g2, and is not dominated. The wave meets the circle of g2
/// near both axes: these two angles by bisection; between them the wave in 40,001 points, of which
/// the non-dominated are kept (a point's neighbours are 4e-5 away).
inline std::vector<Vector> tnk_set(std::size_t n) {
  const auto on_wave = [](double phi) {
    const double r = std::sqrt(1.0 + 0.1 * std::cos(16.0 * phi));
    return vec({r * std::sin(phi), r * std::cos(phi)});
  };
  const auto outside = [&](double phi) {
    const Vector x = on_wave(phi);
    return square(x[0] - 0.5) + square(x[1] - 0.5) - 0.5;
  };
  const double first = last_negative(outside, 0.1, 0.0);
  constexpr std::size_t dense = 40001;
  std::vector<Vector> candidates, set;
  for (std::size_t k = 0; k < dense; ++k) {
    candidates.push_back(on_wave(spread(first, pi / 2 - first, k, dense)));
  }
  std::sort(candidates.begin(), candidates.end(), [](const Vector& a, const Vector& b) {
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
  });
  for (const Vector& x : candidates) {
    if (set.empty() || x[1] < set.back()[1]) set.push_back(x);
  }
  return thinned(set, n);
}

/// Weights on the simplex of 2 or 3 objectives: at most n, on a regular triangle of points.
inline std::vector<Vector> simplex(std::size_t n, Eigen::Index n_objectives) {
  std::vector<Vector> weights;
  if (n_objectives == 2) {
    for (std::size_t k = 0; k < n; ++k) {
      const double w = spread(0.0, 1.0, k, n);
      weights.push_back(vec({w, 1.0 - w}));
    }
    return weights;
  }
  int steps = 1;
  while (static_cast<std::size_t>((steps + 2) * (steps + 3) / 2) <= n) ++steps;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      weights.push_back(vec({static_cast<double>(i), static_cast<double>(j),
                             static_cast<double>(steps - i - j)}) /
                        steps);
    }
  }
  return weights;
}

/// f_1 = x_1 ... x_(m-1) (1 + g) / 2, ..., f_m = (1 - x_1) (1 + g) / 2.
inline Vector dtlz1(const Vector& x, Eigen::Index m) {
  double g = 0.0;
  for (const double value : x.tail(x.size() - m + 1)) {
    g += 100.0 * (1.0 + square(value - 0.5) - std::cos(20.0 * pi * (value - 0.5)));
  }
  Vector f(m);
  double product = 0.5 * (1.0 + g);
  for (Eigen::Index j = 0; j < m - 1; ++j) {
    f[m - 1 - j] = product * (1.0 - x[j]);
    product *= x[j];
  }
  f[0] = product;
  return f;
}

/// g = 0, all distance variables 1/2: the simplex sum f = 1/2, on which the constraint of C1-DTLZ1
/// holds (f_m / 0.6 + ... <= sum f / 0.5 = 1).
inline std::vector<Vector> dtlz1_set(std::size_t count, Eigen::Index m, Eigen::Index n) {
  std::vector<Vector> set;
  for (const Vector& weight : simplex(count, m)) {
    Vector x = Vector::Constant(n, 0.5);
    double product = 1.0;
    for (Eigen::Index j = 0; j < m - 1; ++j) {
      const double share = product > 0.0 ? weight[m - 1 - j] / product : 0.0;
      x[j] = std::clamp(1.0 - share, 0.0, 1.0);
      product *= x[j];
    }
    set.push_back(x);
  }
  return set;
}

/// The point at angles x pi / 2 on the sphere of radius 1 + g.
inline Vector dtlz2(const Vector& x, Eigen::Index m) {
  const double g = (x.tail(x.size() - m + 1).array() - 0.5).square().sum();
  Vector f(m);
  double product = 1.0 + g;
  for (Eigen::Index j = 0; j < m - 1; ++j) {
    f[m - 1 - j] = product * std::sin(0.5 * pi * x[j]);
    product *= std::cos(0.5 * pi * x[j]);
  }
  f[0] = product;
  return f;
}

/// How far outside the nearest of the balls around the corners (1, 0, ...), ... and the middle of
/// the unit sphere, as a difference of squares. Radius 0.4 for three objectives as published. For
/// two, where that would leave next to nothing out, BoTorch's: 0.2 at the corners and 0.2 sqrt(2)
/// in the middle (Balandat et al., NeurIPS 2020, its class C2DTLZ2).
inline double c2_distance(const Vector& f) {
  const bool two = f.size() == 2;
  const double corner = two ? 0.04 : 0.16, middle = two ? 0.08 : 0.16;
  double outside =
      (f.array() - 1.0 / std::sqrt(static_cast<double>(f.size()))).square().sum() - middle;
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    outside = std::min(outside, f.squaredNorm() - 2.0 * f[i] + 1.0 - corner);
  }
  return outside;
}

/// The feasible part of the unit sphere. No other point is optimal: from a feasible point the way
/// straight to the origin meets the sphere in a point that dominates it, and that is feasible,
/// since moving to the nearest point of the unit ball brings it nearer to each of the centres.
inline std::vector<Vector> c2_dtlz2_set(std::size_t count, Eigen::Index m, Eigen::Index n) {
  std::vector<Vector> set;
  for (const Vector& weight : simplex(20 * count, m)) {
    const Vector f = weight.normalized();
    Vector x = Vector::Constant(n, 0.5);
    double radius = 1.0;  // of what is left for the first objectives
    for (Eigen::Index j = 0; j < m - 1; ++j) {
      const double sine = radius > 0.0 ? std::clamp(f[m - 1 - j] / radius, 0.0, 1.0) : 0.0;
      x[j] = std::asin(sine) / (0.5 * pi);
      radius = f.head(m - 1 - j).norm();
    }
    if (c2_distance(dtlz2(x, m)) <= 0.0) set.push_back(x);
  }
  return thinned(set, count);
}

inline double zdt_shape(int number, double f1, double g) {
  const double ratio = f1 / g;
  if (number == 1) return 1.0 - std::sqrt(ratio);
  if (number == 2) return 1.0 - ratio * ratio;
  return 1.0 - std::sqrt(ratio) - ratio * std::sin(10.0 * pi * f1);
}

/// g = 1, and all of 0 <= f1 <= 1; of ZDT3 what is not dominated of 100,001 points of it (its five
/// parts end within 1e-5 of where they should).
inline std::vector<Vector> zdt_set(std::size_t n, int number, Eigen::Index n_variables) {
  const std::size_t dense = number == 3 ? 100001 : n;
  std::vector<Vector> set;
  double least = 2.0;
  for (std::size_t k = 0; k < dense; ++k) {
    Vector x = Vector::Zero(n_variables);
    x[0] = spread(0.0, 1.0, k, dense);
    const double f2 = zdt_shape(number, x[0], 1.0);
    if (!(f2 < least)) continue;
    least = f2;
    set.push_back(std::move(x));
  }
  return thinned(set, n);
}

}  // namespace parapet::zoo
