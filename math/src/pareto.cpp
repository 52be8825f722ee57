#include "parapet/math/pareto.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace parapet::math {
namespace {

using Rows = std::vector<std::vector<double>>;

/// At least as good everywhere, in the first m objectives.
bool covers(const std::vector<double>& a, const std::vector<double>& b, std::size_t m) {
  for (std::size_t j = 0; j < m; ++j) {
    if (!(a[j] <= b[j])) return false;
  }
  return true;
}

/// Area below the reference of points sorted by the first objective.
double area(Rows& points, const Objectives& reference) {
  std::sort(points.begin(), points.end());
  double sum = 0.0, floor = reference[1];
  for (const auto& p : points) {
    if (!(p[1] < floor)) continue;
    sum += (reference[0] - p[0]) * (floor - p[1]);
    floor = p[1];
  }
  return sum;
}

/// Keeps the points that no other one covers in the first m objectives.
void keep_non_dominated(Rows& points, std::size_t m) {
  Rows kept;
  for (auto& p : points) {
    if (std::any_of(kept.begin(), kept.end(), [&](const auto& q) { return covers(q, p, m); })) {
      continue;
    }
    std::erase_if(kept, [&](const auto& q) { return covers(p, q, m); });
    kept.push_back(std::move(p));
  }
  points = std::move(kept);
}

/// Hypervolume in the first m objectives of points that are better than the reference in all: the
/// sum of what each point dominates and none of those after it does. Sorted by the last objective,
/// worst first, all of that lies above the point in this objective, which leaves m - 1 of them.
double volume(Rows points, const Objectives& reference, std::size_t m) {
  if (points.empty()) return 0.0;
  if (m == 1) {
    double best = points.front()[0];
    for (const auto& p : points) best = std::min(best, p[0]);
    return reference[0] - best;
  }
  if (m == 2) return area(points, reference);
  keep_non_dominated(points, m);
  const std::size_t last = m - 1;
  std::sort(points.begin(), points.end(), [last](const auto& a, const auto& b) {
    return a[last] != b[last] ? a[last] > b[last] : a < b;
  });
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    double inclusive = 1.0;
    for (std::size_t j = 0; j < last; ++j) {
      inclusive *= reference[static_cast<Eigen::Index>(j)] - p[j];
    }
    Rows limited(points.begin() + static_cast<Rows::difference_type>(i) + 1, points.end());
    for (auto& q : limited) {
      for (std::size_t j = 0; j < last; ++j) q[j] = std::max(q[j], p[j]);
    }
    const double exclusive = inclusive - volume(std::move(limited), reference, last);
    sum += (reference[static_cast<Eigen::Index>(last)] - p[last]) * exclusive;
  }
  return sum;
}

}  // namespace

bool dominates(const Objectives& a, const Objectives& b) {
  check_objectives("an objective vector", b, a.size());
  return (a.array() <= b.array()).all() && (a.array() < b.array()).any();
}

std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool beaten = false;
    for (std::size_t k = 0; k < points.size() && !beaten; ++k) {
      beaten = dominates(points[k], points[i]) || (k < i && points[k] == points[i]);
    }
    if (!beaten) indices.push_back(i);
  }
  return indices;
}

bool enter_front(std::vector<Objectives>& front, const Objectives& point) {
  for (const Objectives& p : front) {
    check_objectives("a point of the front", p, point.size());
    if ((p.array() <= point.array()).all()) return false;
  }
  std::erase_if(front, [&](const Objectives& p) { return dominates(point, p); });
  front.push_back(point);
  return true;
}

double hypervolume(const std::vector<Objectives>& points, const Objectives& reference) {
  check_objectives("the reference point", reference, std::max<Eigen::Index>(1, reference.size()));
  Rows better;
  for (const Objectives& p : points) {
    check_objectives("a point of the front", p, reference.size());
    if ((p.array() < reference.array()).all()) better.emplace_back(p.begin(), p.end());
  }
  return volume(std::move(better), reference, static_cast<std::size_t>(reference.size()));
}

void check_objectives(const char* what, const Objectives& v, Eigen::Index n) {
  if (v.size() == n) return;
  throw std::invalid_argument(std::string(what) + " has " + std::to_string(v.size()) +
                              " objectives instead of " + std::to_string(n));
}

}  // namespace parapet::math
