/// Expected hypervolume improvement averaged over draws of the front, made for many calls.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "box_side.hpp"
#include "infinity.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/normal_tail.hpp"

namespace parapet::acquisition {
namespace {

/// exp(-45) is below half an ulp of one by a factor of 2000: what is so much smaller than a sum
/// cannot change it even as one of a thousand terms.
constexpr double log_negligible = -45.0;

/// Plain arithmetic is trusted above this; far enough from underflow for products of factors.
constexpr double least_plain = 1e-200;

/// Where a bound stands among the sorted limits.
int position_of(const std::vector<double>& limits, double limit) {
  return static_cast<int>(std::lower_bound(limits.begin(), limits.end(), limit) - limits.begin());
}

}  // namespace

NoisyFront::Front::Front(const std::vector<Box>& boxes, std::size_t n_objectives)
    : limits(n_objectives), n_boxes(boxes.size()) {
  sides.resize(boxes.size() * n_objectives);
  for (std::size_t j = 0; j < n_objectives; ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    std::vector<double>& all = limits[j];
    for (const Box& box : boxes) {
      all.push_back(box.lower[column]);
      all.push_back(box.upper[column]);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      sides[b * n_objectives + j] = {position_of(all, boxes[b].lower[column]),
                                     position_of(all, boxes[b].upper[column])};
    }
  }
}

NoisyFront::NoisyFront(const std::vector<Eigen::MatrixXd>& objectives,
                       const std::vector<Eigen::VectorXi>& feasible, const Objectives& reference,
                       const Objectives& ideal)
    : n_objectives_(static_cast<std::size_t>(reference.size())) {
  if (objectives.empty() || objectives.size() != feasible.size()) {
    throw std::invalid_argument(
        "as many draws of objectives as of feasibility are needed, one at "
        "least, not " +
        std::to_string(objectives.size()) + " and " + std::to_string(feasible.size()));
  }
  std::vector<Objectives> points;
  for (std::size_t s = 0; s < objectives.size(); ++s) {
    const Eigen::MatrixXd& y = objectives[s];
    if (y.cols() != reference.size() || feasible[s].size() != y.rows()) {
      throw std::invalid_argument("draw " + std::to_string(s) + " has " + std::to_string(y.cols()) +
                                  " objectives and " + std::to_string(y.rows()) +
                                  " designs instead of " + std::to_string(reference.size()) +
                                  " and " + std::to_string(feasible[s].size()));
    }
    points.clear();
    for (Eigen::Index i = 0; i < y.rows(); ++i) {
      if (feasible[s][i] != 0) points.emplace_back(y.row(i).transpose());
    }
    any_feasible_ = any_feasible_ || !points.empty();
    fronts_.emplace_back(undominated_boxes(points, reference, ideal), n_objectives_);
    for (const auto& limits : fronts_.back().limits) {
      most_limits_ = std::max(most_limits_, limits.size());
    }
  }
}

/// Expected hypervolume improvement in plain arithmetic, correct where it does not underflow.
/// Each E[(z - y)+] is (z - mean)+ and a tail sd phi(t) q(|t|), t = (z - mean) / sd; the two are
/// kept apart so that the difference of two limits keeps its digits.
double NoisyFront::plain_improvement(const Front& front, const double* mean, const double* sd,
                                     std::vector<Excess>& excess) const {
  const math::ExcessFactor& q = math::excess_factor();
  for (std::size_t j = 0; j < n_objectives_; ++j) {
    const double inverse_sd = 1.0 / sd[j], scale = sd[j] * math::inverse_sqrt_two_pi;
    Excess* e = &excess[j * most_limits_];
    for (const double limit : front.limits[j]) {
      const double x = limit - mean[j], t = x * inverse_sd;
      // The tail underflows below, and above it is lost against the straight part.
      const bool tail = sd[j] > 0.0 && t > -38.0 && t < 9.0;
      *e++ = {std::max(0.0, x), tail ? scale * std::exp(-0.5 * t * t) * q(std::abs(t)) : 0.0};
    }
  }
  double sum = 0.0;
  const Side* side = front.sides.data();
  for (std::size_t b = 0; b < front.n_boxes; ++b) {
    double share = 1.0;
    for (std::size_t j = 0; j < n_objectives_; ++j, ++side) {
      const Excess& above = excess[j * most_limits_ + static_cast<std::size_t>(side->upper)];
      const Excess& below = excess[j * most_limits_ + static_cast<std::size_t>(side->lower)];
      share *= std::max(0.0, (above.straight - below.straight) + (above.tail - below.tail));
    }
    sum += share;
  }
  return sum;
}

/// The same in log space. E[(upper - y)+] bounds a side from above, which settles most boxes.
double NoisyFront::log_improvement_of(const Front& front, const double* mean, const double* sd,
                                      std::vector<Excess>& excess) const {
  for (std::size_t j = 0; j < n_objectives_; ++j) {
    Excess* e = &excess[j * most_limits_];
    for (const double limit : front.limits[j]) {
      (e++)->straight = log_expected_excess(limit - mean[j], sd[j]);
    }
  }
  const auto bound = [&](std::size_t b) {
    double sum = 0.0;
    for (std::size_t j = 0; j < n_objectives_; ++j) {
      const auto upper = static_cast<std::size_t>(front.sides[b * n_objectives_ + j].upper);
      sum += excess[j * most_limits_ + upper].straight;
    }
    return sum;
  };
  const auto log_share = [&](std::size_t b) {
    double sum = 0.0;
    for (std::size_t j = 0; j < n_objectives_; ++j) {
      const Side& side = front.sides[b * n_objectives_ + j];
      sum += log_box_side(front.limits[j][static_cast<std::size_t>(side.lower)],
                          front.limits[j][static_cast<std::size_t>(side.upper)], mean[j], sd[j]);
    }
    return sum;
  };
  LogAdder sum;
  for (std::size_t b = 0; b < front.n_boxes; ++b) {
    if (bound(b) - sum.greatest() >= log_negligible) sum.add(log_share(b));
  }
  return sum.total();
}

double NoisyFront::log_improvement(const Eigen::MatrixXd& means, const Objectives& sd,
                                   const Eigen::VectorXd& log_feasible) const {
  math::check_objectives("the standard deviation", sd, static_cast<Eigen::Index>(n_objectives_));
  if (log_feasible.size() != n_samples()) {
    throw std::invalid_argument("feasibility is needed as one value for each of " +
                                std::to_string(n_samples()) + " draws");
  }
  return log_improvement_by_draw(means, sd.transpose().replicate(n_samples(), 1), log_feasible);
}

double NoisyFront::log_improvement_by_draw(const Eigen::MatrixXd& means,
                                           const Eigen::MatrixXd& deviations,
                                           const Eigen::VectorXd& log_feasible) const {
  const auto m = static_cast<Eigen::Index>(n_objectives_);
  const Eigen::Index draws = log_feasible.size();
  const auto fits = [&](const Eigen::MatrixXd& one) {
    return one.rows() == draws && one.cols() == m;
  };
  if (!fits(means) || !fits(deviations) || draws < 1 || draws > n_samples()) {
    throw std::invalid_argument("means are needed as " + std::to_string(n_samples()) + " x " +
                                std::to_string(m) + ", feasibility as one value per draw");
  }
  if (means.hasNaN() || log_feasible.hasNaN() || !(deviations.array() >= 0.0).all()) {
    throw std::invalid_argument(
        "means or feasibility are not numbers, or a standard deviation is "
        "not zero or more");
  }
  std::vector<Excess> excess(n_objectives_ * most_limits_);
  std::vector<double> mean(n_objectives_), sd(n_objectives_);
  const auto take = [&](Eigen::Index s) {
    for (Eigen::Index j = 0; j < m; ++j) {
      mean[static_cast<std::size_t>(j)] = means(s, j);
      sd[static_cast<std::size_t>(j)] = deviations(s, j);
    }
  };
  Eigen::VectorXd log_terms(draws);
  double greatest = -infinity;
  for (Eigen::Index s = 0; s < draws; ++s) {
    log_terms[s] = -infinity;
    if (log_feasible[s] == -infinity) continue;
    take(s);
    const double plain =
        plain_improvement(fronts_[static_cast<std::size_t>(s)], mean.data(), sd.data(), excess);
    if (!(plain > least_plain)) continue;
    log_terms[s] = std::log(plain) + log_feasible[s];
    greatest = std::max(greatest, log_terms[s]);
  }
  for (Eigen::Index s = 0; s < draws; ++s) {
    // What plain arithmetic did not reach, where it can still matter.
    if (log_terms[s] > -infinity || log_feasible[s] == -infinity) continue;
    if (std::log(2.0 * least_plain) + log_feasible[s] - greatest < log_negligible) continue;
    take(s);
    log_terms[s] = log_feasible[s] + log_improvement_of(fronts_[static_cast<std::size_t>(s)],
                                                        mean.data(), sd.data(), excess);
  }
  return log_mean(log_terms);
}

}  // namespace parapet::acquisition
