#include "parapet/study/knee.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace parapet::study {
namespace {

using ObjectiveValues = std::vector<double>;  // [n_objectives], to be minimised

double sum(const ObjectiveValues& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Best in objective j; of equal ones the best in all together.
std::size_t end_of(const std::vector<ObjectiveValues>& scaled, std::size_t j) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < scaled.size(); ++k) {
    if (scaled[k][j] < scaled[best][j] ||
        (scaled[k][j] == scaled[best][j] && sum(scaled[k]) < sum(scaled[best]))) {
      best = k;
    }
  }
  return best;
}

/// The normal n with n . end = 1 at every end, if all its components are positive: only then does
/// the plane separate the ideal from the nadir.
bool plane_through(const std::vector<ObjectiveValues>& scaled, const std::vector<std::size_t>& ends,
                   Eigen::VectorXd& normal) {
  const auto m = static_cast<Eigen::Index>(ends.size());
  Eigen::MatrixXd rows(m, m);
  for (Eigen::Index k = 0; k < m; ++k) {
    for (Eigen::Index j = 0; j < m; ++j) {
      rows(k, j) = scaled[ends[static_cast<std::size_t>(k)]][static_cast<std::size_t>(j)];
    }
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(rows);
  if (!lu.isInvertible()) return false;
  normal = lu.solve(Eigen::VectorXd::Ones(m));
  return normal.minCoeff() > 0.0;
}

}  // namespace

ObjectiveValues FrontRange::normalised(const ObjectiveValues& point) const {
  ObjectiveValues scaled(point.size(), 0.0);
  for (std::size_t j = 0; j < point.size(); ++j) {
    const double width = nadir[j] - ideal[j];
    if (width > 0.0) scaled[j] = (point[j] - ideal[j]) / width;
  }
  return scaled;
}

FrontRange range_of(const std::vector<ObjectiveValues>& front) {
  FrontRange range{front.front(), front.front()};
  for (const ObjectiveValues& point : front) {
    for (std::size_t j = 0; j < point.size(); ++j) {
      range.ideal[j] = std::min(range.ideal[j], point[j]);
      range.nadir[j] = std::max(range.nadir[j], point[j]);
    }
  }
  return range;
}

Knee knee_of(const std::vector<ObjectiveValues>& front) {
  const FrontRange range = range_of(front);
  std::vector<ObjectiveValues> scaled;
  for (const ObjectiveValues& point : front) scaled.push_back(range.normalised(point));
  Knee knee;
  for (std::size_t j = 0; j < front.front().size(); ++j) knee.ends.push_back(end_of(scaled, j));
  Eigen::VectorXd normal;
  knee.through_ends = plane_through(scaled, knee.ends, normal);
  for (const ObjectiveValues& point : scaled) {
    if (!knee.through_ends) {
      knee.distance.push_back(1.0 - *std::ranges::max_element(point));
      continue;
    }
    const Eigen::Map<const Eigen::VectorXd> at(point.data(), normal.size());
    knee.distance.push_back((1.0 - normal.dot(at)) / normal.norm());
  }
  return knee;
}

double bulge_of(const Knee& knee) {
  return knee.through_ends ? *std::ranges::max_element(knee.distance) : 0.0;
}

ObjectiveValues largest_objectives(const std::vector<ObjectiveValues>& front) {
  const FrontRange range = range_of(front);
  std::vector<double> largest;
  for (const ObjectiveValues& point : front) {
    const ObjectiveValues scaled = range.normalised(point);
    largest.push_back(*std::ranges::max_element(scaled));
  }
  return largest;
}

std::size_t default_pick(const std::vector<ObjectiveValues>& front) {
  const Knee knee = knee_of(front);
  if (bulge_of(knee) >= least_bulge) {
    return static_cast<std::size_t>(std::ranges::max_element(knee.distance) -
                                    knee.distance.begin());
  }
  const std::vector<double> largest = largest_objectives(front);
  return static_cast<std::size_t>(std::ranges::min_element(largest) - largest.begin());
}

}  // namespace parapet::study
