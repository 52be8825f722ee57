#include "parapet/acquisition/improvement.hpp"

#include <algorithm>
#include <cmath>

#include "box_side.hpp"
#include "infinity.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/math/normal_tail.hpp"

namespace parapet::acquisition {
namespace {

/// log of the integral of Phi over an interval of width w around t by the midpoint rule with its
/// second-order term, for a width that is small against 1 and 1 / |t|.
double log_thin_side(double t, double w) {
  double slope = 0.0;  // Phi''(t) / Phi(t) = -t phi(t) / Phi(t)
  if (t > -1.0) {
    slope = -t * math::inverse_sqrt_two_pi * std::exp(-0.5 * t * t - math::log_normal_cdf(t));
  } else {
    slope = t * t / (1.0 - math::excess_factor()(-t));
  }
  return math::log_normal_cdf(t) + std::log(w) + std::log1p(slope * w * w / 24.0);
}

}  // namespace

double log_box_side(double lower, double upper, double mean, double sd) {
  if (sd == 0.0) return std::log(std::max(0.0, upper - std::max(lower, mean)));
  if (lower == -infinity) return log_expected_excess(upper - mean, sd);
  const double t_lower = (lower - mean) / sd, t_upper = (upper - mean) / sd;
  const double width = (upper - lower) / sd;
  if (width * std::max(1.0, -t_lower) < 2e-3) {
    // Here the terms left out, (width t)^4 / 1920, and the digits that the differences below lose
    // are both near 1e-14.
    return std::log(sd) + log_thin_side(t_upper - 0.5 * width, width);
  }
  const math::ExcessFactor& q = math::excess_factor();
  if (t_upper <= 0.0) {
    // Both in the lower tail: the density at the upper end is taken out.
    const double decay = std::exp(0.5 * width * (t_lower + t_upper));
    return std::log(sd) - 0.5 * t_upper * t_upper - math::log_sqrt_two_pi +
           std::log(q(-t_upper) - q(-t_lower) * decay);
  }
  const auto tail = [&](double t) {
    return math::inverse_sqrt_two_pi * std::exp(-0.5 * t * t) * q(std::abs(t));
  };
  const double straight = t_lower > 0.0 ? upper - lower : upper - mean;
  return std::log(straight + sd * (tail(t_upper) - tail(t_lower)));
}

void LogAdder::add(double log_term) {
  if (log_term <= greatest_) {
    if (log_term > -infinity) sum_ += std::exp(log_term - greatest_);
    return;
  }
  sum_ = 1.0 + (sum_ > 0.0 ? sum_ * std::exp(greatest_ - log_term) : 0.0);
  greatest_ = log_term;
}

double LogAdder::total() const {
  return sum_ > 0.0 ? greatest_ + std::log(sum_) : greatest_;
}

double log_ehvi(const std::vector<Box>& boxes, const Objectives& mean, const Objectives& sd) {
  math::check_objectives("the standard deviation", sd, mean.size());
  LogAdder sum;
  for (const Box& box : boxes) {
    math::check_objectives("a box", box.lower, mean.size());
    double log_share = 0.0;
    for (Eigen::Index j = 0; j < mean.size(); ++j) {
      log_share += log_box_side(box.lower[j], box.upper[j], mean[j], sd[j]);
    }
    sum.add(log_share);
  }
  return sum.total();
}

}  // namespace parapet::acquisition
